"""What is not the paper's own: the C1 series with other tests, and the idea in space."""

from dataclasses import asdict, dataclass

from nonsmooth.solver.no_orbit import NoOrbit
from nonsmooth.solver.shortcuts.orbit import exact

from .case import Case
from .words import percent

#: The order at which both are compared: neither is at rounding where stick is not short.
EIGHT = 8

#: Why, wherever the numbers come from.
WHY = (
    "Velocity and displacement at the end of slip are off by an integral: the residual times "
    "the response at the end to a push at each instant. Of that response the tests take away "
    "all that they can represent. All polynomials to degree N represent it as well as the "
    "series represents the motion, so the error is about the square of the residual; functions "
    "that vanish where slip begins cannot, for a push there is felt at the end like any other."
)


def tau_period_error(case: Case, order: int) -> float:
    """Return ``T/T_exact - 1`` of the C1 series with Legendre's polynomials as tests.

    Raises
    ------
    NoOrbit
        If none was found.
    """
    from nonsmooth.solver.case.registry import load  # noqa: PLC0415
    from nonsmooth.solver.solve import solve_case  # noqa: PLC0415

    try:
        orbit = solve_case(load("stick-slip")(**asdict(case.belt)), "ck-tau", order)
    except NoOrbit as missing:
        raise NoOrbit(f"c1-tau leads to no orbit at N = {order}", False, ()) from missing
    T = exact.times(case.alpha)[1] * case.belt.time_unit
    return orbit.period / T - 1


def remark(case: Case) -> str:
    """Return the remark on the page."""
    try:
        theirs = percent(abs(case.period_error("c1", EIGHT)))
        ours = percent(abs(tau_period_error(case, EIGHT)))
        numbers = (
            f"At N = {EIGHT} the period is {theirs} off with its tests and {ours} with these."
        )
    except NoOrbit as missing:
        numbers = f"In this case {missing.reason}."
    return (
        "The three methods are the paper's, and all figures and claims here are about them. "
        "Its C¹ series tests the residual of slip with its own functions, which vanish with "
        "their slopes where slip begins. The same series tested with the Legendre polynomials "
        f"instead is ours, and not in the paper: c1-tau. {numbers} {WHY}"
    )


#: What is shown: the structures that the paper names.
STRUCTURES = (
    "beam-rotational-spring",
    "beam-spring",
    "beam-mass",
    "beam-crack",
    "string-mass",
)

#: Method, order and forced modes of each column.
EXPANSIONS = (("ritz", 16, None), ("ritz-ck", 8, 1), ("ritz-ck", 8, 2), ("ck", 4, None))

#: Relative error of a frequency below which only rounding is seen.
LEAST = 1e-15


@dataclass(frozen=True)
class SpaceRow:
    """One structure: its class, and the error of its lowest frequency by each expansion."""

    title: str
    name: str
    k: int
    errors: tuple[str, ...]


def space_heads() -> tuple[str, ...]:
    """Return the headings of the columns: the expansion and its size."""
    words = {"ritz": "{N} sines", "ck": "Cᵏ functions, N = {N}"}
    forced = "{N} sines, {K} forced mode{s}"
    return tuple(
        words.get(method, forced).format(N=N, K=K, s="s" if K != 1 else "")
        for method, N, K in EXPANSIONS
    )


def space_rows() -> list[SpaceRow]:
    """Return the table of the remark, computed anew."""
    from nonsmooth.solver.space.modes import modes  # noqa: PLC0415

    found = []
    for name in STRUCTURES:
        errors = []
        for method, order, forced in EXPANSIONS:
            expansion = modes(name, method, order, forced, count=1)
            errors.append(_shown(abs(expansion[0].error)))
        structure = expansion.structure
        found.append(SpaceRow(structure.title, name, structure.k, tuple(errors)))
    return found


def _shown(error: float) -> str:
    if error < LEAST:
        return "rounding"
    return f"{error:.1e}" if error < 0.1 else f"{error:.0%}"
