"""Kernels of motions that are one series over the period: one for all scenes of a method."""

from dataclasses import dataclass
from typing import Any, ClassVar

from ..arrays import Vector
from ..scenes.arrays import arrays_of
from ..scenes.case import Case
from ..scenes.loaded import LoadedScene
from ..scenes.methods import about
from . import linking
from .family import Family, solved_by_newton

FAMILY = solved_by_newton(*linking.SERIES)
ONE_FUNCTION = solved_by_newton(*linking.WITH_ONE)


@dataclass(frozen=True)
class Layout:
    """The unknowns of a scene in such a method, with `functions` added to the harmonics."""

    scene: LoadedScene
    method: str
    functions: int

    #: See `Kernel`.
    condensed: ClassVar[bool] = False
    starts: ClassVar[bool] = False
    lowest: ClassVar[int] = 1

    @property
    def family(self) -> Family:
        """The family of its kernel."""
        return ONE_FUNCTION if about(self.method).alone else FAMILY

    @property
    def name(self) -> str:
        """Name of the method in the kernel."""
        return self.method

    @property
    def classes(self) -> tuple[int, ...]:
        """The k of the class C^k of the motion at the begin of each phase."""
        return self.scene.classes

    @property
    def half(self) -> bool:
        """Whether the cell is half a period: then only odd harmonics occur."""
        return self.scene.half_period

    @property
    def single(self) -> list[tuple[str, int]]:
        """The unknowns between harmonics and times, with powers of 1/time in their units."""
        names: list[tuple[str, int]] = []
        for (name, _), k in zip(self.scene.kinds, self.classes, strict=True):
            if k == 0 and not self.functions:
                names.append((f"J_{name}", 1))
            names += [(f"c{k + 2 + i}_{name}", 0) for i in range(self.functions)]
        if about(self.method).alone:
            names = [("c1", 0)]
        return names + [(name, power) for name, _, power, _ in self.scene.memory]

    @property
    def fixed(self) -> int:
        """Number of unknowns that does not depend on the order."""
        times = len(self.classes) + (self.scene.frequency is not None)
        return (not self.half) + len(self.single) + times

    def size(self, order: int) -> int:
        """Return the number of unknowns; of half a period the order is the highest harmonic."""
        return 2 * ((order + 1) // 2 if self.half else order) + self.fixed

    def coefficients(self, z: Vector) -> dict[str, tuple[Any, int]]:
        """Return the coefficients by name, each with the power of 1/time in its unit."""
        number, at = (len(z) - self.fixed) // 2, 0
        by_name: dict[str, tuple[Any, int]] = {}
        if not self.half:
            by_name["a0"], at = (z[0], 0), 1
        for name in ("a", "b"):
            by_name[name] = z[at : at + number], 0
            at += number
        for i, (name, power) in enumerate(self.single):
            by_name[name] = z[at + i], power
        return by_name

    def given(self, case: Case, order: int) -> Any:
        """Return the first argument of the kernel's functions for a case."""
        beside = [self.functions] * len(self.classes)
        return tuple(arrays_of(case.cell, self.classes, beside))
