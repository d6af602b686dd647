"""The equations of an order of phases along a branch, and the forms that are watched."""

from collections.abc import Iterable, Sequence
from dataclasses import replace
from itertools import chain
from typing import Any, ClassVar, NamedTuple, Self

import numpy as np

from ..arrays import Integers, Matrix, Vector
from ..bodies.systems import BodyError
from ..existence.reasons import steady
from ..flow.exact_system import angles, arrays, phase_numbers, places
from ..flow.responses import state_at
from ..kernels.family import Family
from ..orbit.exact_orbit import ExactOrbit, of_unknowns
from ..rows.joints import F
from ..scenes.case import Case
from ..scenes.cell import Cell, Form, Phase
from ..scenes.mirror import mirror, same
from ..scenes.parameter_error import ParameterError
from ..simulation.followers import may_hold
from ..simulation.steps.state import AnyState, State
from . import walk, watch
from .along import Along, Content, Interval, divided_phases, of_velocity, resolved, weights
from .orders.itinerary import Itinerary
from .place import NoStepError
from .walk import FAMILY
from .watch import AT_SWITCH, BEGINS, BEHIND, END, IS_END, START, WITHIN

#: Size of a derivative at the start of a phase that is rounding, relative to the largest.
ROUNDING = 1e-8

#: How many derivatives of a form are examined at the start of a phase.
HIGHEST = 4

#: Where in its duration a phase is looked at, for how far it goes.
LOOKED_AT = 0.0, 0.25, 0.5, 0.75

#: Most phases of an order that is followed; near chatter their number has no bound.
MOST = 40


class Row(NamedTuple):
    """One watched form: where it is evaluated, and to what it belongs.

    Parameters
    ----------
    phase, kind : int
        As in a table of `watch`.
    number : int
        Of the demand, of the phase or of the node.
    node : int
        For `BEHIND`, the phase that could hold the motion there; else -1.
    """

    phase: int
    kind: int
    number: int
    node: int = -1


