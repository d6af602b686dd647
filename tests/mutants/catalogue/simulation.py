"""Mistakes in simulated motion: events, what follows them, records, the command."""

from ..mutant import Mutant

LOCATE = ("tests/simulation/test_locate.py",)
MOTION = ("tests/simulation/test_simulate.py",)
INTEGRATED = ("tests/simulation/test_integrated.py",)
SETTLE = ("tests/simulation/test_settle.py",)
COMMAND = ("tests/cli_scenes/test_simulate_command.py",)


def mistake(what: str, file: str, old: str, new: str, tests: tuple[str, ...]) -> Mutant:
    """Return a mistake in the simulation."""
    return Mutant(what, f"solver/simulation/{file}", old, new, tests)


MUTANTS: tuple[Mutant, ...] = (
    mistake(
        "two surfaces near each other are taken for one",
        "nodes.py",
        "<= ROUNDING * np.abs(ratios[0])).all()",
        "<= ROUNDING * np.abs(ratios[0])).any()",
        INTEGRATED,
    ),
    mistake(
        "what only touches zero is an event",
        "locate.py",
        "return risen if touches else 0.0",
        "return 0.0",
        LOCATE,
    ),
    mistake(
        "the bound is for a window of half the length",
        "bounds.py",
        "largest = (norm + forced * s)",
        "largest = 0.5 * norm",
        LOCATE,
    ),
    mistake(
        "negative damping is not bounded",
        "bounds.py",
        "growth = (-damping + math.hypot(damping, (kappa - stiffness) / math.sqrt(kappa))) / 2",
        "growth = 0.0",
        LOCATE,
    ),
    mistake(
        "the polynomial is not lowered by the bound",
        "locate.py",
        "powers[TERMS] = -bound(at, form, most) * scale",
        "powers[TERMS] = bound(at, form, most) * scale",
        LOCATE,
    ),
    mistake(
        "the second half of an interval is looked at first",
        "zeros.py",
        "        waiting.append((right @ coefficients, start + half, half, depth + 1))\n"
        "        waiting.append((left @ coefficients, start, half, depth + 1))\n",
        "        waiting.append((left @ coefficients, start, half, depth + 1))\n"
        "        waiting.append((right @ coefficients, start + half, half, depth + 1))\n",
        LOCATE,
    ),
    mistake(
        "any of two events is taken",
        "locate.py",
        "        if safe < step:\n",
        "        if safe < step and nearest is None:\n",
        LOCATE,
    ),
    mistake(
        "a form that begins at zero is its own event",
        "locate.py",
        "leading = _leading(values, sizes, zero)\n    if leading == TERMS or",
        "leading = 0\n    if leading == TERMS or",
        LOCATE,
    ),
    mistake(
        "the impulse is not mirrored",
        "nodes.py",
        "        event=_mirrored(phase.event),\n",
        "        event=phase.event,\n",
        MOTION,
    ),
    mistake(
        "a constraint does not come first",
        "machine.py",
        "yield from (q for q in turn if q.phase.held and q.phase.demands)",
        "yield from ()",
        MOTION,
    ),
    mistake(
        "a phase may be entered with any velocity",
        "machine.py",
        "return abs(state.v - speed) <= NEAR * max(1.0, abs(speed))",
        "return True",
        MOTION,
    ),
    mistake(
        "the law of a stop on the other side is not that of its event",
        "machine.py",
        "for other in (node, *self.nodes):",
        "for other in (node,):",
        MOTION,
    ),
    mistake(
        "chatter goes on",
        "simulate.py",
        "elif accumulates(segments) and",
        "elif False and",
        MOTION,
    ),
    mistake(
        "the velocity does not jump",
        "machine.py",
        "v=rho * v + d, surface=known",
        "v=v + d, surface=known",
        MOTION,
    ),
    mistake(
        "the velocity in units of length",
        "simulate.py",
        "speed / units.of_motion(1), angle)",
        "speed / units.length, angle)",
        MOTION,
    ),
    mistake(
        "times of a cell of another duration",
        "settle.py",
        "whole = not cell.forced or abs(sum(q.s for q in own) - cell.duration) <= NEAR",
        "whole = True",
        SETTLE,
    ),
    mistake(
        "what has not settled is a start",
        "settle.py",
        "max(abs(one.x - two.x), abs(one.v - two.v)) <= max(near * size, ROUNDING)",
        "True",
        SETTLE,
    ),
    Mutant(
        "a motion that ended early is status 0",
        "src/nonsmooth/cli/scenes/simulate.py",
        "return 1 if motion.ended else 0",
        "return 0",
        COMMAND,
    ),
    Mutant(
        "displacement and velocity swapped in a picture",
        "src/nonsmooth/plots/simulations.py",
        "zip(HISTORIES, values, strict=True)",
        'zip(("velocity", "displacement", "acceleration"), values, strict=True)',
        COMMAND,
    ),
)
