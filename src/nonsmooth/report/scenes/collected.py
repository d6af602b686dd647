"""All numbers of the page on one oscillator: orbits, errors, rates, overshoots."""

import math
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass

import numpy as np

from nonsmooth.solver.arrays import Vector
from nonsmooth.solver.exact import ExactOrbit
from nonsmooth.solver.kernels import registry
from nonsmooth.solver.no_orbit import NoOrbit
from nonsmooth.solver.orbit.errors import Errors, derivative
from nonsmooth.solver.orbit.motion import Motion
from nonsmooth.solver.results.orbit import Orbit
from nonsmooth.solver.scenes.case import Case
from nonsmooth.solver.scenes.methods import about, in_order, shown
from nonsmooth.solver.solve import solve_case

#: Order of the orbits that are drawn beside the exact one; of those of Fourier series that show
#: the overshoot.
SMALL, RINGING = 5, 24

#: Orders of the curves of algebraic convergence, spaced geometrically, so that differences
#: between odd and even orders do not spoil the slope; orders of geometric convergence.
POWER_ORDERS, FACTOR_ORDERS = (4, 6, 8, 11, 16, 22, 32), tuple(range(3, 17))

#: The overshoot is looked for within so many half periods of the highest harmonic of a switch.
RING = 6.0


@dataclass(frozen=True)
class Way:
    """A method, with its number of functions at each switch if it has one.

    Parameters
    ----------
    method : str
        Generic name.
    functions : int or None
    name : str
        For readers: with the class, and with the number of functions.
    """

    method: str
    functions: int | None
    name: str


@dataclass(frozen=True)
class Collected:
    """The results on the page of a case.

    Parameters
    ----------
    case : Case
        The oscillator.
    exact : ExactOrbit
        Its exact orbit.
    small : dict of str to Orbit
        Orbits of low order, by the names of their ways.
    ringing : dict of str to Orbit
        Orbits of higher order, for the derivative that jumps.
    curves : dict of Way to dict of int to Errors
        Errors by the order.
    """

    case: Case
    exact: ExactOrbit
    small: dict[str, Orbit]
    ringing: dict[str, Orbit]
    curves: dict[Way, dict[int, Errors]]

    @property
    def beyond(self) -> dict[str, float]:
        """The `overshoot` of each of `ringing` in per cent."""
        return {name: 100 * overshoot(q, self.exact) for name, q in self.ringing.items()}


def ways(case: Case) -> Iterator[Way]:
    """Yield the methods of a scene, each with every number of functions it can have."""
    scene = case.scene
    for method in in_order(registry.methods(scene)):
        numbers = registry.functions(scene, method)
        for number in numbers or (None,):
            suffix = "" if number is None else f", K = {number}"
            yield Way(method, number, shown(scene, method) + suffix)


def steps(case: Case) -> int:
    """Return the number of steps of which `collect` reports progress."""
    return 2 + sum(1 for _ in ways(case))


def collect(case: Case, exact: ExactOrbit, done: Callable[[str], None]) -> Collected:
    """Return the results on the page of a case.

    Parameters
    ----------
    case : Case
        The oscillator.
    exact : ExactOrbit
        Its exact orbit.
    done : callable
        Called `steps` times, with the step just done in words.
    """
    listed = list(ways(case))
    usual = list({way.method: way for way in listed if way.functions in (None, 1, 2)}.values())
    small = {q.name: orbit for q in usual if (orbit := _orbit(case, q, SMALL))}
    done("orbits of low order")
    orders = {q: RINGING if about(q.method).power else SMALL for q in usual}
    ringing = {q.name: orbit for q in usual if (orbit := _orbit(case, q, orders[q]))}
    done("the derivative that jumps")
    curves = {}
    for way in listed:
        powers = about(way.method).power
        curves[way] = curve(case, way, POWER_ORDERS if powers else FACTOR_ORDERS)
        done(way.name)
    return Collected(case, exact, small, ringing, curves)


def _orbit(case: Case, way: Way, order: int) -> Orbit | None:
    try:
        return solve_case(case, way.method, order, way.functions)
    except (NoOrbit, ValueError):  # there is none, or the order is below the lowest
        return None


def curve(case: Case, way: Way, orders: Iterable[int]) -> dict[int, Errors]:
    """Return the errors of a way by the order, of the orders that have an orbit."""
    errors = {order: orbit.errors for order in orders if (orbit := _orbit(case, way, order))}
    return {order: error for order, error in errors.items() if error is not None}


def jump(exact: Motion, p: int) -> float:
    """Return the jump of the derivative of order k + 1 at switch `p`, without units."""
    cell = exact.case.cell
    before, sign = (p - 1, 1) if p else (len(cell.phases) - 1, cell.sign)
    order = cell.k + 1
    left = derivative(exact, before, np.ones(1), order)[0]
    return float(derivative(exact, p, np.zeros(1), order)[0] - sign * left)


def overshoot(orbit: Orbit, exact: Motion) -> float:
    """Return the overshoot of the derivative of order k + 1, relative to its largest jump.

    It is the excess over the exact derivative behind that jump, with the phase mapped onto the
    exact one.  For a Fourier series it tends to 8.949 per cent (Gibbs), for functions that jump
    themselves to 0.
    """
    phases = range(len(exact.case.cell.phases))
    sizes = [jump(exact, p) for p in phases]
    p = int(np.argmax(np.abs(sizes)))
    part = float(np.sum(orbit.cell_durations)) / float(orbit.cell_durations[p])
    reach = min(0.5, RING * part / (2 * orbit.order + 1))
    u: Vector = np.linspace(0.0, reach, 2001)[1:]
    order = exact.case.cell.k + 1
    beyond = derivative(orbit, p, u, order) - derivative(exact, p, u, order)
    return float(np.max(beyond / sizes[p]))


def rate_of_times(case: Case, functions: int) -> int:
    """Return the power of 1/N with which the times of a series with K functions converge.

    It is the least over the switches, each with its own class; K = 0 is a plain Fourier series.
    """
    powers, phases = [], case.cell.phases
    for p, phase in enumerate(phases):
        k = case.scene.classes[(p + 1) % len(phases)]
        by_displacement = phase.event[0] != 0
        smooth = phase.rho == 1 and phase.d == 0
        r = 0 if by_displacement and smooth else 1
        q = k + functions + 2 - r
        powers.append(2 * math.ceil(q / 2) - 1)
    return int(min(powers))


def rate_of_jump(case: Case, functions: int) -> float:
    """Return the power of 1/N with which the derivative of order k + 1 converges in L2."""
    return min(functions + 0.5, float(rate_of_times(case, functions)))
