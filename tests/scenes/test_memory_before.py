"""A memory that phases before its switch use."""

import types
from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest
import sympy as sp
from galerkin.derived import REFERENCES, of_conditions
from galerkin.solving import solve, times_of

from nonsmooth.codegen.emission.scene_numbers import scene_source
from nonsmooth.codegen.expansions import ck_tau, hb
from nonsmooth.codegen.scene import Event, Parameter, Phase, Scene, v
from nonsmooth.codegen.scenes import elastic_plastic as plain
from nonsmooth.solver.exact import exact_orbit
from nonsmooth.solver.scenes.loaded import LoadedScene


def cut_elsewhere():
    """Return S4a with the cell begun where the force of the element vanishes.

    First the mass goes on to yield, with the memory of the reversal in the cell before; then it
    flows; then it comes back from the reversal to where the force vanishes.  The damping of the
    first phase has a name of its own, since nothing else changes there.
    """
    made, w = plain.SCENE, plain.w
    late = sp.Symbol("c_l", nonnegative=True)
    back = -plain.F_y + plain.k * (plain.x - w)
    phases = (
        Phase("late", plain.REST + (late - plain.c) * v + plain.Z, Event(plain.Z + plain.F_y)),
        plain.PLASTIC,
        Phase("early", plain.REST + back, Event(back)),
    )
    damping = Parameter("late_damping", late, "N s/m", 0.1, "damping before yield")
    return Scene(
        "cut-elsewhere",
        "an element that yields",
        (*made.parameters, damping),
        phases,
        frequency=made.frequency,
        half_period=True,
        memory=(replace(made.memory[0], at="early"),),
    )


def module_of(text):
    module = types.ModuleType("made")
    exec(text, vars(module))
    return module


#: Durations and phase of S4a from the other switch, and the reversal at the other side.
ELASTIC, PLASTIC, PHASE = (float(q) for q in REFERENCES["S4a"]["exact"])
REVERSAL = -2.4412849059311371584


@cache
def exact_orbit_cut_elsewhere():
    numbers = LoadedScene(module_of(scene_source(cut_elsewhere())), Path("none"))
    return exact_orbit(numbers(), [0.45, 2.8, 0.67], 2.9)


def test_a_memory_of_the_cell_before_has_the_opposite_sign_in_half_a_period():
    orbit = exact_orbit_cut_elsewhere()
    late, plastic, early = orbit.durations[:3]
    assert (plastic, late + early) == pytest.approx((PLASTIC, ELASTIC), rel=1e-13)
    assert orbit.memory["w"] == pytest.approx(REVERSAL, rel=1e-13)
    assert orbit.forcing_phase == pytest.approx(PHASE + 0.8 * early, rel=1e-13)


@pytest.mark.parametrize(
    ("derive", "order", "bound"),
    [(ck_tau.derive, 8, 1e-12), pytest.param(hb.derive, 9, 3e-2, marks=pytest.mark.long)],
)
def test_so_it_has_in_the_conditions_of_an_expansion(derive, order, bound):
    scene = cut_elsewhere()
    kernel = of_conditions(derive(scene))
    case = (*(float(q.default) for q in scene.parameters), 1)
    orbit = exact_orbit_cut_elsewhere()
    exact = np.array([*orbit.durations[:3], orbit.forcing_phase])
    z = solve(kernel, case, order, exact * 1.001)
    np.testing.assert_allclose(times_of(kernel, z), exact, rtol=0, atol=bound)
    assert kernel.coefficients(z)["w"][0] == pytest.approx(REVERSAL, abs=bound)
