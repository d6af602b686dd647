"""The equations of an order of phases along a branch, and what is watched there."""

from collections.abc import Iterable, Sequence
from dataclasses import replace
from itertools import chain
from typing import Any, ClassVar, NamedTuple

import numpy as np

from ..arrays import Integers, Matrix, Vector
from ..bodies.systems import BodyError
from ..flow.exact_system import angles, arrays, phase_numbers, places
from ..flow.flow import state_at
from ..kernels.family import Family
from ..orbit.exact_orbit import ExactOrbit, of_unknowns
from ..rows.joints import F
from ..scenes.case import Case
from ..scenes.cell import Cell, Form, Phase
from ..scenes.mirror import mirror, same
from ..scenes.parameter_error import ParameterError
from ..simulation.nodes import Node, walls
from ..simulation.steps.column import NONE
from . import walk, watch
from .along import (
    Along,
    Content,
    Interval,
    begins_as_set,
    begins_slowly,
    begins_still,
    divided_phases,
    of_speed,
    of_velocity,
    resolved,
    weights,
)
from .orders.itinerary import Itinerary
from .walk import FAMILY
from .watch import AT_SWITCH, BEHIND, START, WITHIN

#: What is rounding of a derivative where a phase begins, as a part of the largest.
ROUNDING = 1e-8

#: Derivatives of a form that are looked at where a phase begins.
HIGHEST = 4


class Row(NamedTuple):
    """One form that is watched: where, which of how many, and what it belongs to.

    Parameters
    ----------
    phase, kind : int
        As in a table of `watch`.
    number : int
        Of the demand of the phase, or of that of the node.
    node : int
        The phase that could hold the motion behind a switch; -1 where it is no such form.
    """

    phase: int
    kind: int
    number: int
    node: int = -1


