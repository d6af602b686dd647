"""The types of a scene: symbols, parameters, events, phases, memories, the whole."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property, partial, wraps
from typing import TYPE_CHECKING, Any, Self, TypeVar

import sympy as sp

from .memories import behind, settings

if TYPE_CHECKING:
    from .bodies.body import Body, Contact

t, x, v, a = sp.symbols("t x v a", real=True)

#: ``cos(Omega t + phi)``, of amplitude one; ``t = 0`` at the first switch, ``phi`` unknown.
forcing = sp.Symbol("forcing", real=True)

#: Symbols that are not parameters, with their units.
STATE_UNITS = {x: "m", v: "m/s", a: "m/s^2", forcing: "", t: "s"}


@dataclass(frozen=True)
class Parameter:
    """One parameter of an oscillator.

    Parameters
    ----------
    name : str
        Name for users: ``"mass"``; the flag has dashes for underscores.
    symbol : Symbol
        Symbol in the equations.  Its assumptions are the bounds: positive, nonnegative or real.
        Some names are reserved, such as `N`, the order.
    unit : str
        SI unit, such as ``"N s/m"``; empty for a pure number.
    default : float
        In that unit.
    what : str
        Description in a few words.
    most : float, optional
        Largest value allowed.
    """

    name: str
    symbol: sp.Symbol
    unit: str
    default: float
    what: str
    most: float | None = None


@dataclass(frozen=True)
class Event:
    """The event that ends a phase, and the switch there.

    Parameters
    ----------
    zero : Expr
        Event function, zero at the end of the phase; linear in `x`, `v` (before the switch)
        and `forcing`.
    jump : mapping
        Velocity after the switch: ``{v: -r * v}``, or ``{v: 0}`` into a phase that is held at
        rest; empty if it is continuous.
    demands : mapping of str to Expr
        Expressions that must not be negative at the switch, in the state before it, by words;
        as for a phase.
    to : str
        The phase that follows, where demands leave a choice; ``"-slip"`` is the mirror image of
        ``slip``.
    others : tuple of Event
        Those that may end the phase in its place, each by itself; set by ``one | other``.
    """

    zero: sp.Expr
    jump: Mapping[sp.Symbol, sp.Expr] = field(default_factory=dict)
    demands: Mapping[str, sp.Expr] = field(default_factory=dict)
    to: str = ""
    others: tuple["Event", ...] = ()

    def __or__(self, other: "Event") -> "Event":
        """Return this event, in whose place another one may end the phase."""
        if not isinstance(other, Event):
            return NotImplemented
        return replace(self, others=(*self.others, *other.each))

    @property
    def each(self) -> tuple["Event", ...]:
        """The event and those that may come in its place, each alone."""
        alone = replace(self, others=())
        return alone, *(each for other in self.others for each in other.each)


@dataclass(frozen=True)
class Phase:
    """One phase of the motion.

    Parameters
    ----------
    name : str
        ``"slip"``.
    equation : Expr
        Zero by the equation of motion; linear in `x`, `v`, `a` and `forcing`.  For a `Body` the
        law of its contact, linear in its `force` as well; for several contacts a tuple of laws.
    ends : Event
        The event that ends it; of several, ``one | other``, the one that comes first.
    demands : mapping of str to Expr
        Expressions that must not be negative throughout the phase, by words; linear in `x`,
        `v`, `forcing`, or a bound less the ``Abs`` of such an expression.
    held : Expr, optional
        The velocity prescribed by a constraint.  Then `equation` is `a`, and the phase before
        must lead to this velocity, by its event or by its jump.
    """

    name: str
    equation: sp.Expr
    ends: Event
    demands: Mapping[str, sp.Expr] = field(default_factory=dict)
    held: sp.Expr | None = None

    @property
    def laws(self) -> tuple[sp.Expr, ...]:
        """The equation, or the laws of a body, one for each contact."""
        equation = self.equation
        return tuple(equation) if isinstance(equation, tuple | list) else (equation,)

    @property
    def each_end(self) -> tuple["Phase", ...]:
        """The phase with each of the events that may end it alone: ``slip``, ``slip_by_2``."""
        first, *others = self.ends.each
        numbered = (
            replace(self, name=f"{self.name}_by_{i}", ends=event)
            for i, event in enumerate(others, 2)
        )
        return replace(self, ends=first), *numbered


@dataclass(frozen=True)
class Memory:
    """A constant of the motion that a switch sets anew, such as the offset after yielding.

    Parameters
    ----------
    symbol : Symbol
        Symbol in the equations, real; its value holds until it is set again.
    at : str or tuple of str
        The phase whose begin sets it; or the phases in which it holds: it is set where the
        motion comes to one of them from another phase.
    value : Expr
        The value it is set to, linear in the state there, `x`, `v` (after the switch) and
        `forcing`; a length over a power of time.  If it holds in several phases it may have
        contact forces, those before the switch, and has no constant.
    what : str
        Description in a few words.
    """

    symbol: sp.Symbol
    at: str | tuple[str, ...]
    value: sp.Expr
    what: str


#: Name of the order in which phases are listed, of a scene in which one has several events.
AS_LISTED = "as-listed"


@dataclass(frozen=True)
class SceneData:
    """The fields of a `Scene`, unchecked, and properties that follow from them directly."""

    name: str
    title: str
    parameters: tuple[Parameter, ...]
    phases: tuple[Phase, ...] = ()
    source: str = ""
    frequency: sp.Symbol | None = None
    half_period: bool = False
    requires: Mapping[str, sp.Expr] = field(default_factory=dict)
    scales: Mapping[str, sp.Expr] = field(default_factory=dict)
    guess: tuple[sp.Expr, ...] | Mapping[str, tuple[sp.Expr, ...]] = ()
    motions: Mapping[str, tuple[Phase, ...]] = field(default_factory=dict)
    memory: tuple[Memory, ...] = ()
    start: Mapping[sp.Symbol, sp.Expr] = field(default_factory=dict)
    extremes: Mapping[str, Mapping[sp.Symbol, sp.Expr]] = field(default_factory=dict)
    motion: str = ""
    body: "Body | None" = None

    @property
    def symbols(self) -> tuple[sp.Symbol, ...]:
        """The symbols of the parameters, in their order."""
        return tuple(parameter.symbol for parameter in self.parameters)

    @property
    def contacts(self) -> "tuple[Contact, ...]":
        """The contacts of its body; one mass has none."""
        return () if self.body is None else tuple(self.body.at.values())

    @property
    def sign(self) -> int:
        """The next cell is this times the cell: -1 if the cell is half a period, else 1."""
        return -1 if self.half_period else 1

    def before(self, p: int) -> tuple[int, int]:
        """Return the phase before phase `p` of a cell, and the sign across the switch."""
        return (p - 1, 1) if p else (len(self.phases) - 1, self.sign)

    def after(self, p: int) -> tuple[int, int]:
        """Return the phase behind phase `p` of a cell, and the sign across the switch."""
        return (p + 1, 1) if p + 1 < len(self.phases) else (0, self.sign)

    @property
    def label(self) -> str:
        """Its name, and that of the motion if there are several."""
        return f"{self.name}, {self.motion}" if self.motion else self.name

    @property
    def declared(self) -> Mapping[str, tuple[Phase, ...]]:
        """The orders of phases that it declares, by name; none if there is no other order."""
        is_listed = self.is_open and self.phases and not self.motion
        return {AS_LISTED: self.phases} if is_listed else self.motions

    @property
    def is_open(self) -> bool:
        """Whether demands and events alone decide which phase follows, not declared orders.

        So it is if a phase has several events, or one that says what follows, or if a memory
        holds in several phases.
        """
        phases = (self.phases, *self.motions.values())
        ends = [phase.ends for order in phases for phase in order]
        several = any(event.others or event.to for event in ends)
        return several or any(not isinstance(q.at, str) for q in self.memory)

    @property
    def each_motion(self) -> tuple[Self, ...]:
        """Its motions, each as a scene; itself if it has only one."""
        return tuple(map(self.of_motion, self.declared)) or (self,)

    def of_motion(self, name: str) -> Self:
        """Return one of its motions as a scene."""
        cached: dict[str, Self] = self.__dict__.setdefault("_made", {})
        if name not in cached:
            given, phases = self.guess, self.declared[name]
            guess = given.get(name, ()) if isinstance(given, Mapping) else given
            memory = self.memory
            if any(not isinstance(q.at, str) for q in memory):
                names = [phase.name for phase in phases]
                memory, symbols = settings(memory, names, names, partial(self._set_to, phases))
                phases = tuple(map(with_values, phases, symbols))
            cached[name] = replace(
                self,
                phases=phases,
                motions={},
                motion=name,
                guess=tuple(guess),
                memory=memory,
            )
        return cached[name]

    def setting(self, memory: Memory) -> int:
        """Return the phase that sets a memory; 0 if it holds in several, in no order."""
        names = [phase.name for phase in self.phases]
        return names.index(memory.at) if isinstance(memory.at, str) else 0

    def _set_to(self, phases: Sequence[Phase], memory: Memory, p: int) -> sp.Expr:
        """Return what phase `p` of an order sets a memory to."""
        own = isinstance(memory.at, str)
        return memory.value if own else behind(memory, phases, p, self, self.sign)

    @cached_property
    def cell(self) -> tuple[Phase, ...]:
        """The phases with memories expressed by the values set in this cell.

        Before the switch that sets a memory, its value is that of the cell before: `sign` times
        that of this cell.
        """
        changes: list[dict[sp.Symbol, sp.Expr]] = [{} for _ in self.phases]
        for memory in self.memory:
            for p in range(self.setting(memory)):
                changes[p][memory.symbol] = self.sign * memory.symbol
        return tuple(map(with_values, self.phases, changes))


# A function of a scene.
OfScene = TypeVar("OfScene", bound=Callable[..., Any])


def once(function: OfScene) -> OfScene:
    """Return a function of a scene that is evaluated once for each scene."""

    @wraps(function)
    def kept(scene: SceneData) -> Any:
        found: dict[str, Any] = scene.__dict__.setdefault("_found", {})
        if function.__name__ not in found:
            found[function.__name__] = function(scene)
        return found[function.__name__]

    return kept  # type: ignore[return-value]


def with_values(phase: Phase, values: Mapping[sp.Symbol, sp.Expr]) -> Phase:
    """Return a phase with symbols of the state or memory replaced, except in its jumps."""
    if all(symbol == value for symbol, value in values.items()):
        return phase

    def put(expression: Any) -> Any:
        if isinstance(expression, tuple | list):  # a law for each of several contacts
            return tuple(map(put, expression))
        return sp.sympify(expression).subs(values)

    def all_of(demands: Mapping[str, sp.Expr]) -> dict[str, sp.Expr]:
        return {words: put(demand) for words, demand in demands.items()}

    ends = replace(phase.ends, zero=put(phase.ends.zero), demands=all_of(phase.ends.demands))
    demands = all_of(phase.demands)
    return replace(phase, equation=put(phase.equation), ends=ends, demands=demands)
