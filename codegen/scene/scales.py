"""Units in which the equations of a scene are dimensionless."""

import sympy as sp

from .bodies.check import scales_of_body
from .data import SceneData
from .error import SceneError
from .linear import LinearPhase, linear_phase


def scales(scene: SceneData) -> tuple[sp.Expr, sp.Expr, sp.Expr]:
    """Return the units of mass, time and length, in the parameters.

    What the scene does not say: the mass that moves; ``1/Omega``, or ``sqrt(m/k)`` where
    nothing forces; what the force amounts to in that time, or the distance that a held mass
    travels in it.  A `SceneError` is raised if one of them cannot be worked out.
    """
    if scene.body is not None:
        return scales_of_body(scene)
    memory = [q.symbol for q in scene.memory]
    free = [linear_phase(phase, memory) for phase in scene.phases if phase.held is None]
    given = {name: sp.sympify(value) for name, value in scene.scales.items()}
    mass = given.get("mass", free[0].m)
    time = given.get("time") or _time(scene, free)
    length = given.get("length") or _length(scene, free, mass, time)
    return mass, time, length


def _time(scene: SceneData, free: list[LinearPhase]) -> sp.Expr:
    if scene.frequency is not None:
        return 1 / scene.frequency
    for phase in free:
        if phase.k != 0:
            return sp.sqrt(phase.m / phase.k)
    raise SceneError("scales: no time can be worked out (no forcing, no spring): give 'time'")


def _length(scene: SceneData, free: list[LinearPhase], mass: sp.Expr, time: sp.Expr) -> sp.Expr:
    for phase in free:
        if phase.g != 0:
            return sp.simplify(sp.Abs(phase.g) * time**2 / mass)
    for held in (phase.held for phase in scene.phases):
        if held is not None and held != 0:
            return sp.simplify(sp.Abs(held) * time)
    raise SceneError("scales: no length can be worked out (no forcing, no held speed): give it")
