"""The ways to an orbit: starts for Newton's method, and what to do where they fail."""

from collections.abc import Callable
from contextlib import nullcontext
from dataclasses import dataclass, replace

import numpy as np

from ...arrays import Vector
from ...no_orbit import NoOrbit
from ..orbit.admissible import violations
from ..orbit.methods import METHODS, Method
from ..orbit.oscillator import StickSlip
from ..polynomials import c1_roots
from ..series import newton_krylov
from ..series.fourier import from_symmetric
from ..series.matrix_free import Problem
from . import continuation
from .kernels import Kernel
from .newton import Outcome, newton
from .rounding import first_within_rounding, padded, solve_by_least_norm
from .start import cubic_slip, rough_times, with_coefficients

#: Where the rough start converges at every order: continuation in alpha begins here.
EASY_ALPHA = 1.0

#: Largest and smallest factor between two values of alpha in continuation.
LONGEST_STRIDE, SHORTEST_STRIDE = 2.0, 1.02

#: Harmonics up to which a dense matrix is quicker, the step to fewer of them beyond, and how
#: many of those slip is to have that their orbit be better than the rough start.
MOST_DENSE, LADDER, RESOLVED = 256, 16, 64

#: Largest relative surprise in ``t1`` that a stride may bring.
SAME_ORBIT = 0.5