class Course(Itinerary):
    """An order of phases as branches follow it: its equations and watched forms."""

    #: The compiled or plain functions of a branch.
    family: ClassVar[Family] = FAMILY

    @property
    def most(self) -> int:
        """Most phases of an order that is followed."""
        return MOST

    def about(self, numbers: tuple[float, ...]) -> Self:
        """Return it with whatever is chosen by some parameters, in its units; here nothing."""
        return self

    def rows(self, numbers: tuple[float, ...], z: Vector) -> list[Row]:
        """Return the watched forms, by an orbit that is not at an event."""
        cell, rows = self.cell(numbers), []
        machine = self.machine(numbers)
        for p, phase in enumerate(cell.phases):
            rows += [Row(p, WITHIN, i) for i in range(len(phase.demands))]
            rows += [Row(p, AT_SWITCH, i) for i in range(len(phase.switch_demands))]
            v = None if self.endless else self.velocity_behind(cell, z, p)
            for h, node in enumerate(machine.nodes):
                ended = machine.node(self.order.steps[p])
                if v is not None and may_hold(machine, h, ended, v):
                    rows += [Row(p, BEHIND, i, h) for i in range(len(node.phase.demands))]
        return rows

    def velocity_behind(self, cell: Cell, z: Vector, p: int) -> float | None:
        """Return the velocity behind phase p, where a held phase could follow; else None."""
        q = (p + 1) % len(cell.phases)
        if cell.phases[q].held:
            return None
        v = self.moving_at(self.case_of(cell, []), z, q, 0.0)[1]
        return v * (cell.sign if q == 0 else 1)

    def word(self, row: Row, column: int, entry: Integers) -> str:
        """Return the kind of the event at which a watched form vanishes.

        "sticking" where a rest begins or ends; "vanishing" where a demand is met at a speed in
        the instant in which its phase begins or ends; else "grazing".

        column : int
            Of `watch`: where in the phase.
        entry : ndarray of int
            Its row in the table of `watch`.  If the form vanishes at the start whatever the
            orbit, and its first derivative too, the phase begins without speed.
        """
        step = self.order.steps[row.phase]
        held, phases = self.base.kinds[step.phase][1], self._generic.phases
        demands = phases[row.phase].demands
        without_speed = held or row.kind != WITHIN or of_velocity(demands[row.number][1])
        without_speed = without_speed or (column == START and entry[BEGINS] > 1)
        if self.can_rest and without_speed:
            return "sticking"
        begins = column == START and not entry[BEGINS]
        ends = column == END and not entry[IS_END]
        turns = of_velocity(phases[row.phase - (column == START)].event)
        at_speed = row.kind == WITHIN and (begins or ends) and not turns
        return "vanishing" if at_speed else "grazing"

    def forms(self, numbers: tuple[float, ...], rows: Sequence[Row], cell: Cell) -> list[Form]:
        """Return the forms of rows as `watch` takes them; `numbers` are without units.

        Here they are as a cell has them; see `before`.
        """
        any_behind = any(row.kind == BEHIND for row in rows)
        declared = self.declares(numbers) if any_behind else cell  # else not looked at
        forms: list[Form] = []
        for row in rows:
            phase = self.phase(cell, row.phase)
            if row.kind == BEHIND:
                mirrored, p = divmod(row.node, len(declared.phases))
                node = declared.carrying(p)
                forms.append(self.before(cell, mirror(node) if mirrored else node, row))
            else:
                demands = phase.demands if row.kind == WITHIN else phase.switch_demands
                forms.append(demands[row.number][1])
        return forms

    def phase(self, cell: Cell, p: int) -> Phase:
        """Return phase p with factors of the memories as the unknowns have them."""
        return cell.phases[p]

    def before(self, cell: Cell, node: Phase, row: Row) -> Form:
        """Return a demand of the phase that could hold the motion behind a switch.

        As a form of the state before the switch.
        """
        x, v, cos, constant = node.demands[row.number][1][:4]
        ended = cell.phases[row.phase]
        form = x, v * ended.rho, cos, constant + v * ended.d
        return *form, *[0.0] * len(cell.memory)

    def along(
        self, content: Content, value: float, interval: Interval, z: Vector
    ) -> tuple[Along, Interval]:
        """Return the equations on an interval of a parameter, or on a part of it.

        Parameters
        ----------
        content : callable
            Returns the cell and the watched forms at a value.
        value : float
            The interval is halved around it until the series converge.
        z : ndarray
            The unknowns at that value, for their scales.
        """
        cell, forms = content(value)
        blocks = self.blocks(cell, forms)

        def values(at: float) -> Vector:
            try:
                entries: Vector = self.entries(*content(at))
            except (BodyError, ParameterError):  # no such oscillator
                entries = np.empty(0)
            return entries if len(entries) == len(blocks) else np.full(len(blocks), np.nan)

        series, interval = resolved(values, value, interval, blocks)
        others = (content(at)[0] for at in interval.some())
        return self.framed(cell, z, series, others), interval

    def entries(self, cell: Cell, forms: list[Form]) -> Vector:
        """Return all entries of the arrays of a cell that may vary, followed by the forms."""
        cell_arrays, rows = arrays(cell), np.array(forms, dtype=float)
        parts = (cell_arrays.numbers, cell_arrays.memory, cell_arrays.cell, rows)
        return np.concatenate([part.ravel() for part in parts])

    def blocks(self, cell: Cell, forms: list[Form]) -> Integers:
        """Return the number of the block of each entry, here its own; see `along.resolved`."""
        return np.arange(len(self.entries(cell, forms)))

    def framed(self, cell: Cell, z: Vector, series: Any, other_cells: Iterable[Cell]) -> Along:
        """Return the equations of a cell from their series.

        `z` are unknowns of typical size, `other_cells` the cells at `Interval.some`.
        """
        cell_arrays, before = arrays(cell), 2 * len(cell.phases) + len(cell.memory)
        divided = divided_phases((cell, *other_cells), z[before:])
        case, durations = self.case_of(cell, []), z[before:][: len(cell.phases)]
        times = [(p, s * part) for p, s in enumerate(durations) for part in LOOKED_AT]
        farthest = max(abs(self.state(case, z, p, t)[0]) for p, t in times)
        scales = weights(cell, z, farthest)
        arguments = cell_arrays.kinds, cell_arrays.setting, series, divided, scales
        return Along(*arguments, before, float(cell.sign))

    def by(self, name: str, *arguments: Any) -> Any:
        """Call a function of `walk` and what it is linked with, by name; see `Family.call`."""
        with np.errstate(all="ignore"):
            return self.family.call(walk.__name__, name, *arguments)

    @property
    def mapped(self) -> int:
        """The size of the maps of perturbations that are kept with each orbit."""
        return 2 + len(self._generic.memory)

    def unknowns(self, orbit: ExactOrbit) -> Vector:
        """Return those of an exact orbit, without units."""
        return orbit.outcome.unknowns

    def sizes(self, cell: Cell, case: Case) -> Vector:
        """Return the SI value of 1 of each unknown of a cell in the units of a case."""
        units = case.units
        states = [units.of_motion(j) for _ in cell.phases for j in (0, 1)]
        memory = [units.of_motion(q.power) for q in cell.memory]
        times = [*[units.time] * len(cell.phases), *[1.0] * cell.forced]
        return np.array([*states, *memory, *times])

    def states(self, case: Any, y: Vector) -> list[tuple[float, ...]]:
        """Return the states in which the phases of an orbit begin; `case` are its equations."""
        return [(float(y[2 * p]), float(y[2 * p + 1])) for p in range(len(self.order.steps))]

    def halves(self, y: Vector) -> Vector:
        """Return those unknowns that are states."""
        return y[: 2 * len(self.order.steps)]

    def gathered(
        self, numbers: tuple[float, ...], states: Sequence[Sequence[float]], durations: Vector,
        angle: float,
    ) -> Vector:  # fmt: skip
        """Return the unknowns of an orbit from states, durations and angle; memories follow."""
        cell, memory = self.cell(numbers), []
        forcing_angles = angle + cell.omega * np.concatenate([[0.0], np.cumsum(durations)])
        for remembered in cell.memory:
            p, (x, v, cos, constant) = remembered.phase, remembered.value[:4]
            of_state = x * states[p][0] + v * states[p][1]
            memory.append(of_state + cos * np.cos(forcing_angles[p]) + constant)
        forcing_phase = [angle] if cell.forced else []
        return np.array([*chain.from_iterable(states), *memory, *durations, *forcing_phase])

    def for_ever(self, numbers: tuple[float, ...]) -> Vector:
        """Return the unknowns of a motion without switches, the response to the forcing.

        Its cell begins where the velocity, that of the first contact, vanishes: a sinusoid of
        the phase of the forcing there.

        Raises
        ------
        NoStepError
            If there is none.
        """
        cell = self.cell(numbers)
        states = steady(cell, 0)
        if states is None:
            raise NoStepError
        mean, wave = states

        def begun(angle: float) -> Vector:
            state = mean + (wave * np.exp(1j * angle)).real
            return self.gathered(numbers, [state], np.array([cell.duration]), angle)

        equations = self.case_of(cell, [])
        first, second = (
            self.moving_at(equations, begun(angle), 0, 0.0)[1] for angle in (0.0, np.pi / 2)
        )
        return begun(float(np.arctan2(-first, second)))

    def orbit(self, case: Case, z: Vector) -> ExactOrbit:
        """Return the exact orbit that Newton's method finds from unknowns of a case."""
        return of_unknowns(self.case(case), z)

    def maps(self, case: Any, z: Vector, stored: Matrix) -> tuple[Matrix, Matrix]:
        """Return the derivative of the map over a cell and its size, kept with the orbit."""
        return stored[0], stored[1]

    def state(self, case: Any, z: Vector, p: int, t: float) -> tuple[float, ...]:
        """Return displacement and velocity at time t of phase p.

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
        state = state_at(phase, x, v, angle, float(case[4][1]), t)
        return float(state[0]), float(state[1])

    def moving_at(self, case: Any, z: Vector, p: int, t: float) -> tuple[float, ...]:
        """Return displacement and velocity at time t of phase p; see `state`."""
        return self.state(case, z, p, t)

    def whole_state(self, case: Any, z: Vector, p: int, t: float, angle: float) -> AnyState:
        """Return the state at time t of phase p as simulations take it, with the memory."""
        values = z[2 * len(self.order.steps) :]
        signed = ((q and q[1] * values[q[0]]) for q in self.columns(p))
        x, v = self.state(case, z, p, t)
        return State(x, v, angle, memory=tuple(q or 0.0 for q in signed))

    def case_of(self, cell: Cell, forms: list[Form]) -> Any:
        """Return the arrays of a cell followed by its forms, as `extended.case_at` does."""
        return *arrays(cell), np.array(forms, dtype=float)

    def terms(self, case: Any, z: Vector, p: int, i: int) -> Vector:
        """Return the Taylor coefficients of form `i` at the start of phase p."""
        angle, form = angles(case, z, places(case))[p], watch.form_of(case, z, i)
        equation, state = phase_numbers(case, z, p), (z[2 * p], z[2 * p + 1])
        coefficients: Vector = watch.taylor(equation, case[4][1], angle, *state, form)
        return coefficients

    def table(self, numbers: tuple[float, ...], z: Vector, rows: Sequence[Row]) -> Integers:
        """Return the table of rows for `watch`; `z` is an orbit that is not at an event."""
        cell, count = self.cell(numbers), len(self.order.steps)
        case = self.case_of(cell, self.forms(numbers, rows, cell))
        rate = max(cell.omega, 1.0 / float(z[len(z) - count - cell.forced :][:count].sum()))
        table = np.zeros((len(rows), 5), dtype=np.int64)
        for i, row in enumerate(rows):
            table[i] = row.phase, row.kind, 0, 0, i
            if row.kind == WITHIN:
                sizes = np.abs(self.terms(case, z, row.phase, i)[:HIGHEST])
                sizes /= rate ** np.arange(HIGHEST)
                table[i, watch.BEGINS] = int(np.argmax(sizes > ROUNDING * sizes.max()))
                phase = cell.phases[row.phase]
                table[i, watch.IS_END] = same(phase.demands[row.number][1], phase.event)
            elif row.kind == BEHIND:
                alike = ((q.phase, q.node) == (row.phase, row.node) for q in rows)
                table[i, watch.INTO] = list(alike).index(True)
        return table
