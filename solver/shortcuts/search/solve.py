"""Find the orbit of one method and order, or say why there is none."""

from collections.abc import Callable

from ...compiling import PLAIN_ORDER
from ...no_orbit import NoOrbit
from ..orbit.methods import check_belt, check_method, check_order, with_terms
from ..orbit.orbit import Orbit
from ..orbit.oscillator import StickSlip
from . import kernels
from .kernels import Kernel
from .search import Search, starts


def _loader(order: int, many: bool) -> Callable[[str], Kernel]:
    return kernels.compiled if many or order > PLAIN_ORDER else kernels.quicker


def solve(
    belt: StickSlip,
    method: str | None = None,
    order: int | None = None,
    *,
    c1_terms: int = 1,
    tol: float | None = None,
    tol_acceleration: float | None = None,
    budget: float | None = None,
    many: bool = False,
) -> Orbit:
    """Return the periodic orbit of `belt`: by method and order, or as accurate as asked.

    Parameters
    ----------
    belt : StickSlip
        The oscillator.
    method : {"hb", "hb-c1", "c1"}
        Section 3.1 (Fourier series), 3.2 (with one C1 function), 3.3 (C1 functions).  With
        a tolerance or a budget it may be left out: then the cheapest, or the best, is taken.
    order : int
        ``N``, the number of harmonics, or the degree of the polynomial (15).  A tolerance
        or a budget chooses it, and it is left out.
    c1_terms : int
        C1 functions of ``"hb-c1"``, 1 to 6; the paper has one.  For several, `order` is at
        most 200.
    tol : float, optional
        Largest relative error of the period, as estimated; between 0 and 1.
    tol_acceleration : float, optional
        Largest error (22) of the acceleration, as estimated; between 0 and 1.
    budget : float, optional
        Seconds that one orbit may take: the best that fits, by compiled kernels.  Not beside
        a tolerance.
    many : bool
        Whether to compile the kernels at once, for measurements; without it they are as soon
        as that pays (see `compiling`).  The result is the same.

    Raises
    ------
    TypeError
        If `belt` is not a `StickSlip`.
    ValueError
        If `method`, `order`, `c1_terms`, a tolerance or the budget is not one that can be
        computed, if they exclude each other, or if `alpha` of the oscillator is not from
        1e-8 to 1e8.
    NoOrbit
        If there is no admissible orbit, or none was found; it says which.
    NotCertified
        If no orbit in float64 is as accurate as asked for.
    TooSlow
        If none is computed within the budget.

    Examples
    --------
    >>> import nonsmooth as ns
    >>> belt = ns.StickSlip(mass=10, stiffness=1000, belt_speed=1,
    ...                     mu_s=0.5, mu_k=0.25, normal_force=400)
    >>> orbit = ns.solve(belt, method="c1", order=7)
    >>> round(orbit.period, 7), orbit.admissible
    (0.6712384, True)
    >>> orbit = ns.solve(belt, tol=1e-9)
    >>> orbit.method, orbit.order, orbit.estimate.period < 1e-9
    ('c1', 11, True)
    """
    if any(value is not None for value in (tol, tol_acceleration, budget)):
        if c1_terms != 1:
            raise ValueError(f"c1_terms: got {c1_terms!r} beside a tolerance, expected 1")
        from ..choice.choose import choose  # noqa: PLC0415  (it solves, too)

        return choose(belt, method, order, tol, tol_acceleration, budget, many=many).orbit
    chosen = with_terms(check_method(method), c1_terms)
    check_belt(belt)
    number = check_order(order, chosen)
    search = Search(belt, chosen, number, _loader(number, many))
    tried: list[str] = []
    for name, start in starts(chosen, belt.alpha, search.order):
        try:
            outcome = start(search)
        except NoOrbit as finding:
            finding.iterations, finding.tried = search.iterations, tuple(tried)
            raise
        if not outcome.converged:
            tried.append(f"{name}: {outcome.reason}")
            continue
        orbit = Orbit(
            belt, chosen.name, number, outcome, search.iterations, chosen.c1_terms or 1
        )
        if orbit.admissible:
            outcome.unknowns.flags.writeable = False
            return orbit
        tried.append(f"{name}: a solution that is not an orbit: {orbit.violations[0]}")
    failure = NoOrbit(f"no orbit of {method} found at order {order}", False, tuple(tried))
    failure.iterations = search.iterations
    raise failure
