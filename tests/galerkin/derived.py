"""Kernels of the scenes of the references, derived once in a process."""

import json
import types
from functools import cache
from itertools import product
from pathlib import Path

from galerkin.oscillators import SCENES

from nonsmooth.codegen.emission.kernel import module_source
from nonsmooth.codegen.expansions import ck, ck_tau, hb, hb_c1, hb_ck
from nonsmooth.codegen.galerkin import GalerkinConditions

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
    (found, *_) = (q for q, _ in SCENES.values() if q.label == scene)
    return DERIVE[kernel](found)


def source(name: str, kernel: str) -> str:
    """Return the text of a kernel of a scene of the references."""
    return _source(SCENES[name][0].label, kernel)


@cache
def _source(scene: str, kernel: str) -> str:
    return module_source(_derived(scene, kernel))


def module(name: str, kernel: str) -> types.ModuleType:
    """Return a kernel of a scene of the references, as a module of plain Python."""
    return _module(SCENES[name][0].label, kernel)


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
