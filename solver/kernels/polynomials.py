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
from ..scenes.methods import about, module_of, with_class_one
from . import linking
from .compiling import rebuilt
from .family import Family

FAMILY = Family(linking.phase_maps, linking.MAPS + linking.NEWTON, together.iterate_together)


@dataclass(frozen=True)
class Layout:
    """Which unknowns a scene of one motion has in such a method, by its generic name.

    `class_one` says that functions are of class C^1 at most, where the scene is smoother.
    """

    scene: LoadedScene
    method: str
    class_one: bool = False

    #: What its kernels share; see `Kernel`.
    family: ClassVar[Family] = FAMILY
    condensed: ClassVar[bool] = True

    @property
    def name(self) -> str:
        """What the kernel calls the method."""
        return with_class_one(self.method) if self.class_one else self.method

    @property
    def starts(self) -> bool:
        """Whether the scene's start is imposed in place of the first event."""
        return bool(about(self.method).unseen) and self.scene.has_start

    @property
    def classes(self) -> tuple[int, ...]:
        """The class of the functions that begin each phase."""
        return tuple(min(k, 1) if self.class_one else k for k in self.scene.classes)

    @cached_property
    def phases(self) -> tuple[tuple[str, bool, int, int], ...]:
        """Name of each phase, whether it is free, its class, and what no test sees of it."""
        unseen = about(self.method).unseen
        return tuple(
            (name, not held, k, unseen[k] if unseen and not held else 0)
            for (name, held), k in zip(self.scene.kinds, self.classes, strict=True)
        )

    @property
    def free(self) -> int:
        """How many phases are free: each order adds as many unknowns."""
        return sum(free for _, free, _, _ in self.phases)

    @property
    def fixed(self) -> int:
        """How many unknowns there are besides."""
        own = sum(2 + (k if free else 0) + left for _, free, k, left in self.phases)
        memory, forced = len(self.scene.memory), self.scene.frequency is not None
        return own + memory + len(self.phases) + forced

    @property
    def lowest(self) -> int:
        """The lowest order: two rows of the residual of a phase are there at any."""
        return max(1, *(1 + max(1, k) - k for _, free, k, _ in self.phases if free))

    def size(self, order: int) -> int:
        """Return the number of unknowns."""
        return order * self.free + self.fixed

    def coefficients(self, z: Vector) -> dict[str, tuple[Any, int]]:
        """Return the coefficients by name, each with the power of 1/time in its unit."""
        order, found, at = (len(z) - self.fixed) // self.free, {}, 0
        for name, free, k, left in self.phases:
            found[f"x_{name}"], found[f"v_{name}"] = (z[at], 0), (z[at + 1], 1)
            at += 2
            if free:
                found[f"d_{name}"] = (z[at : at + order + k], 2)
                at += order + k
            for i in range(left):
                found[f"tau{i}_{name}"] = (z[at + i], 2)
            at += left
        for i, (name, _, power, _) in enumerate(self.scene.memory):
            found[name] = (z[at + i], power)
        return found

    def given(self, case: Case, order: int) -> Any:
        """Return what the functions of the kernel take for a case.

        They are `Arrays`, and what no test sees: `combinations` for each phase.
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
                found = combinations(module_of(self.method).unseen, tests[p], k, left)
                tables[p, : tests[p], :left] = found
        return (*arrays, tables)


def _rising(x: int, k: int) -> Fraction:
    return Fraction(prod(range(x, x + k)))


@cache
def combinations(
    unseen: Callable[[int, int, int], float], rows: int, k: int, count: int
) -> Matrix:
    """Return Z: what coefficients from `rows` on of the residual make of those before.

    A residual that is orthogonal to all tests of a phase that begins C^k is a combination of as
    many polynomials as `count`; their weights by degree, ``unseen(m, l, k)`` of a generated
    module, are a triangle at the top.  Shape (rows, count), each to rounding.

    Examples
    --------
    >>> from nonsmooth.generated.ck import unseen
    >>> combinations(unseen, 2, 0, 1).tolist()
    [[0.2], [-0.6]]
    """
    weight = rebuilt(unseen, {"rising": _rising})
    above = range(rows, rows + count)
    found = np.empty((rows, count))
    for l in range(rows):
        row: list[Fraction] = []
        for m in above:
            pairs = zip(row, above, strict=False)
            taken = sum(q * Fraction(weight(m, degree, k)) for q, degree in pairs)
            row.append((Fraction(weight(m, l, k)) - taken) / Fraction(weight(m, m, k)))
        found[l] = [float(q) for q in row]
    found.flags.writeable = False
    return found
