"""Find the orbit of one method and order, or say why there is none."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from . import c1_roots, kernels
from .admissible import violations
from .arrays import Matrix, Vector
from .belt import StickSlip
from .kernels import Kernel
from .methods import Method, check_method, check_order
from .newton import Outcome, newton
from .orbit import Orbit
from .start import rough_times, with_coefficients

#: Where the rough start converges at every order: continuation in alpha begins here.
EASY_ALPHA = 1.0

#: Largest and smallest factor between two values of alpha in continuation.
LONGEST_STRIDE, SHORTEST_STRIDE = 2.0, 1.02

#: Up to this order one orbit in plain Python is quicker than starting numba.
PLAIN_ORDER = 48


class NoOrbit(Exception):  # noqa: N818  (a finding about the oscillator, not a fault)
    """There is no orbit of this method at this order, or none was found.

    Parameters
    ----------
    reason : str
        What was found, in words.
    proven : bool
        Whether it is shown that none exists; else the search was in vain.
    tried : tuple of str
        The starts that were tried, and how each ended.

    Attributes
    ----------
    iterations : int
        Jacobians factorised in the search.
    """

    def __init__(self, reason: str, proven: bool, tried: tuple[str, ...]) -> None:
        super().__init__(reason, proven, tried)
        self.reason = reason
        self.proven = proven
        self.tried = tried
        self.iterations = 0

    def __str__(self) -> str:
        return "; ".join((self.reason, *(f"from {attempt}" for attempt in self.tried)))

    @property
    def status(self) -> str:
        """``"no-orbit"`` if that is shown, else ``"not-converged"``."""
        return "no-orbit" if self.proven else "not-converged"


@dataclass
class Search:
    """One search: the problem, and what has been spent on it."""

    belt: StickSlip
    method: Method
    order: int
    load: Callable[[str], Kernel]
    iterations: int = 0

    def newton(self, alpha: float, start: Vector, kernel: Kernel) -> Outcome:
        """Run Newton's method at `alpha` and count its iterations."""

        def residual(z: Vector, R: Vector) -> None:
            kernel.residual(alpha, z, R)

        def jacobian(z: Vector, J: Matrix) -> None:
            kernel.jacobian(alpha, z, J)

        outcome = newton(residual, jacobian, start)
        self.iterations += outcome.iterations
        return outcome

    def from_times(self, alpha: float, t1: float, T: float, method: str = "") -> Outcome:
        """Start from times alone; the coefficients are those that suit them best."""
        kernel = self.load(method or self.method.name)
        start = with_coefficients(kernel, alpha, self.order, t1, T)
        return self.newton(alpha, start, kernel)


def _from_rough_times(search: Search) -> Outcome:
    return search.from_times(search.belt.alpha, *rough_times(search.belt.alpha))


def _from_fourier(search: Search) -> Outcome:
    """Start 3.2 from the orbit of 3.1, of which it is an extension."""
    alpha = search.belt.alpha
    series = search.from_times(alpha, *rough_times(alpha), method="hb")
    if not series.converged:
        return series
    return search.from_times(alpha, *series.unknowns[-2:])


def _from_easy_alpha(search: Search) -> Outcome:
    """Follow the orbit from `EASY_ALPHA` to the alpha at hand, in strides of alpha."""
    alpha, target = EASY_ALPHA, search.belt.alpha
    outcome = search.from_times(alpha, *rough_times(alpha))
    stride = LONGEST_STRIDE
    while outcome.converged and alpha != target:
        t1, T = outcome.unknowns[-2:]
        ratio = float(np.clip(target / alpha, 1 / stride, stride))
        ahead = search.from_times(alpha * ratio, t1 * ratio, T + t1 * (ratio - 1))
        if ahead.converged and abs(ahead.unknowns[-2] / (t1 * ratio) - 1) < 0.5:
            alpha = target if alpha * ratio == target else alpha * ratio
            alpha = target if abs(alpha / target - 1) < 1e-12 else alpha
            outcome, stride = ahead, min(LONGEST_STRIDE, stride**1.5)
        elif stride > SHORTEST_STRIDE:
            stride = stride**0.5
        else:
            return ahead
    return outcome


