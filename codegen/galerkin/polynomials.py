"""A motion that is a polynomial on each phase, of class C^k at the switches.

Input of `derive`: a scene, the test functions of an expansion, and the polynomials that are
orthogonal to these.  Output: the conditions.  The acceleration of a phase is a series of
shifted Legendre polynomials, so the derivative of order k + 1 has degree N, as in (15) of the
paper.

A residual that is orthogonal to all test functions is a combination of the polynomials that are
(the tau method of Lanczos).  So each condition says that a Legendre coefficient of the residual
is that of this combination: rows of few entries, whatever the test functions.
"""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from itertools import combinations, islice

import sympy as sp

from ..scene import Phase, Scene, Switch, linear_phase, switches
from . import closure
from .condition import Block, Condition, GalerkinConditions, N, Times
from .legendre import Moments, PhaseSeries, l

#: ``test(l, k)``: the test function of index l on a phase that begins C^k, as weights of
#: shifted Legendre polynomials by their degree.
Test = Callable[[sp.Expr, int], Mapping[sp.Expr, sp.Expr]]

#: ``rest(m, l, k)``: the weight of ``P_l*``, l at most m, in the polynomial of degree m that is
#: orthogonal to all test functions of index below m.
Rest = Callable[[sp.Expr, sp.Expr, int], sp.Expr]

#: Highest degree up to which orthogonality to the tests is checked.
CHECKED = 4

#: Highest class of the trial functions.  Where nothing jumps, any class would do.
SMOOTHEST = 4

#: Degrees of the residual with terms of the state at the begin of the phase.
STATE = 2


def trial_switches(scene: Scene) -> tuple[Switch, ...]:
    """Return the switches of a cell, each of the class that the trial functions have there."""
    return tuple(replace(q, k=min(q.k, SMOOTHEST)) for q in switches(scene))


def series(
    scene: Scene, times: Times, cell_switches: tuple[Switch, ...]
) -> tuple[PhaseSeries, ...]:
    """Return the trial function on each phase: ``N + k`` coefficients of the acceleration."""
    trial = []
    for phase, duration, switch in zip(
        scene.phases, times.durations, cell_switches, strict=True
    ):
        held = phase.held is not None
        trial.append(
            PhaseSeries(
                duration,
                sp.Symbol(f"x_{phase.name}", real=True),
                sp.Symbol(f"v_{phase.name}", real=True),
                None if held else sp.IndexedBase(f"d_{phase.name}", real=True),
                sp.Integer(0) if held else N + switch.k,
            )
        )
    return tuple(trial)


def blocks(
    scene: Scene, trial: tuple[PhaseSeries, ...], left: Mapping[str, tuple[sp.Symbol, ...]]
) -> Iterator[Block]:
    """Yield the unknowns of each phase: begin, acceleration, polynomials that no test sees."""
    one = sp.Integer(1)
    for phase, q in zip(scene.phases, trial, strict=True):
        yield Block(q.displacement, one, f"displacement where {phase.name} begins")
        yield Block(q.velocity, one, f"velocity where {phase.name} begins")
        if q.acceleration is not None:
            what = f"acceleration of {phase.name} in Legendre polynomials"
            yield Block(q.acceleration, q.count, what)
        for tau in left.get(phase.name, ()):
            yield Block(tau, one, f"of what no test sees of the residual of {phase.name}")


def moments(scene: Scene, times: Times) -> Iterator[Moments]:
    """Yield the moments of the forcing on each free phase that it acts on."""
    for p, phase in enumerate(scene.cell):
        if phase.held is None and linear_phase(phase).g != 0:
            kappa, theta = times.frequency * times.durations[p], times.angle(times.start(p))
            yield Moments(of_forcing(phase), sp.IndexedBase(f"nu_{phase.name}"), kappa, theta)


def of_forcing(phase: Phase) -> sp.IndexedBase:
    """Return the symbol of the moments of the forcing on a phase."""
    return sp.IndexedBase(f"mu_{phase.name}")


def rows_of(q: PhaseSeries, switch: Switch) -> sp.Expr:
    """Return the number of test functions of a phase."""
    return q.count + 1 - max(1, switch.k)


def rest_of(phase: Phase, switch: Switch, test: Test) -> tuple[sp.Symbol, ...]:
    """Return the coefficients of the polynomials orthogonal to all tests of a phase.

    Their number is `reach`; polynomials of a degree above that of all tests are not counted.
    """
    count = reach(test, switch.k)
    return tuple(sp.Symbol(f"tau{i}_{phase.name}", real=True) for i in range(count))


