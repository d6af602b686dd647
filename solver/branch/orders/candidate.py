"""One reading of an orbit at an event: an order of phases, with states and durations."""

from dataclasses import dataclass, replace

from ...scenes.orders import Order, Step
from ..course import Course


@dataclass(frozen=True)
class Slot:
    """A phase of an orbit.

    Parameters
    ----------
    step : Step
        Which phase.
    state : tuple of float
        The state at its start.
    s : float
        Its duration.
    """

    step: Step
    state: tuple[float, ...]
    s: float


@dataclass(frozen=True)
class Candidate:
    """One reading of the orbit at an event: an order of phases, states and durations.

    Parameters
    ----------
    slots : tuple of Slot
    half : bool
        Whether they are half a period.
    angle : float
        Phase of the forcing where the first begins.
    grows : tuple of int
        The numbers of the inserted phases, whose durations are zero.
    endless : bool
        Whether it is a motion of one phase that never ends.
    """

    slots: tuple[Slot, ...]
    half: bool
    angle: float
    grows: tuple[int, ...] = ()
    endless: bool = False

    def course(self, old: Course) -> Course:
        """Return the equations of this order; `old` are those of the branch up to the event."""
        order = Order(tuple(slot.step for slot in self.slots), self.half)
        return replace(old, order=order, endless=self.endless)
