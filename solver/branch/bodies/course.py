"""The equations of an order of phases of a body along a branch, and its watched forms."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, Self, TypeAlias

import numpy as np

from ...arrays import Integers, Matrix, Vector
from ...bodies.exact import evaluated
from ...bodies.laws import under
from ...bodies.modal import Modal, facing
from ...bodies.part import parts_of
from ...kernels import linking
from ...kernels.family import Family
from ...kernels.start import RoughTimes
from ...orbit.exact_orbit import ExactOrbit, from_times
from ...scenes.case import Case
from ...scenes.cell import Form, Phase
from ...simulation.bodies.state import BodyState
from .. import walk
from ..along import SMALL, Along, divided_phases
from ..course import Course, Row
from . import equations, exponential, factors, watched, ways
from .arrays import arrays, case_of, in_order, known_of

#: Most phases of an order that is followed, for each contact.
MOST = 8

#: A `BodyCell`: a scene of a body has no other.
Cell: TypeAlias = Any

#: Modules whose functions replace those of the same names.
OWN = exponential, factors, equations, ways, watched


def linked(module: Any, make: linking.Make) -> dict[str, Any]:
    """Return the functions of a branch, linked to the equations of bodies."""
    return linking.made((*walk.MODULES, module, *OWN), {}, make)


#: How they are made; see `branch.walk`.
BODIES = Family(linked, (*walk.MODULES, *OWN), seconds=20.0)


@dataclass(frozen=True)
class BodyCourse(Course):
    """An order of phases of a scene of a body.

    Parameters
    ----------
    reference : Modal, optional
        The body whose shapes those of all others face; see `facing`.
    """

    reference: Modal | None = field(default=None, compare=False)

    family = BODIES

    def cell(self, numbers: tuple[float, ...]) -> Cell:
        """Return its cell for parameters without units, its shapes on the sides chosen."""
        return self._faced(super().cell(numbers))

    def declares(self, numbers: tuple[float, ...]) -> Cell:
        """Return the cell of the phases that there are, its shapes on the sides chosen."""
        return self._faced(super().declares(numbers))

    def about(self, numbers: tuple[float, ...]) -> Self:
        """Return it with the shapes that it has for some parameters as reference."""
        return replace(self, reference=self.cell(numbers).body)

    def _faced(self, cell: Cell) -> Cell:
        body = facing(cell.body, self.reference) if self.reference else cell.body
        return cell if body is cell.body else replace(cell, body=body)

    @property
    def most(self) -> int:
        """Most phases of an order that is followed."""
        cell: Cell = self._generic
        return MOST * int(cell.body.at.shape[1])

    def entries(self, cell: Cell, forms: list[Form]) -> Vector:
        """Return the entries of its arrays."""
        return np.concatenate([block.ravel() for block in arrays(cell, forms)])

    def blocks(self, cell: Cell, forms: list[Form]) -> Integers:
        """Return the number of the array of each entry: the largest has the rounding of all."""
        matrices = arrays(cell, forms)
        return np.repeat(np.arange(len(matrices)), [matrix.size for matrix in matrices])

    def framed(self, cell: Cell, z: Vector, series: Any, other_cells: Iterable[Cell]) -> Along:
        """Return the equations of a cell from their series; the states have one scale."""
        count, states = len(cell.phases), len(z) - len(cell.phases) - cell.forced
        kinds = np.zeros(count, dtype=np.int64)
        memory = slice(states - len(cell.memory), states)
        weights, size = np.ones(len(z) + 1), float(np.linalg.norm(z[: memory.start]))
        weights[: memory.start] = 1 / size
        weights[memory] = 1 / np.maximum(np.abs(z[memory]), SMALL * size)
        weights[states : states + count] = 1 / float(z[states : states + count].sum())
        cells, width = [cell, *other_cells], np.array([states + 3])
        divided = divided_phases(cells, z[states:])
        varying, known = known_of(cell, cells[1:], series)
        arguments = kinds, width, varying, divided, weights, states, float(cell.sign)
        return Along(*arguments, known)

    @property
    def mapped(self) -> int:
        """0: the maps of all orbits would take too much memory."""
        return 0

    def unknowns(self, orbit: ExactOrbit) -> Vector:
        """Return those of an exact orbit, without units: its state, and its times."""
        cell = self._faced(orbit.case.cell)
        return np.append(evaluated(cell, orbit.times).starts[0], orbit.times)

    def sizes(self, cell: Cell, case: Case) -> Vector:
        """Return what 1 of each unknown of a cell is in SI units, in the units of a case."""
        units, count = case.units, 2 * len(cell.body.squares)
        state = [units.of_motion(1) * units.mass**0.5] * count
        memory = [units.of_motion(remembered.power) for remembered in cell.memory]
        times = [*[units.time] * len(cell.phases), *[1.0] * cell.forced]
        return np.array([*state, *memory, *times])

    def states(self, case: Any, y: Vector) -> list[tuple[float, ...]]:
        """Return the states, with the memory, in which the phases begin."""
        return [tuple(map(float, Y[:-3])) for Y in equations.initial_states(case, y[:-1])]

    def halves(self, y: Vector) -> Vector:
        """Return nothing: the unknowns have one state only."""
        return y[:0]

    def gathered(
        self, numbers: tuple[float, ...], states: Sequence[Sequence[float]], durations: Vector,
        angle: float,
    ) -> Vector:  # fmt: skip
        """Return the unknowns of an orbit from its parts."""
        cell: Cell = self.cell(numbers)
        times = [*durations, *([angle] if cell.forced else [])]
        if cell.memory:
            try:
                return np.append(evaluated(cell, np.array(times)).starts[0], times)
            except np.linalg.LinAlgError:
                raise ArithmeticError("no state belongs to the times alone") from None
        return np.array([*states[0][: 2 * len(cell.body.squares)], *times])

    def orbit(self, case: Case, z: Vector) -> ExactOrbit:
        """Return where Newton's method leads from unknowns in the units of a case."""
        orbit_case = self.case(case)
        count, forced = len(orbit_case.cell.phases), orbit_case.cell.forced
        times = tuple(map(float, z[len(z) - count - forced :]))
        angle = times[-1] if forced else 0.0
        return from_times(orbit_case, RoughTimes(times[:count], angle, "a branch"))

    def maps(self, case: Any, z: Vector, stored: Matrix) -> tuple[Matrix, Matrix]:
        """Return the derivative of the map over a cell, and its size, computed anew."""
        with np.errstate(all="ignore"):  # an event may be touched there
            matrix, size, _ = equations.cell_map(case, z, stored, 0.0)
        return matrix, size

    def state(self, case: Any, z: Vector, p: int, t: float) -> tuple[float, ...]:
        """Return the state, with the memory, at time t of phase p."""
        return tuple(map(float, equations.state_at(case, z, p, t)[:-3]))

    def whole_state(self, case: Any, z: Vector, p: int, t: float, angle: float) -> BodyState:
        """Return the state at time t of phase p as simulations take it, with the memory."""
        state = self.state(case, z, p, t)
        count = len(state) - len(self._generic.memory)
        memory = tuple(state[count + q[0]] if q else 0.0 for q in self.columns(p))
        return BodyState(state[:count], angle, memory=memory)

    def moving_at(self, case: Any, z: Vector, p: int, t: float) -> tuple[float, ...]:
        """Return displacement and velocity of the first contact at time t of phase p."""
        return tuple(map(float, case[4][p] @ equations.state_at(case, z, p, t)))

    def velocity_behind(self, cell: Cell, z: Vector, p: int) -> float | None:
        """Return the velocity of the first contact behind phase p, where it could be held.

        Not for bodies with a memory, nor where the velocity jumps.
        """
        jumps = any(jump != (1.0, 0.0) for jump in cell.phases[p].jumps)
        return None if jumps or cell.memory else super().velocity_behind(cell, z, p)

    def forms(self, numbers: tuple[float, ...], rows: Sequence[Row], cell: Cell) -> list[Form]:
        """Return the forms of rows, without units, for `equations.case_at`."""
        matrices = [parts_of(cell)[row.phase].lawful.rows for row in rows]
        forms = zip(super().forms(numbers, rows, cell), matrices, strict=True)
        return [tuple(map(float, in_order(cell, form @ matrix))) for form, matrix in forms]

    def phase(self, cell: Cell, p: int) -> Phase:
        """Return phase p with factors of the actual memories, which are part of the state."""
        phase: Phase = cell.carrying(p)
        return phase

    def before(self, cell: Cell, node: Any, row: Row) -> Form:
        """Return a demand of the phase that could hold the contact behind a switch.

        As a form of the state before the switch, with the forces by the laws of that phase.
        """
        _, form = node.demands[row.number]
        through = np.array([under(cell, node, unit, 1) for unit in np.eye(len(form))])
        return tuple(map(float, through @ form))

    def case_of(self, cell: Cell, forms: list[Form]) -> Any:
        """Return the equations of a cell, and its forms, as `equations.case_at` does."""
        return case_of(cell, forms)

    def terms(self, case: Any, z: Vector, p: int, i: int) -> Vector:
        """Return the Taylor coefficients of form `i` where a phase begins."""
        expansion = ways.expanded(ways.way_of(case, p), case[6][i])
        coefficients: Vector = expansion @ equations.initial_states(case, z)[p]
        return coefficients
