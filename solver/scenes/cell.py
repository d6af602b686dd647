"""The equations of one cell in dimensionless numbers, as all solvers read them."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import pairwise, starmap
from operator import mul
from typing import Any, Self

#: A linear form in the state: factors of x, x' and the cosine of the forcing, a constant, then
#: the factors of the memories, if there are any.
Form = tuple[float, ...]


@dataclass(frozen=True)
class Phase:
    """One phase: ``m x'' + c x' + k x = f + g cos(Omega t + phi)``, or ``x' = speed``.

    Parameters
    ----------
    name : str
        Its name in the scene.
    m, c, k, f, g : float
        Coefficients of the equation of motion.
    held : bool
        Whether a constraint holds the velocity, at `speed`.
    event : Form
        Vanishes at the end of the phase, with the velocity before the switch.
    rho, d : float
        Velocity after the switch at its end: ``rho x' + d``.
    demands : tuple of (str, Form)
        Forms that must not be negative in the phase, in words and numbers.
    switch_demands : tuple of (str, Form)
        Forms that must not be negative at its end, before the switch.
    memory : tuple of float
        Factors of the memories on the right side of the equation of motion.
    """

    name: str
    m: float
    c: float
    k: float
    f: float
    g: float
    held: bool
    speed: float
    event: Form
    rho: float
    d: float
    demands: tuple[tuple[str, Form], ...]
    switch_demands: tuple[tuple[str, Form], ...] = ()
    memory: tuple[float, ...] = ()

    def remembering(self, values: Sequence[float]) -> Self:
        """Return the phase with values of the memories added to its force and its forms.

        Examples
        --------
        >>> phase = Phase("p", 1, 0, 1, 2, 0, False, 0, (1, 0, 0, 3, 5), 1, 0, (), (), (4,))
        >>> phase.remembering([10]).f, phase.remembering([10]).event
        (42, (1, 0, 0, 53))
        """
        if not self.memory:
            return self
        width = self.width

        def put(form: Form) -> Form:
            constant = form[3] + sum(map(mul, form[width:], values))
            return (*form[:3], constant, *form[4:width])

        force = self.f + sum(map(mul, self.memory, values))
        return self.with_forms(put, f=force, memory=())

    @property
    def width(self) -> int:
        """Number of entries of a form without those of the memories."""
        return 4

    @property
    def jumps(self) -> tuple[tuple[float, float], ...]:
        """``(rho, d)`` of each velocity: ``rho v + d`` after the switch at its end."""
        return ((self.rho, self.d),)

    @property
    def equation(self) -> tuple[object, ...]:
        """The coefficients of its equation of motion, by which equations are compared."""
        return self.m, self.c, self.k, self.f, self.g, self.held, self.memory

    @property
    def rests(self) -> bool:
        """Whether it holds all there is, which may then be anywhere."""
        return self.held

    def cut(self) -> Self:
        """Return the phase cut where the velocity vanishes: event ``x' = 0``, no jump."""
        event = tuple(float(j == 1) for j in range(len(self.event)))
        return replace(self, event=event, rho=1.0, d=0.0, switch_demands=())

    def lawful(self, form: Form) -> Form:
        """Return a form with the contact forces of a body by the laws of the phase."""
        return form

    def leaps(self, form: Form) -> bool:
        """Return whether the value of a form may jump at the switch that ends the phase."""
        return (self.rho, self.d) != (1.0, 0.0) and form[1] != 0

    def accelerations(self, x: Any, v: Any, cosine: Any) -> tuple[Any, Any, Any]:
        """Return the parts of the acceleration by force, damper and spring, in a free phase."""
        force = self.f + self.g * cosine
        return force / self.m, -self.c * v / self.m, -self.k * x / self.m

    def acceleration(self, x: Any, v: Any, cosine: Any) -> Any:
        """Return the acceleration in a state by the equation of motion."""
        if self.held:
            return 0.0 * v
        return (self.f + self.g * cosine - self.c * v - self.k * x) / self.m

    def with_forms(self, put: Callable[[Form], Form], **others: Any) -> Self:
        """Return the phase with each form replaced by ``put(form)``, and `others` as given."""
        return replace(
            self,
            event=put(self.event),
            demands=tuple((words, put(form)) for words, form in self.demands),
            switch_demands=tuple((words, put(form)) for words, form in self.switch_demands),
            **others,
        )

    def with_factors(self, put: Callable[[Form], Form]) -> Self:
        """Return the phase with its factors of the memories replaced by ``put(factors)``."""
        if not self.memory:
            return self
        width, memory = self.width, put(self.memory)
        return self.with_forms(lambda form: (*form[:width], *put(form[width:])), memory=memory)