@dataclass
class Search:
    """One search: the problem, and what has been spent on it."""

    belt: StickSlip
    method: Method
    order: int
    load: Callable[[str], Kernel]
    iterations: int = 0

    def newton(self, kernel: Kernel, case: object, start: Vector) -> Outcome:
        """Run Newton's method from `start` and count its iterations."""
        with nullcontext() if kernel.account is None else kernel.account.spending():
            outcome = newton(kernel.iterate, case, start)
        self.iterations += outcome.iterations
        return outcome

    def from_times(self, alpha: float, t1: float, T: float) -> Outcome:
        """Start from times alone, at any `alpha`."""
        return self.from_times_by(self.method, alpha, t1, T)

    def from_times_by(self, method: Method, alpha: float, t1: float, T: float) -> Outcome:
        """Start another method from times alone."""
        terms, order = method.c1_terms, self.order
        if terms is None:
            kernel = self.load(method.name)
            start = with_coefficients(kernel, alpha, order, t1, T)
            return self.newton(kernel, alpha, start)
        kernel = self.load("hb-symmetric")
        found = self.about_mid_stick(kernel, alpha, terms, order, (t1, T))
        return replace(found, unknowns=from_symmetric(found.unknowns, order))

    def about_mid_stick(
        self, kernel: Kernel, alpha: float, terms: int, order: int, times: tuple[float, float]
    ) -> Outcome:
        """Solve 3.1 or 3.2 about mid-stick: dense, or from fewer harmonics, matrix-free."""
        start = cubic_slip(kernel, terms, order, *times)
        if order <= MOST_DENSE:
            return self.newton(kernel, (alpha, terms), start)
        fewer, (t1, T) = max(MOST_DENSE, order // LADDER), times
        if fewer * (1 - t1 / T) >= RESOLVED:
            coarse = self.about_mid_stick(kernel, alpha, terms, fewer, times)
            if coarse.converged:
                start = np.zeros(len(start))
                start[:fewer], start[order:] = coarse.unknowns[:fewer], coarse.unknowns[fewer:]
        outcome = newton_krylov.solve(Problem(kernel, alpha, terms, order), start)
        self.iterations += outcome.iterations
        return outcome


def _from_rough_times(search: Search) -> Outcome:
    return search.from_times(search.belt.alpha, *rough_times(search.belt.alpha))


def _from_fourier(search: Search) -> Outcome:
    """Start 3.2 from the orbit of 3.1, of which it is an extension."""
    alpha = search.belt.alpha
    series = search.from_times_by(METHODS["hb"], alpha, *rough_times(alpha))
    if not series.converged:
        return series
    return search.from_times(alpha, *series.unknowns[-2:])


def _from_easy_alpha(search: Search) -> Outcome:
    """Follow the orbit from `EASY_ALPHA` to the alpha at hand, in strides of alpha."""
    target = search.belt.alpha
    alpha, stride = EASY_ALPHA, LONGEST_STRIDE
    outcome = search.from_times(alpha, *rough_times(alpha))
    while outcome.converged and alpha != target:
        ahead = min(max(target, alpha / stride), alpha * stride)
        t1, T = outcome.unknowns[-2:]
        longer = t1 * (ahead / alpha)  # stick lasts in proportion to alpha
        trial = search.from_times(ahead, longer, T + longer - t1)
        if trial.converged and abs(trial.unknowns[-2] / longer - 1) < SAME_ORBIT:
            alpha, outcome, stride = ahead, trial, min(LONGEST_STRIDE, stride**1.5)
        elif stride > SHORTEST_STRIDE:
            stride = stride**0.5
        else:
            return trial
    return outcome


def _from_short_stick(search: Search) -> Outcome:
    """Follow the solutions of 3.2 from `EASY_ALPHA` by the duration of stick, round folds."""
    alpha, terms, order = search.belt.alpha, search.method.c1_terms or 0, search.order
    kernel = search.load("hb-symmetric")
    found = search.about_mid_stick(kernel, EASY_ALPHA, terms, order, rough_times(EASY_ALPHA))
    if found.converged:
        near, iterations = continuation.follow(kernel, terms, found.unknowns, alpha)
        search.iterations += iterations
        found = search.newton(kernel, (alpha, terms), near)
    return replace(found, unknowns=from_symmetric(found.unknowns, order))


def _from_fewer_functions(search: Search) -> Outcome:
    """Start 3.2 with one C1 function, and add the others one by one.

    Where stick is very short a function may differ from the others and the harmonics by less
    than rounding: its coefficient is then undetermined, and Newton's method comes to no end.
    What solves the equations but for rounding is an orbit all the same: one with fewer
    functions, whose other coefficients are 0, or where Newton's method left off.
    """
    alpha, terms, order = search.belt.alpha, search.method.c1_terms or 0, search.order
    kernel = search.load("hb-symmetric")
    found = search.about_mid_stick(kernel, alpha, 1, order, rough_times(alpha))
    fewer: list[Outcome] = []
    for number in range(2, terms + 1):
        if not found.converged:
            break
        fewer.append(found)
        case, size = (alpha, number), kernel.size(order, number)
        found = search.newton(kernel, case, padded(found.unknowns, size))
        if not found.converged:
            tried = (fewer[-1], found, *fewer[-2::-1])
            found = first_within_rounding(kernel, case, size, tried) or found
    return replace(found, unknowns=from_symmetric(found.unknowns, order))


def _by_least_norm(search: Search) -> Outcome:
    """Start 3.2 with one C1 function, and add the others at once, by steps of least norm.

    Where stick is far shorter than the shortest wave, rounding hides some functions, but not
    all: with fewer the equations do not hold, and with all Newton's method wanders.
    """
    alpha, terms, order = search.belt.alpha, search.method.c1_terms or 0, search.order
    kernel = search.load("hb-symmetric")
    found = search.about_mid_stick(kernel, alpha, 1, order, rough_times(alpha))
    if found.converged:
        start = padded(found.unknowns, kernel.size(order, terms))
        found = solve_by_least_norm(kernel, (alpha, terms), start)
        search.iterations += found.iterations
    return replace(found, unknowns=from_symmetric(found.unknowns, order))


def _from_root(search: Search) -> Outcome:
    """Start 3.3 from the admissible one of all its real solutions; see `c1_roots`."""
    start = admissible_root(search.belt, search.order)
    return search.newton(search.load("c1"), search.belt.alpha, start)


def admissible_root(belt: StickSlip, order: int) -> Vector:
    """Return the unknowns of 3.3 at the one of all its real solutions that is an orbit.

    Raises
    ------
    NoOrbit
        If none of them is one, which is then proven; or if they cannot be isolated.
    """
    try:
        found = c1_roots.solutions(order, belt.alpha)
    except (ArithmeticError, np.linalg.LinAlgError) as error:
        raise NoOrbit(str(error), proven=False, tried=()) from error
    good = [root for root in found if not violations(METHODS["c1"], order, belt, root)]
    if not good:
        reason = (
            f"all {len(found)} real solutions of (18)-(20) at order {order} and "
            f"alpha = {belt.alpha:.6g} were isolated; none is an orbit"
        )
        raise NoOrbit(reason, proven=True, tried=())
    return good[0]


#: A way to an orbit, and its name.
Start = tuple[str, Callable[[Search], Outcome]]

_ROUGH: Start = ("from the estimated slip duration", _from_rough_times)
_EASY: Start = (f"by continuation from alpha = {EASY_ALPHA:g}", _from_easy_alpha)
_STICK: Start = (f"by continuation of t1 from alpha = {EASY_ALPHA:g}", _from_short_stick)
_SERIES: Start = ("from the orbit of 3.1", _from_fourier)
_FEWER: Start = ("from the orbit with fewer C1 functions", _from_fewer_functions)
_LEAST: Start = ("from the orbit with one C1 function, by steps of least norm", _by_least_norm)
_ROOTS: Start = ("from the isolation of all real solutions", _from_root)


def starts(method: Method, alpha: float, order: int) -> tuple[Start, ...]:
    """Return what is tried for a method, in this order, with its name.

    Very many harmonics resolve the phases; what the rough start does not reach there,
    nothing does.

    Where stick is short, ``alpha < 1``, a C1 function adds little: 3.1, or 3.2 with fewer of
    them, is a neighbour to start from.  From where stick is long and the harmonics are few,
    only the way by ``t1`` leads on.
    """
    if method.name == "c1":
        return (_ROUGH, _ROOTS)
    if order > MOST_DENSE:
        return (_ROUGH,)
    if method.name == "hb":
        return (_ROUGH, _EASY)
    others = (_SERIES,) if method.c1_terms == 1 else (_FEWER, _SERIES)
    first = (*others, _ROUGH) if alpha < EASY_ALPHA else (_ROUGH, *others)
    reached = 1 / continuation.FARTHEST <= alpha <= continuation.FARTHEST
    ways = (*first, _STICK) if reached else first
    return (*ways, _LEAST) if others[0] is _FEWER and alpha < EASY_ALPHA else ways