def reach(test: Test, k: int) -> int:
    """Return the degree of a test function less its index."""
    return max(int(degree - l) for degree in test(l, k))


def check_rest(test: Test, rest: Rest | None, k: int) -> None:
    """Check that the polynomials `rest` are orthogonal to the tests, up to degree `CHECKED`.

    Raises
    ------
    ValueError
        If they are not, or if they are missing though `reach` is not 0.
    """
    if rest is None:
        if reach(test, k):
            raise ValueError(f"rest: got none, and a test of C^{k} reaches beyond its index")
        return
    for m, index in combinations(map(sp.Integer, reversed(range(CHECKED + 1))), 2):
        product = sp.Add(
            *(
                weight * rest(m, degree, k) / (2 * degree + 1)
                for degree, weight in test(index, k).items()
                if degree <= m
            )
        )
        if product != 0:
            raise ValueError(f"test {index} sees the polynomial of degree {m} at class C^{k}")


def orthogonality(
    phase: Phase, q: PhaseSeries, switch: Switch, test: Test, rest: Rest | None
) -> Iterator[Condition]:
    """Yield the conditions that the residual of a phase is orthogonal to all tests."""
    equation = linear_phase(phase)
    rows = rows_of(q, switch)
    taus = rest_of(phase, switch, test) if rest else ()

    def row(index: sp.Expr, first: int = 0) -> sp.Expr:
        residual = q.residual(equation, index, of_forcing(phase)[index])
        if rest is None:
            return residual
        unseen = (tau * rest(rows + i, index, switch.k) for i, tau in enumerate(taus))
        return residual - equation.m * sp.Add(*islice(unseen, first, None))

    part = "less what no test sees, degree" if taus else "orthogonal to its test function"
    title = f"residual of {phase.name}, {part}"
    for index in range(STATE):
        yield Condition(f"{phase.name}_by_{index}", f"{title} {index}", row(sp.Integer(index)))
    yield Condition(
        f"{phase.name}_by_l",
        f"{title} l",
        row(l),
        index=l,
        first=sp.Integer(STATE),
        count=rows - STATE,
    )
    for i in range(len(taus)):
        yield Condition(f"{phase.name}_rest_{i}", f"{title} {rows + i}", row(rows + i, i))


def _events(
    scene: Scene, times: Times, start: closure.End, end: closure.End, symmetric: bool
) -> Iterator[Condition]:
    """Yield the events: without forcing in the state after the switch, which they prescribe.

    If the tests are not `symmetric` in time, the start of the scene, if any, replaces the first
    event.  With forcing, events are in the state before the switch: searches from rough times,
    at which states are fitted first, then take half the iterations.
    """
    if times.frequency is not None:
        yield from closure.events(scene, times, end)
        return
    begins = () if symmetric else tuple(closure.begins(scene, start))
    yield from begins
    yield from tuple(closure.events_after(scene, times, start, end))[len(begins) :]


def derive(
    scene: Scene, method: str, title: str, test: Test, rest: Rest | None = None
) -> GalerkinConditions:
    """Return the conditions of a scene in an expansion.

    Parameters
    ----------
    scene : Scene
    method, title : str
        Name of the expansion, and its description.
    test : callable
        The test functions of the residual.
    rest : callable, optional
        The polynomials orthogonal to these; by default those of high degree.

    Raises
    ------
    ValueError
        If `rest` is not orthogonal to the tests; see `check_rest`.
    """
    times, cell_switches = Times.of(scene), trial_switches(scene)
    for switch in cell_switches:
        check_rest(test, rest, switch.k)
    trial = series(scene, times, cell_switches)
    rows = [
        condition
        for phase, q, switch in zip(scene.cell, trial, cell_switches, strict=True)
        if phase.held is None
        for condition in orthogonality(phase, q, switch, test, rest)
    ]

    def start(p: int, order: int) -> sp.Expr:
        return trial[p].at_start(order)

    def end(p: int, order: int) -> sp.Expr:
        return trial[p].at_end(order)

    free = [p for p in zip(scene.phases, cell_switches, strict=True) if p[0].held is None]
    taus = {phase.name: rest_of(phase, switch, test) for phase, switch in free if rest}
    joined = closure.joints(scene, cell_switches, start, end)
    events = _events(scene, times, start, end, symmetric=rest is None)
    memory = closure.memory(scene, times, start)
    return GalerkinConditions(
        scene,
        method,
        title,
        (*blocks(scene, trial, taus), *closure.memory_blocks(scene)),
        times,
        (*rows, *joined, *events, *memory, *closure.period(times)),
    )
