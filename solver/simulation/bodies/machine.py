"""The phases of a cell of a body: its rules, followed in plain Python."""

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import cache, cached_property
from typing import Any

import numpy as np

from ...arrays import Vector
from ...kernels import linking
from ...kernels.compiling import rebuilt
from ...scenes.bodies.cell import BodyCell
from ..machine import Machine
from ..nodes import InState
from ..steps import step, switches
from ..steps.clock import Clock
from ..steps.column import NONE
from ..steps.rules import Rules
from ..steps.state import AnyState
from ..steps.step import Passed
from . import rules
from .record import BodySegment
from .regime import Regime
from .rules import BodyState, body_rules_of, on, watched


@cache
def functions() -> dict[str, Any]:
    """Return the functions of `switches` and `step` over those of bodies."""
    return linking.made((switches, step, rules), {}, rebuilt)


@dataclass(frozen=True)
class BodyMachine(Machine):
    """The phases of a cell of a body, and what follows a motion through them."""

    cell: BodyCell

    @cached_property
    def rules(self) -> Rules:
        """The same as arrays."""
        return body_rules_of(self.cell, self.nodes)

    @property
    def functions(self) -> dict[str, Any]:
        """The functions of `steps` over those of bodies."""
        return functions()

    @property
    def regimes(self) -> tuple[Regime, ...]:
        """The phases in numbers."""
        found: tuple[Regime, ...] = self.rules.phases
        return found

    def window(self, p: int) -> float:
        """Return a time in which a motion in a phase does not turn often."""
        return self.regimes[p].window

    def step(self, p: int, state: BodyState, clock: Clock, most: float) -> Passed:
        """Follow a phase from where it begins, for a time at most, and across its switch.

        Jumps that are too low to be located, and do not end in a rest, accumulate.
        """
        passed: Passed = self.by("step", p, state, clock, most)
        accumulate = passed.left > 0 and passed.away == NONE
        return passed._replace(how=step.CHATTERS) if accumulate else passed

    def still(self, angle: float) -> AnyState:
        """Return the state at rest where nothing is displaced."""
        return self._at(np.zeros(len(self.regimes[0].free.A)), angle)

    def released(self, x: float, v: float, angle: float) -> AnyState:
        """Return the state nearest to rest with a place and a velocity of the first contact."""
        return self.remembered(self.put(self.still(angle), x, v))

    def put(self, state: BodyState, x: float, v: float) -> BodyState:
        """Return the state nearest to one with a place and a velocity of the first contact."""
        rows = self.regimes[0].contacts[:2, 0].copy()
        rows[:, self.regimes[0].states + 2] -= x, v
        return on(rows, state)

    def resting(self, angle: float) -> Iterator[AnyState]:
        """Yield states at rest: at 0, and where a phase leaves the body in balance."""
        return iter([self.still(angle), *self._balanced(angle)])

    def starts(self, angle: float) -> list[AnyState | None]:
        """Return states from which motions settle: at rest, held, and in balance."""
        return [*super().starts(angle), *self._balanced(angle)]

    def _balanced(self, angle: float) -> Iterator[AnyState]:
        """Yield the states in which each phase would leave the body without a forcing."""
        for regime in self.regimes:
            own = regime.part.lawful
            still, *_ = np.linalg.lstsq(own.A, -own.inputs[:, 2])
            yield self._at(np.asarray(still, dtype=float), angle)

    def _at(self, y: Vector, angle: float) -> AnyState:
        """Return a state with the memory that suits it best; see `remembered`."""
        return self.remembered(BodyState((), angle).at(y))

    def in_state(self, p: int) -> InState:
        """Return what forms of a phase are in a state."""
        regime = self.regimes[p]
        return InState(regime.part.lawful.rows, regime.generator, regime.states + 2)

    def recorded(
        self, p: int, state: BodyState, t: Fraction, s: float, surface: int
    ) -> BodySegment:
        """Return a phase that was followed as it is kept."""
        node, regime, Y = self.nodes[p], self.regimes[p], state.full
        x, v = (float(row @ Y) for row in regime.contacts[:2, 0])
        return BodySegment(
            node.phase, node.index, node.mirrored, t, state.angle, x, v, s,
            self.ending(p, surface), Y=Y, regime=regime,
            watched=watched(self.rules, p, state)[1],
        )  # fmt: skip