def _from_root(search: Search) -> Outcome:
    """Start 3.3 from the admissible one of all its real solutions; see `c1_roots`."""
    order, belt = search.order, search.belt
    try:
        found = c1_roots.solutions(order, belt.alpha)
    except (ArithmeticError, np.linalg.LinAlgError) as error:
        raise NoOrbit(str(error), proven=False, tried=()) from error
    good = [root for root in found if not violations(search.method, order, belt, root)]
    if not good:
        reason = (
            f"all {len(found)} real solutions of (18)-(20) at order {order} and "
            f"alpha = {belt.alpha:.6g} were isolated; none is an orbit"
        )
        raise NoOrbit(reason, proven=True, tried=())
    return search.newton(belt.alpha, good[0], search.load("c1"))


#: What is tried for each method, in this order; where stick is short,
#: ``alpha < 1``, ``g1`` adds little, and 3.1 is a neighbour that 3.2 starts from.
_ROUGH = ("a rough slip duration", _from_rough_times)
_EASY = (f"continuation from alpha = {EASY_ALPHA:g}", _from_easy_alpha)
_SERIES = ("the orbit of 3.1", _from_fourier)
_ROOTS = ("isolation of all real solutions", _from_root)


def _starts(
    method: Method, alpha: float
) -> tuple[tuple[str, Callable[[Search], Outcome]], ...]:
    if method.name == "c1":
        return (_ROUGH, _ROOTS)
    if method.name == "hb":
        return (_ROUGH, _EASY)
    return (_SERIES, _ROUGH, _EASY) if alpha < EASY_ALPHA else (_ROUGH, _SERIES, _EASY)


def _loader(order: int, many: bool) -> Callable[[str], Kernel]:
    return kernels.compiled if many or order > PLAIN_ORDER else kernels.plain


def solve(belt: StickSlip, method: str, order: int, *, many: bool = False) -> Orbit:
    """Return the periodic orbit of `belt` by one method of the paper.

    Parameters
    ----------
    belt : StickSlip
        The oscillator.
    method : {"hb", "hb-c1", "c1"}
        Section 3.1 (Fourier series), 3.2 (with one C1 function), 3.3 (C1 functions).
    order : int
        ``N``, the number of harmonics, or the degree of the polynomial (15).
    many : bool
        Whether more orbits are to follow: compile the kernels.  The result is the same.

    Raises
    ------
    ValueError
        If `method` or `order` is not one that can be computed.
    NoOrbit
        If there is no admissible orbit, or none was found; it says which.

    Examples
    --------
    >>> import nonsmooth as ns
    >>> belt = ns.StickSlip(mass=10, stiffness=1000, belt_speed=1,
    ...                     mu_s=0.5, mu_k=0.25, normal_force=400)
    >>> orbit = ns.solve(belt, method="c1", order=7)
    >>> round(orbit.period, 7), orbit.admissible
    (0.6712384, True)
    """
    chosen = check_method(method)
    search = Search(belt, chosen, check_order(order, chosen), _loader(order, many))
    tried: list[str] = []
    for name, start in _starts(chosen, belt.alpha):
        try:
            outcome = start(search)
        except NoOrbit as finding:
            finding.iterations, finding.tried = search.iterations, tuple(tried)
            raise
        if not outcome.converged:
            tried.append(f"{name}: {outcome.reason}")
            continue
        orbit = Orbit(belt, chosen.name, search.order, outcome, search.iterations)
        if orbit.admissible:
            outcome.unknowns.flags.writeable = False
            return orbit
        tried.append(f"{name}: a solution that is no orbit: {orbit.violations[0]}")
    failure = NoOrbit(f"no orbit of {method} found at order {order}", False, tuple(tried))
    failure.iterations = search.iterations
    raise failure
