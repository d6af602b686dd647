"""Kernels for the scenes of the references, as if each were a module of one scene."""

import json
import re
import types
from functools import cache
from itertools import product
from pathlib import Path

from galerkin.oscillators import SCENES

from nonsmooth.codegen.emission.scene_numbers import scene_source
from nonsmooth.codegen.galerkin import GalerkinConditions
from nonsmooth.solver.kernels import polynomials, series
from nonsmooth.solver.scenes.loaded import LoadedScene
from nonsmooth.solver.scenes.methods import about
from nonsmooth.solver.scenes.of_module import cell_of

REFERENCES = json.loads(Path(__file__).with_name("references.json").read_text("utf-8"))

#: The kernels; behind the name of a method how many functions a switch has.
KERNELS = ("ck_tau", "ck", "hb", "hb_c1", "hb_ck_1", "hb_ck_2")

#: The oscillators of a kernel that is made for some alone.
ONLY = {"hb_c1": ("S0",)}


def pairs(names):
    """Return each oscillator with each kernel that there is for it."""
    found = product(names, KERNELS)
    return [(name, kernel) for name, kernel in found if name in ONLY.get(kernel, names)]


def _scene(label: str):
    return next(q for q, _ in SCENES.values() if q.label == label)


@cache
def loaded(label: str) -> LoadedScene:
    """Return a scene of the references in numbers."""
    return in_numbers(_scene(label))


def in_numbers(scene) -> LoadedScene:
    """Return a scene in numbers, without a file."""
    made = types.ModuleType(scene.label)
    exec(scene_source(scene), made.__dict__)
    return LoadedScene(made, Path("nowhere"))


class OfOneScene:
    """A kernel with one scene's parameters for a case, and the cycles behind them."""

    def __init__(self, scene: LoadedScene, method: str, functions=0, class_one=False):
        if about(method).is_series:
            layout = series.Layout(scene, method, functions)
        else:
            layout = polynomials.Layout(scene, method, class_one)
        self.kernel = layout.family.kernel(layout, False)
        self.scene, self.METHOD, self.size = scene, method, self.kernel.size
        self.coefficients = self.kernel.coefficients
        for name in ("durations", "forced", "lowest"):
            setattr(self, name.upper(), getattr(self.kernel, name))

    def given(self, case, z):
        """Return what the kernel takes."""
        count = len(self.scene.parameters)
        cell = cell_of(self.scene, tuple(case[:count]), *case[count:])
        order = next(n for n in range(1, 1000) if self.size(n) == len(z))
        return self.kernel.given(types.SimpleNamespace(cell=cell), order)

    def residual(self, case, z, R):
        self.kernel.residual(self.given(case, z), z, R)

    def jacobian(self, case, z, J):
        self.kernel.jacobian(self.given(case, z), z, J)

    def motion(self, case, z, p, u, derivative):
        return self.kernel.motion(self.given(case, z), z, p, u, derivative)


def of_conditions(conditions: GalerkinConditions) -> OfOneScene:
    """Return the kernel of the scene and the method of a record."""
    method, _, functions = conditions.method.partition(", K = ")
    return OfOneScene(in_numbers(conditions.scene), method, int(functions or 0))


def module(name: str, kernel: str, class_one: bool = False) -> OfOneScene:
    """Return a kernel for a scene of the references."""
    return _module(SCENES[name][0].label, kernel, class_one)


@cache
def _module(label: str, kernel: str, class_one: bool) -> OfOneScene:
    found = re.fullmatch(r"(\w+?)(?:_(\d))?", kernel)
    method, functions = found[1].replace("_", "-"), int(found[2] or 0)
    return OfOneScene(loaded(label), method, functions, class_one)


def solutions(*kernels: str):
    """Return the solutions of the references by these methods: scene, kernel, numbers."""
    return [
        (name, row["kernel"], row)
        for name, reference in REFERENCES.items()
        for row in reference["solutions"]
        if row["kernel"] in kernels
    ]
