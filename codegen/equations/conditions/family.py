"""The conditions of a scene in an expansion, for the reader: what its families share."""

from abc import ABC, abstractmethod
from collections.abc import Iterator, Mapping
from functools import cached_property

import sympy as sp

from ...galerkin import Block, Condition, GalerkinConditions
from ...galerkin.closure import START, differentiated, law
from ...scene import v, x
from ...system import Equation
from ..notation import Notation
from ..switching import event, event_after, set_to
from .functions import state


class Family(ABC):
    """The equations of a scene whose unknowns are of one kind."""

    #: Of the paper.
    section = ""

    def __init__(self, conditions: GalerkinConditions) -> None:
        self.conditions, self.scene = conditions, conditions.scene
        self.notation = Notation.of(conditions.scene)

    @staticmethod
    @abstractmethod
    def fits(conditions: GalerkinConditions) -> bool:
        """Whether the unknowns of some conditions are of this kind."""

    @abstractmethod
    def equations(self) -> Iterator[Equation]:
        """Yield the expansion, the residual, the conditions, and what they look up."""

    def jacobian(self) -> Iterator[Equation]:
        """Yield the derivatives by the times of what the conditions look up, if shown."""
        yield from ()

    def closed(self, condition: Condition) -> sp.Expr:
        """Return the closed form of a condition: itself, if it is one."""
        return condition.expression

    def tested(self, condition: Condition) -> tuple[sp.Expr, ...]:
        """Return the left side of a condition of orthogonality, if the title is not enough."""
        return ()

    def title(self, condition: Condition) -> str:
        """Return what a condition says."""
        return condition.title

    @property
    def numbers(self) -> Mapping[str, str]:
        """The numbers of the paper by the names of conditions."""
        return self.notation.numbers

    @cached_property
    def statements(self) -> Mapping[str, sp.Expr]:
        """The statements on the motion that are zero, by the names of conditions."""
        return statements(self.notation)

    @cached_property
    def rows(self) -> tuple[Equation, ...]:
        """Each condition, from its statement to its closed form, but for the period."""
        own = (q for q in self.conditions.conditions if q.name != "cell")
        return tuple(map(self._row, own))

    def _row(self, condition: Condition) -> Equation:
        known = self.statements.get(condition.name)
        left = self.tested(condition) if known is None else (known,)
        closed = self.spelled(self.closed(condition))
        where = f"`{condition.where}`" if condition.where else ""
        number = condition.number or self.numbers.get(condition.name, "")
        return Equation(number, self.title(condition), (*left, closed, sp.Integer(0)), where)

    def spelled(self, expression: sp.Expr) -> sp.Expr:
        """Return an expression with the unknowns as they are shown."""
        return expression.xreplace({q.symbol: shown(q) for q in self.conditions.blocks})


def shown(block: Block) -> sp.Expr:
    """Return an unknown as it is shown: what is numbered, ``c2_flight``, with an index."""
    name, _, word = block.name.partition("_")
    letters = name.rstrip("0123456789")
    if not word or letters == name:
        return block.symbol
    return sp.IndexedBase(f"{letters}_{word}", real=True)[int(name.removeprefix(letters))]


def statements(notation: Notation) -> dict[str, sp.Expr]:
    """Return continuity, laws of the velocity, events and memory; of a body, its events."""
    found: dict[str, sp.Expr] = {}
    for p, phase in enumerate(notation.scene.phases):
        found[f"event_{phase.name}"] = event(notation, p)
    if notation.scene.body is not None:
        return found
    about = notation.scene, notation.times
    for p, switch in enumerate(notation.found):
        name = switch.before
        velocity = notation.start(p, 1) - law(notation.scene, p, notation.end)
        found[f"impact_{name}"] = velocity
        found[f"velocity_{name}"] = _jump(notation, p, 1) if switch.k else velocity
        for order in (0, *range(2, switch.k + 1)):
            key = f"derivative_{order}_{name}" if order else f"displacement_{name}"
            found[key] = _jump(notation, p, order)
        for order in range(switch.jumps, switch.jumps + 9):
            found[f"jump_{order}_{name}"] = differentiated(
                *about, p, order, notation.start, notation.end, notation.at
            )
    for p, phase in enumerate(notation.scene.phases):
        found[f"event_{phase.name}_after"] = event_after(notation, p)
    for symbol, value in notation.scene.start.items():
        found[START] = notation.start(0, (x, v).index(symbol)) - value
    for memory in notation.scene.memory:
        found[f"memory_{memory.symbol}"] = memory.symbol - set_to(notation, memory)
    return found


def _jump(notation: Notation, p: int, order: int) -> sp.Expr:
    """Return a derivative where phase `p` begins, less that where the one before it ends."""
    if p == 0:
        end = notation.end(len(notation.found) - 1, order)
        return notation.start(p, order) - notation.scene.sign * end
    return state(order, notation.side(p, "+")) - state(order, notation.side(p, "-"))
