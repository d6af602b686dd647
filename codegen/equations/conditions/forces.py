"""Conditions on the contact forces of a body, to be printed."""

from collections.abc import Iterable, Iterator
from dataclasses import replace

import sympy as sp

from ...galerkin import GalerkinConditions
from ...galerkin.bodies.contacts import Contacts, j, pole
from ...galerkin.condition import BodyConditions
from ...system import Equation, line
from .family import Family
from .functions import t

#: State of a pole.
z = sp.Function("z_j")


class Forces(Family):
    """The equations of a body whose contact forces are expanded."""

    conditions: BodyConditions

    @staticmethod
    def fits(conditions: GalerkinConditions) -> bool:
        """Return whether the conditions are those of a body."""
        return isinstance(conditions, BodyConditions)

    def equations(self) -> Iterator[Equation]:
        """Yield the body by its poles, the forces, the conditions, and the tables they use."""
        yield from self._poles()
        yield from self._shown(self.conditions.expansion)
        yield from self.rows
        yield from self._shown(self.conditions.tables)

    def _poles(self) -> Iterator[Equation]:
        scene, contacts, notation = self.scene, Contacts(self.scene), self.notation
        forces = [notation.force(c, t) for c in range(len(contacts.each))]
        pushed = sp.Add(*(contacts.chi(c) * force for c, force in enumerate(forces)))
        words = "the body by its poles, of each pair the one above the real axis"
        yield line(words, (z(t).diff(t), pole[j] * z(t) + pushed), "`j = 1, ..., L`")
        for c, contact in enumerate(contacts.each):
            words = f"displacement of {contact.name}"
            x_c = contacts.summed(contacts.psi(c) * z(t))
            if scene.frequency is not None:
                wave = sp.exp(sp.I * notation.times.angle(t))
                x_c += sp.re(contacts.response(c) * wave)
                words += f"; `{contacts.response(c)}` is its response to the forcing"
            x_c += sp.Add(*(contacts.static(c, d) * force for d, force in enumerate(forces)))
            if contacts.static(c, c) != 0:
                words += (
                    f", `{contacts.static(c, c)}` the static one of modes that are left out"
                )
            yield line(words, (notation.displacement(c, 0, t), x_c))
            for d in range(len(forces)):
                total = contacts.summed(pole[j] * contacts.psi(c) * contacts.chi(d))
                words = f"mobility: the acceleration of {contact.name} by a force"
                yield line(words, (contacts.mobility(c, d), total))

    def _shown(self, rows: Iterable[Equation]) -> Iterator[Equation]:
        for row in rows:
            yield replace(row, sides=tuple(map(self.spelled, row.sides)))
