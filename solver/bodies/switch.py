"""The switches of a body: impulses, and the memory that is set."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from ..arrays import Matrix
from .laws import free, places

if TYPE_CHECKING:
    from ..scenes.bodies.cell import BodyCell


#: Relative size of an event along a direction that is rounding.
UNSEEN = 1e-12


@dataclass(frozen=True, eq=False)
class Switch:
    """The affine map of ``X = (y, memory)`` at the end of a phase.

    Parameters
    ----------
    state : ndarray, shape (n, n)
    inputs : ndarray, shape (n, 3)
        Of cos, sin, 1 there.
    event : ndarray, shape (n + 3,)
        The event that ends the phase, over ``(y, cos, sin, 1, memory)``.
    states : int
        Entries of y.
    """

    state: Matrix
    inputs: Matrix
    event: Matrix
    states: int

    @cached_property
    def keeps(self) -> bool:
        """Whether the state is unchanged."""
        return np.array_equal(self.state, np.eye(len(self.state)))

    @cached_property
    def gradient(self) -> Matrix:
        """The event's factors of ``X = (y, memory)``."""
        return np.delete(self.event, slice(self.states, self.states + 3))

    @property
    def waves(self) -> Matrix:
        """The event's factors of cos, sin, 1."""
        return self.event[self.states : self.states + 3]

    def fixing(self, before: Matrix, after: Matrix) -> "Switch":
        """Return the switch with a shift of the state to the surface of its event.

        Parameters
        ----------
        before, after : ndarray, shape (n, f)
            Directions of the shift, before the switch and behind it.
        """
        shift = after @ np.linalg.pinv((self.gradient @ before)[None])
        state = self.state - shift @ self.gradient[None]
        return replace(self, state=state, inputs=self.inputs - shift @ self.waves[None])


def fixed(switches: Sequence[Switch], before: Matrix, after: Matrix) -> list[Switch]:
    """Return the switches of a cell, which determine displacements that nothing else does.

    At given durations the place of a body that moves freely between impacts is not determined.
    Each switch shifts it to the surface of its event; on an orbit the shift is zero.  A
    displacement that no event sees is arbitrary, and set to 0 by the last switch.

    Parameters
    ----------
    switches : sequence of Switch
    before, after : ndarray, shape (n, f)
        Directions of the state at the end of a phase and behind its switch, which only events
        see; possibly none.
    """
    if not before.size:
        return list(switches)
    _, values, Vh = np.linalg.svd(np.array([q.gradient for q in switches]) @ before)
    unseen = after @ Vh[(values > UNSEEN * np.abs(before).max()).sum() :].T
    *first, last = (q.fixing(before, after) for q in switches)
    onto = np.eye(len(unseen)) - unseen @ np.linalg.pinv(unseen)
    return [*first, replace(last, state=onto @ last.state, inputs=onto @ last.inputs)]


def impulses(cell: "BodyCell", p: int) -> tuple[Matrix, Matrix]:
    """Return ``J = N v + d``, the impulses of the contacts at the end of a phase.

    ``mobility J = (rho - 1) v + d`` at each contact whose velocity jumps.  If the next phase is
    held, the impulse brings the contact to its speed; on an orbit that is no further impulse.

    Returns
    -------
    by_velocity : ndarray, shape (c, c)
    constant : ndarray, shape (c,)
    """
    phase = cell.phases[p]
    last = p == len(cell.phases) - 1
    after = cell.phases[0 if last else p + 1]
    mobility = cell.body.kept_mobility if after.held else cell.body.mobility
    jumps = list(phase.jumps)
    if after.held:
        jumps[0] = (0.0, (cell.sign if last else 1) * after.speed)
    return impulses_of(mobility, jumps)


def impulses_of(
    mobility: Matrix, jumps: Sequence[tuple[float, float]]
) -> tuple[Matrix, Matrix]:
    """Return ``J = N v + d`` of contacts whose velocity becomes ``rho v + d``."""
    by_velocity, constant = np.zeros_like(mobility), np.zeros(len(mobility))
    hit = [i for i, jump in enumerate(jumps) if jump != (1.0, 0.0)]
    if hit:
        inverse = np.linalg.inv(mobility[np.ix_(hit, hit)])
        rho, d = np.array([jumps[i] for i in hit]).T
        by_velocity[np.ix_(hit, hit)] = inverse * (rho - 1)
        constant[hit] = inverse @ d
    return by_velocity, constant


def switch(cell: "BodyCell", p: int, rows: Matrix) -> Switch:
    """Return the switch at the end of a phase; `rows` are the variables of forms."""
    memory, contacts = len(cell.memory), cell.body.at.shape[1]
    free_body = free(cell.body, cell.omega, memory)
    states, width = free_body.A.shape[0], free_body.rows.shape[1]
    event = np.array(cell.carrying(p).event) @ rows
    after = np.eye(states + memory, width)  # over (y, cos, sin, 1, memory)
    after[states:] = np.eye(width)[width - memory :]
    by_velocity, constant = impulses(cell, p)
    velocity = free_body.rows[places(contacts)[1]]
    after[:states] += free_body.B @ by_velocity @ velocity
    after[:states, states + 2] += free_body.B @ constant
    following = (p + 1) % len(cell.phases)
    for i, remembered in enumerate(cell.memory):
        if remembered.phase == following:
            size = len(free_body.rows)
            behind = free_body.rows.copy()
            form, sign = np.array(remembered.value[:size]), cell.sign if following == 0 else 1
            form = form * np.where(np.arange(size) == 3, sign, 1)  # of the mirrored state
            behind[:, :states] = behind[:, :states] @ after[:states, :states]
            behind[:, states:] += free_body.rows[:, :states] @ after[:states, states:]
            after[states + i] = form @ behind
    columns = [*range(states), *range(states + 3, width)]
    return Switch(after[:, columns], after[:, states : states + 3], event, states)
