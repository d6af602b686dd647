"""A body in one phase: its flow, and linear forms of ``Y = (y, cos, sin, 1, memory)``."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from ...arrays import Matrix
from ...bodies.laws import Free, free, places
from ...bodies.modal import Modal
from ...bodies.part import Part, generator_of, parts_of
from ...scenes.bodies.cell import BodyCell, BodyPhase
from ..nodes import Node
from ..steps.locate import NOISE

#: Modulus of a pole, relative to the fastest, below which it counts as zero.
STILL = 1e-6


@dataclass(frozen=True, eq=False)
class Regime:
    """A phase that a body can be in, in numbers.

    Parameters
    ----------
    free : Free
        The body without its contact forces.
    generator : ndarray, shape (W, W)
        Of ``Y' = generator Y``.
    contacts : ndarray, shape (3, c, W)
        Displacement, velocity and force of each contact, as forms of Y.
    """

    phase: BodyPhase
    part: Part
    body: Modal
    free: Free
    generator: Matrix
    contacts: Matrix

    @property
    def states(self) -> int:
        """Number of entries of y."""
        return len(self.part.lawful.A)

    @property
    def window(self) -> float:
        """A third of a period of the forcing or, without one, of the slowest pole."""
        poles = np.abs(self.part.flow.poles)
        slow = float(poles[poles > STILL * poles.max()].min(initial=np.inf))
        return 2.0 / (self.part.flow.omega or slow)


def regimes(cell: BodyCell, nodes: Sequence[Node]) -> tuple[Regime, ...]:
    """Return the phases that a motion of a cell can be in.

    Raises
    ------
    BodyError
        If a law does not fix its force, or a phase has no eigenbasis.
    """
    phases = tuple(q.phase for q in nodes if isinstance(q.phase, BodyPhase))
    free_body = free(cell.body, cell.omega, len(cell.memory))
    x, v, *_ = places(cell.body.at.shape[1])
    found = []
    for phase, part in zip(phases, parts_of(replace(cell, phases=phases, sign=1)), strict=True):
        rows, generator = part.lawful.rows, generator_of(part, cell.omega)
        contacts = np.array([rows[x], rows[v], part.lawful.force])
        found.append(Regime(phase, part, cell.body, free_body, generator, contacts))
    return tuple(found)


def slowest_decay(cell: BodyCell) -> float:
    """Return the least rate at which a transient of a phase decays; inf if none does."""
    poles = np.concatenate([part.flow.poles for part in parts_of(cell)])
    rates = -poles.real[-poles.real > NOISE * np.abs(poles)]
    return float(rates.min(initial=np.inf))
