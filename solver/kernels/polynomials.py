"""The kernel of motions that are polynomials on each phase: one for all scenes and classes."""

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from functools import cache, cached_property
from math import prod
from typing import Any, ClassVar

import numpy as np

from ..arrays import Matrix, Vector
from ..maps import together
from ..scenes.arrays import arrays_of
from ..scenes.case import Case
from ..scenes.loaded import LoadedScene
from ..scenes.methods import SMOOTHEST, about, module_of, with_class_one
from . import linking
from .compiling import rebuilt
from .family import Family

FAMILY = Family(linking.phase_maps, linking.MAPS + linking.NEWTON, together.iterate_together)


@dataclass(frozen=True)
class Layout:
    """The unknowns of a scene of one motion in such a method.

    Parameters
    ----------
    scene : LoadedScene
    method : str
        Generic name.
    class_one : bool
        Whether functions are of class C^1 though the scene is smoother.
    """

    scene: LoadedScene
    method: str
    class_one: bool = False

    #: As for all kernels of such methods; see `Kernel`.
    family: ClassVar[Family] = FAMILY
    condensed: ClassVar[bool] = True

    @property
    def name(self) -> str:
        """Name of the method in the kernel."""
        return with_class_one(self.method) if self.class_one else self.method

    @property
    def starts(self) -> bool:
        """Whether the scene's start is imposed in place of the first event."""
        return bool(about(self.method).unseen) and self.scene.has_start

    @property
    def classes(self) -> tuple[int, ...]:
        """The k of the class C^k of the functions at the begin of each phase."""
        most = 1 if self.class_one else SMOOTHEST
        return tuple(min(k, most) for k in self.scene.classes)

    @cached_property
    def phases(self) -> tuple[tuple[str, bool, int, int], ...]:
        """Name of each phase, whether it is free, its class, number of unseen polynomials."""
        unseen = about(self.method).unseen
        return tuple(
            (name, not held, k, unseen[k] if unseen and not held else 0)
            for (name, held), k in zip(self.scene.kinds, self.classes, strict=True)
        )

    @property
    def free(self) -> int:
        """Number of free phases: of unknowns that each order adds."""
        return sum(free for _, free, _, _ in self.phases)

    @property
    def fixed(self) -> int:
        """Number of unknowns that does not depend on the order."""
        of_phases = sum(2 + (k if free else 0) + left for _, free, k, left in self.phases)
        memory, forced = len(self.scene.memory), self.scene.frequency is not None
        return of_phases + memory + len(self.phases) + forced

    @property
    def lowest(self) -> int:
        """The lowest order, at which each free phase has two rows of its residual."""
        return max(1, *(1 + max(1, k) - k for _, free, k, _ in self.phases if free))

    def size(self, order: int) -> int:
        """Return the number of unknowns."""
        return order * self.free + self.fixed

    def coefficients(self, z: Vector) -> dict[str, tuple[Any, int]]:
        """Return the coefficients by name, each with the power of 1/time in its unit."""
        order, by_name, at = (len(z) - self.fixed) // self.free, {}, 0
        for name, free, k, left in self.phases:
            by_name[f"x_{name}"], by_name[f"v_{name}"] = (z[at], 0), (z[at + 1], 1)
            at += 2
            if free:
                by_name[f"d_{name}"] = (z[at : at + order + k], 2)
                at += order + k
            for i in range(left):
                by_name[f"tau{i}_{name}"] = (z[at + i], 2)
            at += left
        for i, (name, _, power, _) in enumerate(self.scene.memory):
            by_name[name] = (z[at + i], power)
        return by_name

    def given(self, case: Case, order: int) -> Any:
        """Return the first argument of the kernel's functions for a case.

        It is `Arrays` with a further one: `combinations` of each phase.
        """
        sides = [left for _, _, _, left in self.phases]
        after = not case.cell.forced
        arrays = arrays_of(
            case.cell, self.classes, sides, after=after, starts=bool(about(self.method).unseen)
        )
        tests = [order + k + 1 - max(1, k) for _, _, k, _ in self.phases]
        tables = np.zeros((len(sides), max(tests) if any(sides) else 0, max(sides)))
        for p, (_, _, k, left) in enumerate(self.phases):
            if left:
                Z = combinations(module_of(self.method).unseen, tests[p], k, left)
                tables[p, : tests[p], :left] = Z
        return (*arrays, tables)


def _rising(x: int, k: int) -> Fraction:
    """Return the rising factorial ``x (x + 1) ... (x + k - 1)``."""
    return Fraction(prod(range(x, x + k)))


@cache
def combinations(
    unseen: Callable[[int, int, int], float], rows: int, k: int, count: int
) -> Matrix:
    """Return the matrix Z, shape (rows, count), of a residual orthogonal to all tests.

    Such a residual, on a phase that begins C^k, is a combination of `count` polynomials of
    degrees from `rows` on.  Its Legendre coefficients below `rows` are Z times those from
    `rows` on.  The coefficients of the polynomials are ``unseen(m, l, k)`` of a generated
    module, triangular in the rows from `rows` on.  Entries are exact to rounding.

    Examples
    --------
    >>> from nonsmooth.generated.ck import unseen
    >>> combinations(unseen, 2, 0, 1).tolist()
    [[0.2], [-0.6]]
    """
    weight = rebuilt(unseen, {"rising": _rising})
    above = range(rows, rows + count)
    Z = np.empty((rows, count))
    for l in range(rows):
        row: list[Fraction] = []
        for m in above:
            pairs = zip(row, above, strict=False)
            earlier = sum(q * Fraction(weight(m, degree, k)) for q, degree in pairs)
            row.append((Fraction(weight(m, l, k)) - earlier) / Fraction(weight(m, m, k)))
        Z[l] = [float(q) for q in row]
    Z.flags.writeable = False
    return Z
