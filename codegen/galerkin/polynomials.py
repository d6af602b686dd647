"""A motion that is a polynomial on each phase, of class C^k at the switches.

Input: a scene, and the functions that an expansion tests the residual with.
Output: `derive`, the conditions.  The acceleration of a phase is a series of shifted Legendre
polynomials, so the derivative of order k + 1 has degree N, as in (15) of the paper.
"""

from collections.abc import Callable, Iterator, Mapping

import sympy as sp

from ..scene import Phase, Scene, Switch, linear_phase, switches
from . import closure
from .condition import Block, Condition, GalerkinConditions, N
from .legendre import PhaseSeries
from .tables import Table, l, moment_tables
from .times import Times

#: ``test(l, k)``: the test function of index l on a phase that begins C^k, as weights of
#: shifted Legendre polynomials by their degree.
Test = Callable[[sp.Expr, int], Mapping[sp.Expr, sp.Expr]]

#: Degrees of the residual that have terms of their own: the state in which a phase begins.
STATE = 2


def series(scene: Scene, times: Times, found: tuple[Switch, ...]) -> tuple[PhaseSeries, ...]:
    """Return the trial function on each phase: ``N + k`` coefficients of the acceleration."""
    made = []
    for phase, duration, switch in zip(scene.phases, times.durations, found, strict=True):
        held = phase.held is not None
        made.append(
            PhaseSeries(
                duration,
                sp.Symbol(f"x_{phase.name}", real=True),
                sp.Symbol(f"v_{phase.name}", real=True),
                None if held else sp.IndexedBase(f"d_{phase.name}", real=True),
                sp.Integer(0) if held else N + switch.k,
            )
        )
    return tuple(made)


def blocks(scene: Scene, trial: tuple[PhaseSeries, ...]) -> Iterator[Block]:
    """Yield the unknowns of each phase: the state in which it begins, its acceleration."""
    one = sp.Integer(1)
    for phase, q in zip(scene.phases, trial, strict=True):
        yield Block(q.displacement, one, 0, f"displacement where {phase.name} begins")
        yield Block(q.velocity, one, 1, f"velocity where {phase.name} begins")
        if q.acceleration is not None:
            what = f"acceleration of {phase.name} in Legendre polynomials"
            yield Block(q.acceleration, q.count, 2, what)


def tables(scene: Scene, times: Times, extra: int) -> tuple[Table, ...]:
    """Return the moments of the forcing on each free phase, for degrees up to N and `extra`."""
    if times.frequency is None:
        return ()
    found: list[Table] = []
    for p, phase in enumerate(scene.phases):
        if phase.held is None and linear_phase(phase).g != 0:
            kappa = times.frequency * times.durations[p]
            theta = times.angle(times.start(p))
            found += moment_tables(phase.name, kappa, theta, f"N + {extra}")
    return tuple(found)


def moment(found: tuple[Table, ...], phase: Phase, degree: sp.Expr) -> sp.Expr:
    """Return the moment of the forcing with ``P_degree*`` on a phase."""
    base = sp.IndexedBase(f"mu_{phase.name}")
    return base[degree] if any(table.base == base for table in found) else sp.Integer(0)


def orthogonality(
    phase: Phase, q: PhaseSeries, switch: Switch, found: tuple[Table, ...], test: Test
) -> Iterator[Condition]:
    """Yield that the residual of a phase is orthogonal to the test functions."""
    equation = linear_phase(phase)
    rows = q.count + 1 - max(1, switch.k)
    reach = l - min(test(l, switch.k), key=lambda degree: degree - l)
    first = STATE + int(reach)

    def row(index: sp.Expr) -> sp.Expr:
        parts = (
            weight
            * q.residual(equation, degree, moment(found, phase, degree))
            / (2 * degree + 1)
            for degree, weight in test(index, switch.k).items()
        )
        return sp.Add(*parts)

    for index in range(first):
        yield Condition(
            f"{phase.name}_by_{index}",
            f"residual of {phase.name}, orthogonal to its test function {index}",
            row(sp.Integer(index)),
        )
    yield Condition(
        f"{phase.name}_by_l",
        f"residual of {phase.name}, orthogonal to its test function l",
        row(l),
        index=l,
        first=sp.Integer(first),
        count=rows - first,
        where=f"l = {first}, ..., {rows - 1}",
    )


def class_one(
    scene: Scene, found: tuple[Switch, ...], trial: tuple[PhaseSeries, ...], test: Test
) -> closure.Once:
    """Return which unknown vanishes in place of continuity beyond the velocity.

    At order N the accelerations of functions of class C^1 are of degree N, tested to degree N.
    Those of a smoother scene have ``k - 1`` coefficients more and as many tests: so the
    highest of them vanish instead.  That holds if the tests are the same for any class.
    """
    smoother = min(switch.k for switch in found) > 1
    same = all(test(l, switch.k) == test(l, 1) for switch in found)

    def once(p: int, order: int) -> sp.Expr | None:
        q = trial[p]
        if not (smoother and same) or q.acceleration is None:
            return None
        return q.acceleration[q.count - 1 - (found[p].k - order)]

    return once


def _lowest(rows: list[Condition]) -> int:
    """Return the lowest order at which every condition has a row."""
    wanted = [c.count.subs(N, 0) for c in rows if c.index is not None]
    return max(1, *(-int(count) for count in wanted))


def motion(phase: Phase, duration: sp.Symbol) -> str:
    """Return the statement by which a kernel evaluates the motion on a phase."""
    name = phase.name
    state = f"z[at_x_{name}], z[at_v_{name}]"
    family = f"z[at_d_{name}:at_d_{name} + number_d_{name}]"
    series = family if phase.held is None else "z[:0]"
    return f"return phase_motion({state}, {series}, {duration}, u, derivative)"


def _events(
    scene: Scene, times: Times, start: closure.End, end: closure.End
) -> Iterator[Condition]:
    """Yield the events: where nothing forces, of the state after them, which they then give.

    A forced motion is searched for from rough times, one after the other, at which the states
    are fitted to the conditions first.  With events at the ends of the phases that finds an
    orbit in half the iterations.
    """
    if times.frequency is None:
        return closure.events_after(scene, times, start, end)
    return closure.events(scene, times, end)


def derive(scene: Scene, method: str, title: str, test: Test) -> GalerkinConditions:
    """Return the conditions of a scene in this expansion."""
    times, found = Times.of(scene), switches(scene)
    trial = series(scene, times, found)
    highest = max(switch.k for switch in found)
    looked_up = tables(scene, times, 2 * highest + 5)
    rows = [
        condition
        for phase, q, switch in zip(scene.cell, trial, found, strict=True)
        if phase.held is None
        for condition in orthogonality(phase, q, switch, looked_up, test)
    ]

    def start(p: int, order: int) -> sp.Expr:
        return trial[p].at_start(order)

    def end(p: int, order: int) -> sp.Expr:
        return trial[p].at_end(order)

    once = class_one(scene, found, trial, test)
    joined = closure.joints(scene, found, start, end, once)
    events = _events(scene, times, start, end)
    memory = closure.memory(scene, times, start)
    system = GalerkinConditions(
        scene,
        method,
        title,
        (*blocks(scene, trial), *closure.memory_blocks(scene)),
        times,
        (*rows, *joined, *events, *memory, *closure.period(times)),
        looked_up,
        lowest=_lowest(rows),
        motion=motion,
    )
    system.check_count()
    return system
