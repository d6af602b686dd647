"""Structures with one attachment: the paper's idea in space (Sections 1 and 3.3, footnote 2).

Input: a structure as data (`data`, `structures`).  Derived by SymPy, a module each:

1. `green`: the exact response of the bare structure to a unit load at `a`;
2. `matching`: the matching conditions at `a`, their determinant, the characteristic equation;
3. `forced_modes`: the forced modes, polynomials on each side of `a`, their sums; Ritz with
   them as one scalar equation, and its rates;
4. `series`: functions of class C^k only, as Legendre pieces.

Output: a module of ``generated/space/`` for each structure (`emission`), and the equations for
a reader (`equations`).
"""

from .data import Bare, Structure
from .structures import STRUCTURES, structure_named

__all__ = ["STRUCTURES", "Bare", "Structure", "structure_named"]
