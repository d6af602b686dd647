"""What a structure is: a bare beam or string, and the one thing attached to it."""

from dataclasses import dataclass

import sympy as sp

from ..scene import Parameter

#: Dimensionless place on the structure, place of the load and of the attachment, the rest.
x, xi, a, b = sp.symbols("x xi a b", positive=True)

#: Wave number times length, eigenvalue, and strength of the attachment.
beta, lam, s = sp.symbols("beta lambda s", positive=True)

#: Its length, in metres.
L = sp.Symbol("L", positive=True)


@dataclass(frozen=True)
class Bare:
    """A uniform structure without an attachment, simply supported or fixed at both ends.

    Parameters
    ----------
    name : str
    m : int
        Half the order of its equation: ``(-1)^m u^(2m) = lambda u``, with
        ``lambda = beta^(2m)``; 2 for a beam, 1 for a string, a rod or a cable.
    parameters : tuple of Parameter
        Length, stiffness or tension, mass a length.
    frequency : Expr
        Angular frequency over ``beta^m``.
    restoring : Symbol
        What multiplies ``u^(m)`` in its internal force or moment.
    """

    name: str
    m: int
    parameters: tuple[Parameter, ...]
    frequency: sp.Expr
    restoring: sp.Symbol


@dataclass(frozen=True)
class Structure:
    """A bare structure with one thing attached at ``x = a``.

    Parameters
    ----------
    name, title : str
    bare : Bare
    felt : int
        The derivative ``j`` of the displacement that the attachment feels.
    kind : {"stiffness", "inertia", "compliance"}
        Whether it answers the felt derivative (stiffness), its acceleration (inertia), or
        yields in the broken derivative (compliance).
    attached : Parameter
        What it is in SI units.
    strength : Expr
        Its dimensionless strength ``s``.
    source : str
        Where it is treated.
    """

    name: str
    title: str
    bare: Bare
    felt: int
    kind: str
    attached: Parameter
    strength: sp.Expr
    source: str = ""

    @property
    def m(self) -> int:
        """Half the order of the equation."""
        return self.bare.m

    @property
    def broken(self) -> int:
        """The derivative that jumps at ``a``: the boundary terms pair it with the felt one."""
        return 2 * self.m - 1 - self.felt

    @property
    def k(self) -> int:
        """The class: every derivative below the broken one is continuous."""
        return self.broken - 1

    @property
    def jump_of_load(self) -> int:
        """The jump of the broken derivative under a unit load: 1 or -1."""
        return int((-1) ** (self.m + self.felt))

    @property
    def load(self) -> sp.Expr:
        """The load of the attachment where the felt derivative is one."""
        return {"stiffness": -s, "inertia": s * lam, "compliance": s}[self.kind]

    @property
    def law(self) -> sp.Expr:
        """The factor in ``[u^(2m-1-j)] = factor u^(j)(a)``."""
        return self.jump_of_load * self.load

    def equation(self, G: sp.Expr) -> sp.Expr:
        """Return the equation of the attached structure by its receptance: zero."""
        return 1 - self.load * G

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        """All its parameters in SI units."""
        return (*self.bare.parameters, self.attached)
