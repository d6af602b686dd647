"""Units in which the equations of a scene are dimensionless."""

import sympy as sp

from .bodies.body import Body
from .bodies.law import body_of
from .data import SceneData, once
from .error import SceneError
from .linear import linear_phase


@once
def scales(scene: SceneData) -> tuple[sp.Expr, sp.Expr, sp.Expr]:
    """Return the units of mass, time and length, in the parameters and SI numbers.

    Defaults are: the moving mass, or for a body ``w^T M w`` of its first contact;
    ``1/Omega``, or ``sqrt(m/k)`` without forcing; ``F t^2/m`` with the amplitude F of the
    forcing, or the distance that a held mass travels in the unit of time.

    Raises
    ------
    SceneError
        If one of them cannot be determined.
    """
    stated = {name: sp.sympify(value) for name, value in scene.scales.items()}
    of_body = scene.body is not None
    mass, period, force = (_of_body if of_body else _of_mass)(scene, stated.get("mass"))
    time = stated.get("time", period if scene.frequency is None else 1 / scene.frequency)
    if time is None:
        raise SceneError(
            "scales: no time can be worked out (no forcing, no spring): give one, in "
            "parameters and numbers in SI units, as scales={'time': ...}"
        )
    speeds = [phase.held for phase in scene.phases if phase.held]
    if "length" in stated:
        return mass, time, stated["length"]
    if force is None and not speeds:
        raise SceneError(
            "scales: no length can be worked out (no forcing, no held speed): give one, such "
            "as scales={'length': F/k}"
        )
    length = sp.Abs(speeds[0]) * time if force is None else force * time**2 / mass
    return mass, time, length if of_body else sp.simplify(length)


#: The mass; ``sqrt(m/k)``, or None without a spring; the amplitude of the forcing, or None.
Sizes = tuple[sp.Expr, sp.Expr | None, sp.Expr | None]


def _of_mass(scene: SceneData, mass: sp.Expr | None) -> Sizes:
    """Return the sizes of a scene of one mass."""
    memory = [q.symbol for q in scene.memory]
    free = [linear_phase(phase, memory) for phase in scene.phases if phase.held is None]
    periods = (sp.sqrt(q.m / q.k) for q in free if q.k != 0)
    forces = (sp.Abs(q.g) for q in free if q.g != 0)
    return mass or free[0].m, next(periods, None), next(forces, None)


def _of_body(scene: SceneData, mass: sp.Expr | None) -> Sizes:
    """Return the sizes of a scene of a body."""
    body, force = body_of(scene), None
    mass = mass or _at_contact(body, "M")
    if "forcing" in body.arrays:
        squares = (sp.sympify(q) ** 2 for q in body.arrays["forcing"].values)
        force = sp.simplify(sp.sqrt(sp.Add(*squares)))
    stiffness = _at_contact(body, "K")
    return mass, None if stiffness == 0 else sp.sqrt(mass / stiffness), force


def _at_contact(body: Body, name: str) -> sp.Expr:
    """Return ``w^T M w`` or ``w^T K w`` of the first contact."""
    column, matrix = body.arrays["at"].dense()[:, 0], body.arrays[name]
    places = zip(matrix.rows, matrix.columns, matrix.values, strict=True)
    return sp.Add(*(
        sp.sympify(value) * column[i] * column[j]
        for i, j, value in places
        if column[i] and column[j]
    ))  # fmt: skip
