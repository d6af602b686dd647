"""Notation of printed equations: times of switches ``0, t1, ..., T`` as in the paper.

For the paper's scene also its equation numbers.
"""

import sympy as sp

from ..galerkin import Times
from ..galerkin.bodies.contacts import Contacts
from ..scene import Scene, switches
from ..scenes import numbers_of
from .conditions.functions import T, omega_0, state


class Notation:
    """Symbols of a scene for times, derivatives and forces."""

    def __init__(self, scene: Scene) -> None:
        self.scene, self.times, self.switches = scene, Times.of(scene), switches(scene)
        #: Equation numbers of the paper by names of rows; see `scenes.numbers_of`.
        self.numbers = numbers_of(scene)

    @property
    def cell(self) -> sp.Expr:
        """The end of the cell: the period, or half of it."""
        return self.at(len(self.switches))

    def at(self, p: int) -> sp.Expr:
        """Return the time at which phase `p` begins; for ``p = P`` the end of the cell."""
        if p == 0:
            return sp.Integer(0)
        if p == len(self.switches) and self.times.sign == 1:
            return T
        return sp.Symbol(f"t{p}", positive=True)

    def side(self, p: int, sign: str) -> sp.Symbol:
        """Return the time of a switch as a left, ``-``, or right, ``+``, limit."""
        return sp.Symbol(f"{self.at(p)}^{sign}", positive=True)

    def start(self, p: int, order: int) -> sp.Expr:
        """Return a derivative of the displacement where phase `p` begins."""
        continuous = order <= self.switches[p].k
        return state(order, self.at(p) if continuous else self.side(p, "+"))

    def end(self, p: int, order: int) -> sp.Expr:
        """Return a derivative of the displacement where phase `p` ends."""
        continuous = order <= self.switches[self.scene.after(p)[0]].k
        return state(order, self.at(p + 1) if continuous else self.side(p + 1, "-"))

    def displacement(self, c: int, order: int, time: sp.Expr) -> sp.Expr:
        """Return a derivative of the displacement of contact `c`, which is x for the first."""
        if c == 0:
            return state(order, time)
        name = self.scene.contacts[c].x.name
        return sp.Function(name + "'" * order)(time)

    def force(self, c: int, time: sp.Expr) -> sp.Expr:
        """Return the force at contact `c`, which is f if it is the only one."""
        return sp.Function(Contacts(self.scene).name("f", c))(time)

    def during(self, p: int) -> str:
        """Return the time interval of phase `p`, as text."""
        return f"`{self.at(p)} <= t < {self.at(p + 1)}`"

    def in_times(self, expression: sp.Expr) -> sp.Expr:
        """Return an expression in the times of the switches and ``omega_0``."""
        durations = {s: self.at(p + 1) - self.at(p) for p, s in enumerate(self.times.durations)}
        moved = expression.subs(durations, simultaneous=True)
        half_turns = self.times.sign + 1 or 1
        return moved.replace(
            lambda part: part.is_Mul and part.has(sp.pi) and part.has(1 / self.cell),
            lambda part: self._in_frequency(part, half_turns),
        )

    def _in_frequency(self, product: sp.Expr, turns: int) -> sp.Expr:
        """Return a product with ``turns*pi/cell`` written as ``omega_0``."""
        powers = product.as_powers_dict()
        count = min(powers[sp.pi], -powers[self.cell])
        if count <= 0:
            return product
        return sp.expand_mul(product * (omega_0 * self.cell / (turns * sp.pi)) ** count)
