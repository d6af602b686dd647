"""The phases of a cell of a body: rules as arrays, run by plain or compiled functions."""

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from types import ModuleType
from typing import Any, ClassVar

import numpy as np

from ...arrays import Vector
from ...bodies import flow
from ...flow import divided
from ...kernels import linking
from ...kernels.family import Family
from ...scenes.bodies.cell import BodyCell
from ...scenes.cell import Cell
from ..lasting import ROUNDING
from ..machine import Machine, with_arrays
from ..nodes import InState
from ..steps import chatter, clock, column, rules, run, switches
from ..steps import locate as common_locate
from ..steps import state as common_state
from ..steps import step as common_step
from ..steps.rules import Rules
from ..steps.state import AnyState
from . import along, locate, modes, phases, state, step
from .along import least
from .phases import body_rules_of
from .record import BodySegment
from .regime import Regime, regimes
from .state import BodyState, on

#: Modules whose functions follow a motion: common ones, and those of bodies, whose functions
#: replace those of one mass of the same names.
PARTS = clock, chatter, common_state, switches, common_step
OWN = modes, along, locate, state, step

#: Modules of which only constants are compiled into these functions.
NUMBERS = column, rules, phases, common_locate, flow


def linked(motion: ModuleType, make: linking.Make) -> dict[str, Any]:
    """Return the functions of `step` and `run` over those of bodies, plain or compiled."""
    functions = linking.made((divided,), {}, make)
    exponentials = {name: functions[name] for name in ("exp", "of_two", "of_three")}
    return linking.made((*PARTS, motion, *OWN), exponentials, make, of_numbers=exponentials)


#: The functions, linked as plain Python or compiled once plain ones have cost enough.
FAMILY = Family(linked, (divided, *NUMBERS, *PARTS, *OWN), seconds=10.0)


@dataclass(frozen=True)
class BodyMachine(Machine):
    """The phases of a cell of a body, and the rules by which one follows another."""

    cell: BodyCell
    family: ClassVar[Family] = FAMILY

    @cached_property
    def rules(self) -> Rules:
        """The nodes and their switching surfaces as arrays."""
        return body_rules_of(self.cell, self.nodes, self.regimes)

    @cached_property
    def regimes(self) -> tuple[Regime, ...]:
        """The phases in numbers."""
        return regimes(self.cell, self.nodes)

    def still(self, angle: float) -> AnyState:
        """Return the state at rest with zero displacement."""
        return self._at(np.zeros(len(self.regimes[0].free.A)), angle)

    def released(self, x: float, v: float, angle: float) -> AnyState:
        """Return the state nearest to rest with given x and v of the first contact."""
        return self.remembered(self.put(self.still(angle), x, v))

    def put(self, state: BodyState, x: float, v: float) -> BodyState:
        """Return the state nearest to a given one with given x and v of the first contact."""
        rows = self.regimes[0].contacts[:2, 0].copy()
        rows[:, self.regimes[0].states + 2] -= x, v
        return on(rows, state)

    def resting(self, angle: float) -> Iterator[AnyState]:
        """Yield states at rest: at 0, and the equilibria of the phases."""
        return iter([self.still(angle), *self._balanced(angle)])

    def starts(self, angle: float) -> list[AnyState | None]:
        """Return the states from which `settle` simulates: at rest, held, and equilibria."""
        return [*super().starts(angle), *self._balanced(angle)]

    def _balanced(self, angle: float) -> Iterator[AnyState]:
        """Yield the equilibrium of each phase without forcing.

        A held phase is at the place where the one before it ends, if this is a fixed place.
        """
        for node, regime in zip(self.nodes, self.regimes, strict=True):
            lawful, place = regime.part.lawful, Cell.place(self.cell, node.index)
            rows, right = lawful.A, -lawful.inputs[:, 2]
            if place is not None:
                rows = np.vstack([rows, regime.contacts[0, 0, : regime.states]])
                right = np.append(right, -place if node.mirrored else place)
            if node.phase.held or lawful.still.size:  # it may stay at many places
                equilibrium, *_ = np.linalg.lstsq(rows, right)
            else:
                equilibrium = np.linalg.solve(rows, right)
            yield self._at(np.asarray(equilibrium, dtype=float), angle)

    def _at(self, y: Vector, angle: float) -> AnyState:
        """Return a state with the memory that suits it best; see `remembered`."""
        return self.remembered(BodyState(y, angle))

    def remembered(self, state: AnyState) -> AnyState:
        """Return a state with a suitable memory, where none is known; see `Machine.remembered`.

        Its entries are plain numbers, so that states can be compared.
        """
        filled = super().remembered(state)
        return filled._replace(y=tuple(map(float, filled.y)), memory=tuple(filled.memory))

    def in_state(self, p: int) -> InState:
        """Return what forms act on, by the state Y of a phase."""
        regime = self.regimes[p]
        return InState(regime.part.lawful.rows, regime.generator, regime.states + 2)

    def lasts(self, segment: Any) -> bool:
        """Return whether a phase of a motion is proven to last for ever."""
        p, Y = self.number(segment.began), segment.Y
        rows, signs, _ = self.by("watched", p, with_arrays(segment.start))
        arguments = self.rules.phases, self.rules.omega, p, Y, rows, signs
        unmarked = np.zeros(len(rows), dtype=bool)
        along = self.family.call(run.__name__, "along_of", *arguments, unmarked)
        low = least(along, segment.s, float(np.abs(Y).max()))
        return bool((low >= -ROUNDING * along.sizes).all())

    def recorded(
        self, p: int, state: BodyState, t: Fraction, s: float, surface: int
    ) -> BodySegment:
        """Return a phase that was followed as a segment of the record."""
        node, regime = self.nodes[p], self.regimes[p]
        x, v = (regime.contacts[:2, 0] @ state.full).tolist()
        return BodySegment(
            node.phase, node.index, node.mirrored, t, state.angle, x, v, s,
            self.ending(p, surface), start=state, regime=regime,
        )  # fmt: skip
