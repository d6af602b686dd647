"""Mistakes in simulated motion: when an event happens, what follows it, where it settles."""

from ..mutant import Mutant

LOCATE = ("tests/simulation/test_locate.py",)
CHATTER = ("tests/simulation/test_chatter.py",)
SURFACES = ("tests/simulation/test_integrated.py::test_two_surfaces_are_two_however_near",)
MOTION = ("tests/simulation/test_simulate.py",)
SETTLE = "tests/simulation/test_settle.py"

MUTANTS = (
    Mutant(
        "times are sums in float64",
        "solver/simulation/clock.py",
        "t=self.t + Fraction(s))",
        "t=Fraction(float(self.t) + s))",
        MOTION,
    ),
    Mutant(
        "the angle of the forcing is not reduced by whole turns",
        "solver/simulation/clock.py",
        "return float((self.first + self.omega * self.t) % TURN)",
        "return float(self.first + self.omega * self.t)",
        MOTION,
    ),
    Mutant(
        "two surfaces near each other are taken for one",
        "solver/scenes/mirror.py",
        "<= ROUNDING * np.abs(ratios[0])).all()",
        "<= ROUNDING * np.abs(ratios[0])).any()",
        SURFACES,
    ),
    Mutant(
        "a switch that its event forbids is taken",
        "solver/simulation/machine.py",
        "                if q is not refused\n                and (q is declared",
        "                if (q is declared",
        (f"{SETTLE}::test_a_switch_that_its_event_forbids_is_not_taken",),
    ),
    Mutant(
        "the event of a mirrored phase is not mirrored",
        "solver/scenes/mirror.py",
        "there = phase.with_forms(_mirrored)",
        "there = replace(phase.with_forms(_mirrored), event=phase.event)",
        MOTION,
    ),
    Mutant(
        "the jumps that are left take the time of a mass that gains by them",
        "solver/simulation/chatter.py",
        "left = -2 * v / (a * (1 + rho))",
        "left = -2 * v / (a * (1 - rho))",
        CHATTER,
    ),
    Mutant(
        "short phases are chatter whether they get shorter or not",
        "solver/simulation/chatter.py",
        "return second <= 0.999 * first",
        "return True",
        CHATTER,
    ),
    Mutant(
        "the polynomial is raised by the bound in place of lowered",
        "solver/simulation/locate.py",
        "powers.append(-bound(at, form, most) * scale)",
        "powers.append(bound(at, form, most) * scale)",
        LOCATE,
    ),
    Mutant(
        "negative damping is not bounded",
        "solver/simulation/bounds.py",
        "growth = (-damping + math.hypot(damping, (kappa - stiffness) / math.sqrt(kappa))) / 2",
        "growth = 0.0",
        LOCATE,
    ),
    Mutant(
        "the second half of an interval is looked at first",
        "solver/simulation/zeros.py",
        "        waiting.append((right, start + half, half, depth + 1))\n"
        "        waiting.append((left, start, half, depth + 1))\n",
        "        waiting.append((left, start, half, depth + 1))\n"
        "        waiting.append((right, start + half, half, depth + 1))\n",
        LOCATE,
    ),
    Mutant(
        "the velocity does not jump",
        "solver/simulation/machine.py",
        "v=rho * v + d, surface=known",
        "v=v + d, surface=known",
        MOTION,
    ),
    Mutant(
        "a phase lasts for ever whatever its transient does",
        "solver/simulation/lasting.py",
        " - turning - abs(ex) * far - abs(ev) * fast",
        " - turning",
        (f"{SETTLE}::test_whether_a_phase_lasts_is_decided_at_the_edge",),
    ),
    Mutant(
        "what has not settled is a start",
        "solver/simulation/settle.py",
        "max(abs(one.x - two.x), abs(one.v - two.v)) <= max(near * size, ROUNDING)",
        "True",
        (f"{SETTLE}::test_what_still_decays_has_not_settled",),
    ),
)
