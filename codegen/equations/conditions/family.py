"""The common part of all families of conditions, to be printed."""

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

    #: Section of the paper.
    section = ""

    def __init__(self, conditions: GalerkinConditions) -> None:
        self.conditions, self.scene = conditions, conditions.scene
        self.notation = Notation(conditions.scene)

    @staticmethod
    @abstractmethod
    def fits(conditions: GalerkinConditions) -> bool:
        """Return whether the unknowns of some conditions are of this kind."""

    @abstractmethod
    def equations(self) -> Iterator[Equation]:
        """Yield the expansion, the residual, the conditions, and the tables they use."""

    def jacobian(self) -> Iterator[Equation]:
        """Yield the derivatives of the tables by the times; none by default."""
        yield from ()

    def closed(self, condition: Condition) -> sp.Expr:
        """Return the closed form of a condition, by default the condition itself."""
        return condition.expression

    def tested(self, condition: Condition) -> tuple[sp.Expr, ...]:
        """Return the inner product of a condition of orthogonality; () by default."""
        return ()

    def title(self, condition: Condition) -> str:
        """Return the title of a condition."""
        return condition.title

    @property
    def numbers(self) -> Mapping[str, str]:
        """Equation numbers of the paper by names of conditions."""
        return self.notation.numbers

    @cached_property
    def statements(self) -> Mapping[str, sp.Expr]:
        """Expressions in the motion that are zero by conditions, by their names."""
        return statements(self.notation)

    @cached_property
    def rows(self) -> tuple[Equation, ...]:
        """Each condition, from its statement to its closed form, except that of the period."""
        conditions = (q for q in self.conditions.conditions if q.name != "cell")
        return tuple(map(self._row, conditions))

    def _row(self, condition: Condition) -> Equation:
        statement = self.statements.get(condition.name)
        sides = self.tested(condition) if statement is None else (statement,)
        closed = self.spelled(self.closed(condition))
        where = f"`{condition.where}`" if condition.where else ""
        number = condition.number or self.numbers.get(condition.name, "")
        return Equation(number, self.title(condition), (*sides, closed, sp.Integer(0)), where)

    def spelled(self, expression: sp.Expr) -> sp.Expr:
        """Return an expression with the unknowns as they are printed."""
        return expression.xreplace({q.symbol: shown(q) for q in self.conditions.blocks})


def shown(block: Block) -> sp.Expr:
    """Return an unknown as it is printed; one with a number, ``c2_flight``, with an index."""
    name, _, word = block.name.partition("_")
    letters = name.rstrip("0123456789")
    if not word or letters == name:
        return block.symbol
    return sp.IndexedBase(f"{letters}_{word}", real=True)[int(name.removeprefix(letters))]


def statements(notation: Notation) -> dict[str, sp.Expr]:
    """Return continuity, jump laws, events and memories, by name; for a body only events."""
    expressions: dict[str, sp.Expr] = {}
    for p, phase in enumerate(notation.scene.phases):
        expressions[f"event_{phase.name}"] = event(notation, p)
    if notation.scene.body is not None:
        return expressions
    about = notation.scene, notation.times
    for p, switch in enumerate(notation.switches):
        name = switch.before
        velocity = notation.start(p, 1) - law(notation.scene, p, notation.end)
        expressions[f"impact_{name}"] = velocity
        expressions[f"velocity_{name}"] = _jump(notation, p, 1) if switch.k else velocity
        for order in (0, *range(2, switch.k + 1)):
            key = f"derivative_{order}_{name}" if order else f"displacement_{name}"
            expressions[key] = _jump(notation, p, order)
        for order in range(switch.jumps, switch.jumps + 9):
            expressions[f"jump_{order}_{name}"] = differentiated(
                *about, p, order, notation.start, notation.end, notation.at
            )
    for p, phase in enumerate(notation.scene.phases):
        expressions[f"event_{phase.name}_after"] = event_after(notation, p)
    for symbol, value in notation.scene.start.items():
        expressions[START] = notation.start(0, (x, v).index(symbol)) - value
    for memory in notation.scene.memory:
        expressions[f"memory_{memory.symbol}"] = memory.symbol - set_to(notation, memory)
    return expressions


def _jump(notation: Notation, p: int, order: int) -> sp.Expr:
    """Return the jump of a derivative at the begin of phase `p`."""
    if p == 0:
        end = notation.end(len(notation.switches) - 1, order)
        return notation.start(p, order) - notation.scene.sign * end
    return state(order, notation.side(p, "+")) - state(order, notation.side(p, "-"))