class Course(Itinerary):
    """An order of phases as branches follow it: its equations, and what is watched."""

    #: Most phases of an order that is followed: near chatter there are ever more.
    most: ClassVar[int] = 40

    #: How the functions of a branch are made.
    family: ClassVar[Family] = FAMILY

    def rows(self, numbers: tuple[float, ...], z: Vector) -> list[Row]:
        """Return what is watched, as it is at an orbit of which nothing is special."""
        cell, found = self.cell(numbers), []
        machine = self.machine(numbers)
        for p, phase in enumerate(cell.phases):
            found += [Row(p, WITHIN, i) for i in range(len(phase.demands))]
            found += [Row(p, AT_SWITCH, i) for i in range(len(phase.switch_demands))]
            v = None if self.endless else self.velocity_behind(cell, z, p)
            for h, node in enumerate(machine.nodes):
                ended = machine.node(self.order.steps[p])
                if v is not None and _may_hold(machine.nodes, ended, h, v):
                    found += [Row(p, BEHIND, i, h) for i in range(len(node.phase.demands))]
        return found

    def velocity_behind(self, cell: Cell, z: Vector, p: int) -> float | None:
        """Return that behind a phase, where another than the next could hold it; else None."""
        q = (p + 1) % len(cell.phases)
        if cell.phases[q].held:
            return None
        v = self.moving_at(self.case_of(cell, []), z, q, 0.0)[1]
        return v * (cell.sign if q == 0 else 1)

    def word(self, row: Row, column: int, begins: int) -> str:
        """Return what it is called where a form that is watched vanishes.

        A rest begins or ends: sticking.  Else a surface is touched: grazing.

        column : int
            Of `watch`: where in the phase.
        begins : int
            The first derivative of the form that is not zero by itself where the phase begins:
            above the first, the phase begins without speed.
        """
        step = self.order.steps[row.phase]
        held = self.base.kinds[step.phase][1]
        still = held or row.kind != WITHIN or self._is_of_velocity(row)
        still = still or (column == START and begins > 1)
        return "sticking" if self.can_rest and still else "grazing"

    def _is_of_velocity(self, row: Row) -> bool:
        """Whether a form is of the velocity, and not of the displacement."""
        return of_velocity(self._generic.phases[row.phase].demands[row.number][1])

    def forms(self, numbers: tuple[float, ...], rows: Sequence[Row], cell: Cell) -> list[Form]:
        """Return the forms of rows, for parameters without units, as `watch` takes them."""
        return self.demanded(numbers, rows, cell)

    def demanded(
        self, numbers: tuple[float, ...], rows: Sequence[Row], cell: Cell
    ) -> list[Form]:
        """Return the forms of rows as cells have them; see `before`."""
        declared = self.declares(numbers)
        found: list[Form] = []
        for row in rows:
            phase = cell.phases[row.phase]
            if row.kind == BEHIND:
                mirrored, p = divmod(row.node, len(declared.phases))
                node = declared.carrying(p)
                found.append(self.before(cell, mirror(node) if mirrored else node, row))
            else:
                demands = phase.demands if row.kind == WITHIN else phase.switch_demands
                found.append(demands[row.number][1])
        return found

    def before(self, cell: Cell, node: Phase, row: Row) -> Form:
        """Return what a phase that could hold the motion behind a switch demands.

        As a form of the state before the switch.
        """
        x, v, cos, constant = node.demands[row.number][1][:4]
        ended = cell.phases[row.phase]
        own = x, v * ended.rho, cos, constant + v * ended.d
        return *own, *[0.0] * len(cell.memory)

    def along(
        self, content: Content, value: float, interval: Interval, z: Vector
    ) -> tuple[Along, Interval]:
        """Return its equations on an interval of a parameter, or on a part of it.

        Parameters
        ----------
        content : callable
            The cell at a value, and the forms that are watched there.
        value : float
            About which the interval is cut where its series do not converge.
        z : ndarray
            The unknowns there: their sizes.
        """
        cell, forms = content(value)
        blocks = self.blocks(cell, forms)

        def values(at: float) -> Vector:
            try:
                found: Vector = self.entries(*content(at))
            except (BodyError, ParameterError):  # no such oscillator
                found = np.empty(0)
            return found if len(found) == len(blocks) else np.full(len(blocks), np.nan)

        series, interval = resolved(values, value, interval, blocks)
        others = (content(at)[0] for at in interval.some())
        return self.framed(cell, z, series, others), interval

    def entries(self, cell: Cell, forms: list[Form]) -> Vector:
        """Return all entries of the arrays of a cell that may vary, the forms behind them."""
        found, rows = arrays(cell), np.array(forms, dtype=float)
        parts = (found.numbers, found.memory, found.cell, rows)
        return np.concatenate([part.ravel() for part in parts])

    def blocks(self, cell: Cell, forms: list[Form]) -> Integers:
        """Return the blocks of these entries, each its own; see `along.resolved`."""
        return np.arange(len(self.entries(cell, forms)))

    def framed(self, cell: Cell, z: Vector, series: Any, others: Iterable[Cell]) -> Along:
        """Return the arrays of a cell by their series.

        `z` are unknowns of the usual sizes, `others` the cell at `Interval.some`.
        """
        found, before = arrays(cell), 2 * len(cell.phases) + len(cell.memory)
        divided, cells = divided_phases(cell, z[before:]), (cell, *others)
        for p in range(len(cell.phases)):
            begins = begins_still if divided[p] else begins_slowly
            if all(begins(each, p) for each in cells):
                slowly = not (divided[p] or of_speed(cell, p))
                divided[p] = 3 if slowly else 2
            elif all(begins_as_set(each, p) for each in cells):
                divided[p] = 2
        given = found.kinds, found.setting, series, divided, weights(cell, z)
        return Along(*given, before, float(cell.sign))

    def by(self, name: str, *arguments: Any) -> Any:
        """Return what a function of a branch makes of arguments; see `Family.call`."""
        with np.errstate(all="ignore"):
            return self.family.call(walk.__name__, name, *arguments)

    @property
    def mapped(self) -> int:
        """How many numbers of a state are perturbed in the maps kept with an orbit."""
        return 2 + len(self._generic.memory)

    def perturbed(self, along: Along) -> int:
        """Return how many numbers of a state are perturbed in any map of its cell."""
        return self.mapped

    def unknowns(self, orbit: ExactOrbit) -> Vector:
        """Return those of an exact orbit, without units."""
        return orbit.outcome.unknowns

    def sizes(self, cell: Cell, case: Case) -> Vector:
        """Return what 1 of each unknown of a cell is in SI units, in the units of a case."""
        units = case.units
        states = [units.of_motion(j) for _ in cell.phases for j in (0, 1)]
        memory = [units.of_motion(q.power) for q in cell.memory]
        times = [*[units.time] * len(cell.phases), *[1.0] * cell.forced]
        return np.array([*states, *memory, *times])

    def states(self, case: Any, y: Vector) -> list[tuple[float, ...]]:
        """Return the states in which the phases begin, at the equations of an orbit."""
        return [(float(y[2 * p]), float(y[2 * p + 1])) for p in range(len(self.order.steps))]

    def halves(self, y: Vector) -> Vector:
        """Return the states among the unknowns, of both halves of the phases."""
        return y[: 2 * len(self.order.steps)]

    def gathered(
        self, numbers: tuple[float, ...], states: Sequence[Sequence[float]], durations: Vector,
        angle: float,
    ) -> Vector:  # fmt: skip
        """Return the unknowns of an orbit from its parts; memories are set by the states."""
        cell, memory = self.cell(numbers), []
        angles_ = angle + cell.omega * np.concatenate([[0.0], np.cumsum(durations)])
        for each in cell.memory:
            p, (x, v, cos, constant) = each.phase, each.value[:4]
            own = x * states[p][0] + v * states[p][1]
            memory.append(own + cos * np.cos(angles_[p]) + constant)
        turn = [angle] if cell.forced else []
        return np.array([*chain.from_iterable(states), *memory, *durations, *turn])

    def orbit(self, case: Case, z: Vector) -> ExactOrbit:
        """Return where Newton's method leads from unknowns in the units of a case."""
        return of_unknowns(self.case(case), z)

    def maps(self, case: Any, z: Vector, kept: Matrix) -> tuple[Matrix, Matrix]:
        """Return what a cell makes of perturbations, and its size: as kept with its orbit."""
        return kept[0], kept[1]

    def state(self, case: Any, z: Vector, p: int, t: float) -> tuple[float, ...]:
        """Return the state, displacement and velocity, at a time from the beginning of a phase.

        Parameters
        ----------
        case : tuple
            The equations at a value of the parameter; see `extended.case_at`.
        z : ndarray
            Their unknowns.
        p : int
        t : float
        """
        m, c, k, f, g = map(float, phase_numbers(case, z, p))
        speed = float(case[1][p, F])  # of a held phase
        phase = replace(
            self._generic.phases[p], m=m, c=c, k=k, f=f, g=g, speed=speed, memory=()
        )
        x, v, angle = map(float, (z[2 * p], z[2 * p + 1], angles(case, z, places(case))[p]))
        found = state_at(phase, x, v, angle, float(case[4][1]), t)
        return float(found[0]), float(found[1])

    def moving_at(self, case: Any, z: Vector, p: int, t: float) -> tuple[float, ...]:
        """Return displacement and velocity there; see `state`."""
        return self.state(case, z, p, t)

    def case_of(self, cell: Cell, forms: list[Form]) -> Any:
        """Return the equations of a cell, and its forms, as `extended.case_at` does."""
        return *arrays(cell), np.array(forms, dtype=float)

    def terms(self, case: Any, z: Vector, p: int, i: int) -> Vector:
        """Return the Taylor coefficients of form `i` where a phase begins."""
        angle, form = angles(case, z, places(case))[p], watch.form_of(case, z, i)
        equation, state = phase_numbers(case, z, p), (z[2 * p], z[2 * p + 1])
        found: Vector = watch.taylor(equation, case[4][1], angle, *state, form)
        return found

    def table(self, numbers: tuple[float, ...], z: Vector, rows: Sequence[Row]) -> Integers:
        """Return the table of rows that `watch` takes; `z` is an orbit that is not special."""
        cell, count = self.cell(numbers), len(self.order.steps)
        own = self.demanded(numbers, rows, cell)
        case = self.case_of(cell, self.forms(numbers, rows, cell))
        rate = max(cell.omega, 1.0 / float(z[len(z) - count - cell.forced :][:count].sum()))
        found = np.zeros((len(rows), 5), dtype=np.int64)
        for i, row in enumerate(rows):
            found[i] = row.phase, row.kind, 0, 0, i
            if row.kind == WITHIN:
                sizes = np.abs(self.terms(case, z, row.phase, i)[:HIGHEST])
                sizes /= rate ** np.arange(HIGHEST)
                found[i, watch.BEGINS] = int(np.argmax(sizes > ROUNDING * sizes.max()))
                found[i, watch.IS_END] = same(own[i], cell.phases[row.phase].event)
            elif row.kind == BEHIND:
                alike = ((q.phase, q.node) == (row.phase, row.node) for q in rows)
                found[i, watch.INTO] = list(alike).index(True)
        return found


def _may_hold(nodes: Sequence[Node], ended: Node, h: int, v: float) -> bool:
    """Whether a phase that holds the velocity could take every state behind an event."""
    node, wall = nodes[h], walls(nodes)[h]
    speed = node.phase.speed
    if not node.phase.held or abs(v - speed) > ROUNDING * max(1.0, abs(speed)):
        return False
    if ended.event in node.demands:  # it has just ended so
        return False
    return wall == NONE or nodes[wall].event == ended.event
