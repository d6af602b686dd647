"""The kernel of motions that are polynomials on each phase: one for all scenes and classes."""

import hashlib
import sys
from dataclasses import dataclass
from functools import cache, cached_property
from importlib import import_module
from types import ModuleType
from typing import Any

import numpy as np

from ...generated import ck
from ..arrays import Vector
from ..compiling import Account, rebuilt
from ..maps import together
from ..maps.unseen import combinations
from ..scenes.arrays import arrays_of
from ..scenes.case import Case
from ..scenes.loaded import LoadedScene
from ..scenes.method_names import with_class_one
from ..scenes.methods import About, about
from .kernel import Kernel, compiling
from .linking import MAPS, NEWTON, phase_maps, text_of


@dataclass(frozen=True)
class Layout:
    """Which unknowns a scene has in such a method.

    Parameters
    ----------
    scene : LoadedScene
        Of one motion.
    classes : tuple of int
        The class of the functions that begin each phase.
    method : About
        What is known of the method.
    """

    scene: LoadedScene
    classes: tuple[int, ...]
    method: About

    @property
    def equations(self) -> ModuleType:
        """The generated module."""
        return _module(str(self.method.kernel))

    @cached_property
    def phases(self) -> tuple[tuple[str, bool, int, int], ...]:
        """Name of each phase, whether it is free, its class, and what no test sees of it."""
        rows, unseen = (
            zip(self.scene.module.PHASES, self.classes, strict=True),
            self.method.unseen,
        )
        return tuple(
            (name, not held, k, unseen[k] if unseen and not held else 0)
            for (name, held), k in rows
        )

    @property
    def free(self) -> int:
        """How many phases are free: each order adds as many unknowns."""
        return sum(free for _, free, _, _ in self.phases)

    @property
    def fixed(self) -> int:
        """How many unknowns there are besides."""
        own = sum(2 + (k if free else 0) + left for _, free, k, left in self.phases)
        memory, forced = len(self.scene.module.MEMORY), self.scene.frequency is not None
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
        for i, (name, _, power, _) in enumerate(self.scene.module.MEMORY):
            found[name] = (z[at + i], power)
        return found

    def given(self, case: Case, order: int) -> Any:
        """Return what the functions of the kernel take for a case.

        They are `Arrays`, and what no test sees: `combinations` for each phase.
        """
        sides = [left for _, _, _, left in self.phases]
        after = not case.cell.forced
        arrays = arrays_of(
            case.cell, self.classes, sides, after=after, starts=bool(self.method.unseen)
        )
        tests = [order + k + 1 - max(1, k) for _, _, k, _ in self.phases]
        tables = np.zeros((len(sides), max(tests) if any(sides) else 0, max(sides)))
        for p, (_, _, k, left) in enumerate(self.phases):
            if left:
                found = combinations(self.equations.unseen, tests[p], k, left)
                tables[p, : tests[p], :left] = found
        return (*arrays, tables)


@cache
def kernel(
    scene: LoadedScene, method: str, class_one: bool = False, compile_it: bool = False
) -> Kernel:
    """Return the kernel of a method of this family for a scene of one motion.

    Parameters
    ----------
    scene, method : LoadedScene, str
        The generic name of the method.
    class_one : bool
        Whether functions are of class C^1 at most, where the scene is smoother.
    compile_it : bool
        Whether numba is to compile it; once for all scenes.
    """
    classes = tuple(min(k, 1) if class_one else k for k, _ in scene.module.SWITCHES)
    layout = Layout(scene, classes, about(method))
    name = layout.equations.__name__
    functions = _compiled(name) if compile_it else _plain(name)
    return Kernel(
        method=with_class_one(method) if class_one else method,
        durations=len(classes),
        forced=scene.frequency is not None,
        lowest=layout.lowest,
        size=layout.size,
        residual=functions["residual"],
        jacobian=functions["jacobian"],
        motion=functions["motion"],
        coefficients=layout.coefficients,
        iterate=functions["iterate_together"],
        given=layout.given,
        condensed=True,
        account=None if compile_it else account(method),
        starts=bool(about(method).unseen) and hasattr(scene.module, "start"),
    )


def account(method: str) -> Account:
    """Return what all kernels of a generated module have cost in plain Python."""
    return _account(_module(str(about(method).kernel)).__name__)


@cache
def _account(name: str) -> Account:
    entry = together.iterate_together
    return Account(entry.__code__.co_filename, f"{entry.__name__}_{_fingerprint(name)}")


def _module(kernel: str) -> ModuleType:
    return import_module(f"{ck.__package__}.{kernel}")


def _fingerprint(name: str) -> str:
    """Return a hash of all that is compiled."""
    text = text_of(sys.modules[name], *MAPS, *NEWTON)
    return hashlib.sha256(name.encode() + text).hexdigest()[:16]


@cache
def _plain(name: str) -> dict[str, Any]:
    return phase_maps(sys.modules[name], rebuilt)


@cache
def _compiled(name: str) -> dict[str, Any]:
    _account(name).is_compiled = True
    return phase_maps(sys.modules[name], compiling(_fingerprint(name)))
