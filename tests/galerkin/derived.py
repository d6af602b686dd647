"""Kernels of the scenes of the references, derived once in a process."""

import json
import types
from dataclasses import dataclass
from functools import cache
from itertools import product
from pathlib import Path

import numpy as np
from galerkin.oscillators import SCENES

from nonsmooth.codegen.emission.kernel import module_source
from nonsmooth.codegen.emission.scene_numbers import scene_source
from nonsmooth.codegen.expansions import ck, ck_tau, hb, hb_c1, hb_ck
from nonsmooth.codegen.galerkin import GalerkinConditions
from nonsmooth.solver.kernels import polynomials
from nonsmooth.solver.kernels.kernel import Kernel
from nonsmooth.solver.scenes.cell import cell_of
from nonsmooth.solver.scenes.loaded import LoadedScene

REFERENCES = json.loads(Path(__file__).with_name("references.json").read_text("utf-8"))

#: What derives a kernel, by its name.
DERIVE = {
    "ck_tau": ck_tau.derive,
    "ck": ck.derive,
    "hb": hb.derive,
    "hb_c1": hb_c1.derive,
    "hb_ck_1": lambda scene: hb_ck.derive(scene, 1),
    "hb_ck_2": lambda scene: hb_ck.derive(scene, 2),
}

#: Those that are one kernel for any scene.
OF_ANY_SCENE = ("ck_tau", "ck")

#: The oscillators of a kernel that is made for some alone.
ONLY = {"hb_c1": ("S0",)}


def pairs(names):
    """Return each oscillator with each kernel that there is for it."""
    found = product(names, DERIVE)
    return [(name, kernel) for name, kernel in found if name in ONLY.get(kernel, names)]


def conditions(name: str, kernel: str) -> GalerkinConditions:
    """Return the conditions of a scene of the references."""
    return _derived(SCENES[name][0].label, kernel)


@cache
def _derived(scene: str, kernel: str) -> GalerkinConditions:
    return DERIVE[kernel](_scene(scene))


def _scene(label: str):
    return next(q for q, _ in SCENES.values() if q.label == label)


@cache
def loaded(label: str) -> LoadedScene:
    """Return a scene of the references in numbers."""
    made = types.ModuleType(label)
    exec(scene_source(_scene(label)), made.__dict__)
    return LoadedScene(made, Path("nowhere"))


@dataclass(frozen=True)
class OfAnyScene:
    """A kernel of any scene with a scene's parameters for a case, as modules of one have it."""

    kernel: Kernel
    scene: LoadedScene

    def __post_init__(self):
        for name in ("durations", "forced", "lowest"):
            object.__setattr__(self, name.upper(), getattr(self.kernel, name))
        object.__setattr__(self, "size", self.kernel.size)

    def given(self, case, z):
        """Return the arrays of the parameters, and of the cycles behind them."""
        count = len(self.scene.parameters)
        cell = cell_of(self.scene, tuple(case[:count]), *case[count:])
        order = next(n for n in range(1, 1000) if self.kernel.size(n) == len(z))
        return self.kernel.given(types.SimpleNamespace(cell=cell), order)

    def residual(self, case, z, R):
        self.kernel.residual(self.given(case, z), z, R)

    def jacobian(self, case, z, J):
        self.kernel.jacobian(self.given(case, z), z, J)

    def motion(self, case, z, p, u, derivative):
        return self.kernel.motion(self.given(case, z), z, p, u, derivative)

    def iterate(self, case, z, limit=40):
        with np.errstate(all="ignore"):
            return self.kernel.iterate(self.given(case, z), z, limit)


def source(name: str, kernel: str) -> str:
    """Return the text of a kernel of a scene of the references."""
    return _source(SCENES[name][0].label, kernel)


@cache
def _source(scene: str, kernel: str) -> str:
    return module_source(_derived(scene, kernel))


def module(name: str, kernel: str, class_one: bool = False):
    """Return a kernel of a scene of the references: a module of plain Python, or as one."""
    label = SCENES[name][0].label
    if kernel in OF_ANY_SCENE:
        scene = loaded(label)
        made = polynomials.kernel(scene, kernel.replace("_", "-"), class_one)
        return OfAnyScene(made, scene)
    return _module(label, kernel)


@cache
def _module(scene: str, kernel: str) -> types.ModuleType:
    made = types.ModuleType(f"{scene}_{kernel}")
    exec(_source(scene, kernel), made.__dict__)
    return made


def solutions(*kernels: str):
    """Return the solutions of the references by these methods: scene, kernel, numbers."""
    return [
        (name, row["kernel"], row)
        for name, reference in REFERENCES.items()
        for row in reference["solutions"]
        if row["kernel"] in kernels
    ]
