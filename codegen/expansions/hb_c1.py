"""Harmonics and one function of class C^1: Section 3.2 of the paper (`hb-c1`).

For two phases, of which the first is held and the second is a free oscillator.  ``G`` is (12)
over ``T (T - t_1)**3``: a smoothstep over the free phase, less a ramp over the period.  Its
velocity is continuous, and in the held phase it has no acceleration.  The residual is
orthogonal to it as well: (14).

Both phases have ``m x''`` in the residual, and periodic motions of class C^1 have no boundary
terms when it is integrated by parts twice.  So the Galerkin form is symmetric: the row (14) has
the column of ``c1`` in (5), (6), (7) as its coefficients.
"""

from collections.abc import Iterator
from dataclasses import replace

import sympy as sp

from ..galerkin import Block, Condition, GalerkinConditions, Times, closure
from ..galerkin.condition import N
from ..galerkin.harmonics import Harmonics, a, a0, b, equations, n
from ..scene import LinearPhase, Scene, switches
from . import About, hb

METHOD = "hb-c1"
KERNEL = "hb_c1"
TITLE = "Fourier series and one function of class C^1"
ABOUT = About(place=2, power=True, colour="#56B4E9", marker="v", line=(0, (6, 2, 3, 2)))

c1 = sp.Symbol("c1", real=True)

#: Local time of a phase, from 0 to 1.
u = sp.Symbol("u", real=True)

#: What the integrals of the residual of ``G`` with harmonics are called.
BY_COSINE, BY_SINE = sp.IndexedBase("H_cos"), sp.IndexedBase("H_sin")


def applies(scene: Scene) -> bool:
    """Whether a scene has the two phases that (12) is made for."""
    if scene.body is not None or scene.frequency is not None:
        return False
    if len(scene.cell) != 2 or scene.sign == -1:
        return False
    held, free = scene.cell
    if held.held is None or free.held is not None or scene.memory:
        return False
    return equations(scene)[1].c == 0 and all(switch.k == 1 for switch in switches(scene))


def function(times: Times) -> tuple[sp.Expr, sp.Expr]:
    """Return ``G`` of (12) in the held and in the free phase, in local time `u`."""
    held, free = times.durations
    ramp = (held * u / times.cell, (held + free * u) / times.cell)
    return -ramp[0], u**2 * (3 - 2 * u) - ramp[1]


def derivative(times: Times, p: int, order: int) -> sp.Expr:
    """Return a derivative of ``G`` on a phase, in local time `u`, times a power of ``T``."""
    G, s = function(times)[p], times.durations[p]
    return sp.expand(sp.diff(G, u, order) * (times.cell / s) ** order)


def by_itself(free: LinearPhase, times: Times) -> sp.Expr:
    """Return the inner product of the residual of ``G`` with ``G``."""
    G, s = function(times)[1], times.durations[1]
    integrand = free.m * sp.diff(G, u, 2) / s**2 + free.k * G
    return sp.factor(s * sp.integrate(sp.expand(integrand * G), (u, 0, 1)))


def force_by(free: LinearPhase, times: Times) -> sp.Expr:
    """Return the inner product of the force with ``G``."""
    G, s = function(times)[1], times.durations[1]
    return sp.factor(free.f * s * sp.integrate(sp.expand(G), (u, 0, 1)))


def orthogonality(scene: Scene, harmonics: Harmonics) -> Iterator[Condition]:
    """Yield (5), (6), (7) with the function beside the series, and (14)."""
    for condition in hb.orthogonality(harmonics, ()):
        table = BY_SINE if condition.name == "by_sine" else BY_COSINE
        index = sp.Integer(0) if condition.index is None else condition.index
        yield replace(condition, expression=condition.expression + c1 * table[index])
    waves = sp.Sum(a[n] * BY_SINE[n] + b[n] * BY_COSINE[n], (n, 1, N))
    _, free = equations(scene)
    by_function = c1 * by_itself(free, harmonics.times) - force_by(free, harmonics.times)
    yield Condition(
        "by_function",
        "residual, orthogonal to the function itself",
        a0 / 2 * BY_COSINE[0] + waves + by_function,
        number="14",
    )


def derive(scene: Scene) -> GalerkinConditions:
    """Return the conditions of a scene.

    A `ValueError` is raised if it is not one that it `applies` to.
    """
    if not applies(scene):
        raise ValueError(f"{METHOD}: got {scene.label}, expected a held and a free phase")
    times, harmonics = Times.of(scene), Harmonics.of(scene)

    def end(p: int, order: int) -> sp.Expr:
        at_end = sp.factor(derivative(times, p, order).subs(u, 1))
        series = hb.series(harmonics, times.start(p + 1), order)
        return series + c1 * at_end / times.cell**order

    return GalerkinConditions(
        scene,
        METHOD,
        TITLE,
        (*hb.series_blocks(scene), Block(c1, sp.Integer(1), "of the function of (12)")),
        times,
        (*orthogonality(scene, harmonics), *closure.events(scene, times, end)),
    )