@dataclass(frozen=True)
class Memory:
    """A constant that a switch sets.

    Parameters
    ----------
    phase : int
        The phase whose begin sets it; -1 if it holds in several.
    power : int
        Its unit is a length over a time to this power.
    value : Form
        The value it is set to, a form in the state after the switch; with the contact forces
        before it.
    within : tuple of int
        The phases in which it holds, if they are several: it is set where the motion comes to
        one of them from another phase.  In an order of phases one of them sets it.
    """

    name: str
    phase: int
    power: int
    value: Form
    within: tuple[int, ...] = ()

    @property
    def setter(self) -> int | tuple[int, ...]:
        """The phase that sets it, or those in which it holds."""
        return self.within or self.phase


@dataclass(frozen=True)
class Cell:
    """A period of the motion, or half of one whose other half is the mirror image.

    Parameters
    ----------
    frequency : float or None
        Angular frequency of the forcing; None without forcing.
    sign : {1, -1}
        The next cell is this times the cell: -1 if ``x(t + T/2) = -x(t)``.
    k : int
        Class C^k of the motion.
    guess : tuple of float
        Rough durations; empty if the scene has none.
    cycles : int
        Periods of the forcing in a period of the motion.
    memory : tuple of Memory
        Constants that switches set.
    classes : tuple of int
        The k of the class C^k at the switch that begins each phase.
    start : Form
        Factors of x and x', and a constant, of a form that vanishes where the first phase of
        the exact orbit begins; empty if the scene states none.
    orders : tuple of tuple
        If the phases are those of several motions: the order in which each has them, by index
        and whether mirrored.  Empty for one motion, whose phases follow in turn.
    to : tuple of tuple
        For each phase those of which one follows, by index and whether mirrored, if its event
        says so.  Empty where a choice that demands leave is decided by the declared orders.
    """

    phases: tuple[Phase, ...]
    frequency: float | None
    sign: int
    k: int
    guess: tuple[float, ...]
    cycles: int = 1
    memory: tuple[Memory, ...] = ()
    classes: tuple[int, ...] = ()
    start: Form = ()
    orders: tuple[tuple[tuple[int, bool], ...], ...] = ()
    to: tuple[tuple[tuple[int, bool], ...], ...] = ()

    def remembering(self, values: Sequence[float]) -> "Cell":
        """Return a cell without a memory, with these values put in."""
        if not self.memory:
            return self
        phases = tuple(phase.remembering(values) for phase in self.phases)
        return replace(self, phases=phases, memory=())

    def carrying(self, p: int) -> Phase:
        """Return phase `p` with factors of the actual values of the memories in that phase.

        Before the switch that sets a memory, its value is that of the cell before: `sign` times
        that of this cell.  The factors in `phases` include this sign; those returned do not.
        """
        return self._carrying[p]

    @cached_property
    def _carrying(self) -> tuple[Phase, ...]:
        def carried(p: int, phase: Phase) -> Phase:
            signs = [self.sign if p < each.phase else 1 for each in self.memory]
            return phase.with_factors(lambda factors: tuple(map(mul, factors, signs)))

        return self.phases if self.sign > 0 else tuple(starmap(carried, enumerate(self.phases)))

    def followers(self, p: int) -> tuple[tuple[int, bool], ...]:
        """Return the phases that the scene declares to follow phase `p`, and whether mirrored.

        First that of the longest motion, whose demands at the switch the phase has.
        """
        in_turn = tuple((q, False) for q in range(len(self.phases)))
        found = []
        for places in sorted(self.orders, key=len, reverse=True) or (in_turn,):
            first = [(q, mirrored != (self.sign < 0)) for q, mirrored in places[:1]]
            for (q, mirrored), (after, turned) in pairwise((*places, *first)):
                found += [(after, turned != mirrored)] if q == p else []
        return tuple(dict.fromkeys(found))

    def place(self, p: int) -> float | None:
        """Return the displacement at which phase `p` rests; None if it is not known in advance.

        It is known if the event of the phase before is ``x = constant``.
        """
        ex, ev, ec, constant, *memory = self.phases[p - 1].event
        phase, sign = self.phases[p], self.sign if p == 0 else 1
        is_known = ex != 0 and not (ev or ec or any(memory))
        return -sign * constant / ex if is_known and phase.held and phase.speed == 0 else None

    @property
    def forced(self) -> bool:
        """Whether it is forced: its duration is known, the phase of the forcing is unknown."""
        return self.frequency is not None

    @property
    def cells(self) -> int:
        """Number of cells in a period."""
        return 1 if self.sign > 0 else 2

    @property
    def omega(self) -> float:
        """Angular frequency of the forcing; 0 if there is none."""
        return 0.0 if self.frequency is None else self.frequency

    @property
    def duration(self) -> float:
        """Duration of the cell, which the forcing prescribes."""
        if self.frequency is None:
            raise ValueError("the duration of a cell without forcing is unknown")
        return self.cycles * 2 * math.pi / self.frequency / self.cells
