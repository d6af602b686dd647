"""Mistakes in the digits of scenes, and in what is said where no orbit is, or not one alone."""

from ..mutant import Mutant

BALLS = ("tests/precision/test_balls.py",)
DIGITS = ("tests/precision/test_digits_of_scenes.py",)
NONE = ("tests/scenes/test_existence.py",)
MANY = ("tests/stability/test_continuum.py",)
SHOWN = ("tests/cli_scenes/test_scene_digits.py",)
NAMED = ("tests/scene/test_extremes_named.py",)


def precise(what: str, file: str, old: str, new: str, tests: tuple[str, ...]) -> Mutant:
    """Return a mistake in what is computed in balls."""
    return Mutant(what, f"solver/precision/{file}", old, new, tests)


def flow(what: str, file: str, old: str, new: str, tests: tuple[str, ...]) -> Mutant:
    """Return a mistake in the exact equations and what is known of their solutions."""
    return Mutant(what, f"solver/flow/{file}", old, new, tests)


MUTANTS: tuple[Mutant, ...] = (
    precise(
        "fractions in ball arithmetic are those of float64",
        "balls.py",
        "return arb(fmpq(above, below))",
        "return arb(above / below)",
        BALLS,
    ),
    precise(
        "a restitution in balls is of the velocity behind",
        "exact_balls.py",
        "sign * (arb(phase.rho) * end[1] + arb(phase.d))",
        "sign * (end[1] + arb(phase.d))",
        DIGITS,
    ),
    precise(
        "a wide ball counts as digits",
        "refine.py",
        "if not rounding < goal / 10:",
        "if False:",
        BALLS,
    ),
    precise(
        "steps that get longer are gone on with",
        "refine.py",
        "if not length < 4 * shortest:",
        "if False:",
        BALLS,
    ),
    precise(
        "the phase of the forcing is not a time in the condition of an orbit",
        "condition.py",
        "moved_by = np.abs(kernel.times(by_parameters)).sum(axis=1)",
        "moved_by = np.abs(kernel.times(by_parameters)).sum(axis=1) * 0.5",
        DIGITS,
    ),
    precise(
        "what the orbit loses is not taken off",
        "digits.py",
        "return TARGET * max(1.0, self.orbit_condition or 1.0)",
        "return TARGET",
        DIGITS,
    ),
    precise(
        "every loss is explained",
        "digits.py",
        "return self.met is False and not self.conditioned",
        "return False",
        DIGITS,
    ),
    flow(
        "the event at the end of a phase as a difference of large numbers",
        "exact_system.py",
        "R[2 * count + p] = at_start + (ex * dx + ev * dv + ec * turned)",
        "R[2 * count + p] = ex * x + ev * v + ec * math.cos(angle + 2 * half) + e0",
        DIGITS,
    ),
    flow(
        "the change of the velocity without its own digits",
        "flow.py",
        "v = (np.expm1(large * t) + small * impulse).real * start[1]",
        "v = (np.exp(large * t) + small * impulse - 1).real * start[1]",
        DIGITS,
    ),
    flow(
        "rows that depend on each other always have a solution",
        "one_phase.py",
        "if np.abs(A @ particular - b).max() > ROUNDING:",
        "if False:",
        NONE,
    ),
    flow(
        "the other root of the circle is the same",
        "one_phase.py",
        "at = (large / a, c / large if large else 0.0)",
        "at = (large / a, large / a)",
        NONE,
    ),
    flow(
        "a motion that leaves its phase is one without switches",
        "existence.py",
        "if not phase.demands or min(least(form) for _, form in phase.demands) < 0:",
        "if not phase.demands:",
        NONE,
    ),
    flow(
        "an orbit that is found again counts as another one",
        "continuum.py",
        "np.abs(other - found).max() > np.abs(away).max() / 2",
        "np.abs(other - found).max() >= 0",
        MANY,
    ),
    flow(
        "the mirror image keeps the sign of its constant force",
        "continuum.py",
        "phase, f=-phase.f, speed=-phase.speed",
        "phase, f=phase.f, speed=-phase.speed",
        MANY,
    ),
    Mutant(
        "an extreme may set a parameter beyond its bounds",
        "codegen/scene/extremes.py",
        "if at_defaults.imag or not within(of_symbol[symbol], at_defaults.real):",
        "if at_defaults.imag:",
        NAMED,
    ),
    Mutant(
        "digits that are lost are not marked",
        "src/nonsmooth/cli/scenes/shown/digits.py",
        'mark = LOST if kept.lost else "" if kept.met else CONDITIONED',
        'mark = "" if kept.met else CONDITIONED',
        SHOWN,
    ),
    Mutant(
        "the picture of digits has its words upside down",
        "src/nonsmooth/cli/scenes/shown/digits_picture.py",
        'rows = [extreme or "as given" for extreme in extremes]',
        'rows = [extreme or "as given" for extreme in extremes[::-1]]',
        SHOWN,
    ),
)
