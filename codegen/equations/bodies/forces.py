"""Conditions on the contact forces of a body for the reader."""

from collections.abc import Iterable, Iterator

import sympy as sp

from ...galerkin import Condition
from ...galerkin.bodies import BodyConditions, Table
from ...galerkin.bodies.contacts import Contacts, L, j, pole
from ...system import Equation
from ..functions import t
from ..notation import Notation
from .of_body import at, displacement, force

#: State of a pole.
z = sp.Function("z_j")


class Forces:
    """The equations of a body whose contact forces are expanded."""

    section = ""

    def __init__(self, conditions: BodyConditions) -> None:
        self.conditions = conditions
        self.notation = Notation.of(conditions.scene)
        self.contacts = Contacts(conditions.scene)

    @staticmethod
    def fits(conditions: object) -> bool:
        """Whether the conditions are those of a body."""
        return isinstance(conditions, BodyConditions)

    def equations(self) -> Iterator[Equation]:
        """Yield the body by its poles, the force, the conditions, what they look up."""
        yield from self._poles()
        yield from self._shown(self.conditions.expansion)
        yield from self._rows()
        yield from self._shown(self.conditions.tables)

    def jacobian(self) -> Iterator[Equation]:
        """Yield nothing: the tables say all, and their rates follow from their recurrences."""
        yield from ()

    def _poles(self) -> Iterator[Equation]:
        scene, contacts = self.conditions.scene, self.contacts
        count = range(len(contacts.each))
        pushed = sp.Add(*(contacts.chi(c) * force(scene, c, t) for c in count))
        words = "the body by its poles, of each pair the one above the real axis"
        yield Equation("", words, (z(t).diff(t), pole[j] * z(t) + pushed), "`j = 1, ..., L`")
        for c, contact in enumerate(contacts.each):
            seen = sp.re(sp.Sum(contacts.psi(c) * z(t), (j, 1, L)))
            if scene.frequency is not None:
                wave = sp.exp(sp.I * self.notation.times.angle(t))
                seen += sp.re(contacts.response(c) * wave)
            seen += sp.Add(*(contacts.static(c, d) * force(scene, d, t) for d in count))
            words = f"displacement of {contact.name}"
            if scene.frequency is not None:
                words += f"; `{contacts.response(c)}` is its response to the forcing"
            if contacts.static(c, c) != 0:
                words += (
                    f", `{contacts.static(c, c)}` the static one of modes that are left out"
                )
            yield Equation("", words, (displacement(scene, c, 0, t), seen))
            for d in count:
                total = sp.re(sp.Sum(pole[j] * contacts.psi(c) * contacts.chi(d), (j, 1, L)))
                words = f"mobility: the acceleration of {contact.name} by a force"
                yield Equation("", words, (contacts.mobility(c, d), total))

    def _shown(self, tables: Iterable[Table]) -> Iterator[Equation]:
        for table in tables:
            sides = map(self._spelled, (table.entry, *table.sides))
            yield Equation("", table.title, tuple(sides), table.where)

    def _spelled(self, side: sp.Expr) -> sp.Expr:
        """Return an expression in which the number of a function is an index."""
        found = {}
        for block in self.conditions.blocks:
            letter, _, word = block.name.partition("_")
            if (
                isinstance(block.symbol, sp.Symbol)
                and letter[:1] == "c"
                and letter[1:].isdigit()
            ):
                found[block.symbol] = sp.IndexedBase(f"c_{word}", real=True)[int(letter[1:])]
        return side.xreplace(found)

    def _rows(self) -> Iterator[Equation]:
        for condition in self.conditions.conditions:
            if condition.name == "cell":
                continue
            row = self._spelled(condition.expression)
            sides = (*self._left(condition), row, sp.Integer(0))
            where = f"`{condition.where}`" if condition.where else ""
            yield Equation("", condition.title, sides, where)

    def _left(self, condition: Condition) -> Iterator[sp.Expr]:
        """Yield the statement of an event, as the scene has it."""
        for p, phase in enumerate(self.conditions.scene.cell):
            if condition.name == f"event_{phase.name}":
                end = self.notation.at(p + 1)
                yield at(self.notation, phase.ends.zero, end, end)
