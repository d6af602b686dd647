"""The types of a scene: parameters, phases with what ends them, and the whole."""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property

import sympy as sp


@dataclass(frozen=True)
class Parameter:
    """One parameter of an oscillator.

    Parameters
    ----------
    name : str
        As users type it: ``"mass"``; a flag is the same with dashes.
    symbol : Symbol
        In the equations.  Its assumptions are the bounds: positive, nonnegative or real.  Some
        names are taken, such as `N`, the order, and what begins with ``at_``.
    unit : str
        SI, such as ``"N s/m"``; empty for a pure number.
    default : float
        In that unit.
    what : str
        What it is, in a few words.
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
    """What ends a phase.

    Parameters
    ----------
    zero : Expr
        Linear in `x`, `v` (before the switch) and `forcing`; zero where the phase ends.
    jump : mapping
        What the switch makes of the velocity: ``{v: -r * v}``, or ``{v: 0}`` into a phase
        that is held at rest; empty where it is continuous.
    demands : mapping of str to Expr
        What must not be negative at the switch, in the state before it, as those of a phase.
    """

    zero: sp.Expr
    jump: Mapping[sp.Symbol, sp.Expr] = field(default_factory=dict)
    demands: Mapping[str, sp.Expr] = field(default_factory=dict)


@dataclass(frozen=True)
class Phase:
    """One phase of the motion.

    Parameters
    ----------
    name : str
        ``"slip"``.
    equation : Expr
        The equation of motion, zero: linear in `x`, `v`, `a` and `forcing`.
    ends : Event
        What ends it.
    demands : mapping of str to Expr
        What must not be negative while it lasts, by the words that say so; linear in `x`,
        `v`, `forcing`, or a bound less the ``Abs`` of such an expression.
    held : Expr, optional
        The velocity at which a constraint holds the mass: then `equation` is `a`, and the
        phase before it must lead to this velocity, by its event or by its jump.
    """

    name: str
    equation: sp.Expr
    ends: Event
    demands: Mapping[str, sp.Expr] = field(default_factory=dict)
    held: sp.Expr | None = None


@dataclass(frozen=True)
class Memory:
    """A constant of the motion that a switch sets anew, such as the offset after yielding.

    Parameters
    ----------
    symbol : Symbol
        In the equations, real; it holds from the switch that sets it to the next that does.
    at : str
        The phase whose beginning sets it.
    value : Expr
        What it is set to: linear in the state there, `x`, `v` (after the switch), `forcing`;
        a length over a power of time.
    what : str
        What it is, in a few words.
    """

    symbol: sp.Symbol
    at: str
    value: sp.Expr
    what: str


@dataclass(frozen=True)
class Scene:
    """An oscillator: its parameters, the phases of its motion in their order, its forcing.

    Parameters
    ----------
    name, title : str
        ``"impact"``, of lower-case letters, digits and dashes; and what it is in a few words.
    parameters : tuple of Parameter
        All symbols of the equations.
    phases : tuple of Phase
        One cell of the motion, from the first switch.  After the last comes the first again.
    source : str
        Where the model is from.
    frequency : Symbol, optional
        Angular frequency of the forcing; without it the oscillator is autonomous.
    half_period : bool
        The cell is half a period, and ``x(t + T/2) = -x(t)``.
    requires : mapping of str to Expr
        What must not be negative of the parameters, by the words that say so.
    scales : mapping of str to Expr
        ``"mass"``, ``"time"`` and ``"length"`` that make the equations dimensionless, in the
        parameters or as numbers in SI units; what is left out is worked out.
    guess : tuple of Expr
        Rough durations of the phases, in the parameters; without it they are worked out.
        Of several motions, a mapping from some of their names to such tuples.
    motions : mapping of str to tuple of Phase
        Several orders of phases, by name, in place of `phases`; any of them may occur.
    memory : tuple of Memory
        Constants that switches set.
    start : mapping of Symbol to Expr
        ``{x: ...}`` or ``{v: ...}``: what the state in which the first phase begins is on the
        exact orbit, if that is known.  Functions that begin at switches impose it in place of
        the event that ends the first phase, as the paper does in (9).
    extremes : mapping of str to mapping of Symbol to Expr
        Where digits are easily lost, by words: the parameters that differ there from those of
        a case, in its parameters or as numbers in SI units.  ``nonsmooth digits`` goes there.
    motion : str
        Which of several motions these `phases` are; see `of_motion`.

    Raises
    ------
    SceneError
        Naming the field that is wrong, what was found and what was expected.
    """

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

    def __post_init__(self) -> None:
        from .check import check  # noqa: PLC0415  (the checks read this type)

        check(self)

    @property
    def symbols(self) -> tuple[sp.Symbol, ...]:
        """The symbols of the parameters, in their order."""
        return tuple(parameter.symbol for parameter in self.parameters)

    @property
    def sign(self) -> int:
        """What the motion is multiplied by from one cell to the next: 1 or -1."""
        return -1 if self.half_period else 1

    @property
    def label(self) -> str:
        """Its name, and that of the motion where there are several."""
        return f"{self.name}, {self.motion}" if self.motion else self.name

    @property
    def each_motion(self) -> "tuple[Scene, ...]":
        """The scene once for each of its motions, as if there were no other; itself if one."""
        return tuple(map(self.of_motion, self.motions)) or (self,)

    def of_motion(self, name: str) -> "Scene":
        """Return the scene with one of its motions alone."""
        made: dict[str, Scene] = self.__dict__.setdefault("_made", {})
        if name not in made:
            guess = self.guess.get(name, ()) if isinstance(self.guess, Mapping) else ()
            phases = self.motions[name]
            made[name] = replace(
                self, phases=phases, motions={}, motion=name, guess=tuple(guess)
            )
        return made[name]

    @cached_property
    def cell(self) -> tuple[Phase, ...]:
        """The phases with the values of the memory that they have there.

        Before the switch that sets it, a phase has the value of the cell before, which is this
        one's times `sign`.
        """
        changes: list[dict[sp.Symbol, sp.Expr]] = [{} for _ in self.phases]
        names = [phase.name for phase in self.phases]
        for memory in self.memory:
            for p in range(names.index(memory.at)):
                changes[p][memory.symbol] = self.sign * memory.symbol
        return tuple(map(_with_memory, self.phases, changes))


def _with_memory(phase: Phase, values: Mapping[sp.Symbol, sp.Expr]) -> Phase:
    """Return a phase with other values of the memory."""
    if all(symbol == value for symbol, value in values.items()):
        return phase

    def put(expression: sp.Expr) -> sp.Expr:
        return sp.sympify(expression).subs(values)

    def all_of(demands: Mapping[str, sp.Expr]) -> dict[str, sp.Expr]:
        return {words: put(demand) for words, demand in demands.items()}

    ends = replace(phase.ends, zero=put(phase.ends.zero), demands=all_of(phase.ends.demands))
    demands = all_of(phase.demands)
    return replace(phase, equation=put(phase.equation), ends=ends, demands=demands)
