"""Events of bodies: bounds of forms along a phase, crests that meet a stop or do not."""

import math
from dataclasses import replace

import numpy as np
import pytest
from bodies.reference_bodies import case
from scipy.linalg import expm

import nonsmooth as ns
from nonsmooth.solver.bodies.laws import scales
from nonsmooth.solver.simulation.bodies.along import Along, along_of, least, put_bounds
from nonsmooth.solver.simulation.bodies.locate import first_event
from nonsmooth.solver.simulation.bodies.phases import Phases, forms_of, laws_of, poles_of
from nonsmooth.solver.simulation.bodies.regime import Regime, regimes
from nonsmooth.solver.simulation.nodes import nodes
from nonsmooth.solver.simulation.steps.locate import EVENT


def along(regime: Regime, Y: np.ndarray, rows: np.ndarray) -> Along:
    """Return forms along a phase from a state on."""
    phases = Phases(poles_of([regime]), laws_of([regime]), forms_of([regime], [rows]))
    which, known = np.arange(len(rows)), np.zeros(len(rows), dtype=bool)
    omega = regime.part.flow.omega
    return along_of(phases, omega, 0, Y, which, np.ones(len(rows)), known)


@pytest.mark.parametrize("part", [10.0**-q for q in range(2, 13, 2)])
def test_a_crest_that_grazes_the_stop_is_met(part: float) -> None:
    """The stop is put below and above the highest crest of a motion that never meets it."""
    scene = ns.scene("chain-impact")
    away = ns.simulate(scene(gap=50.0), cycles=4)
    t = np.linspace(0, away.time, 20001)
    top = t[np.argmax(away.displacement(t))]
    for _ in range(60):  # the crest, by Newton's method on its velocity
        top -= float(away.velocity(top) / away.acceleration(top))
    crest = float(away.displacement(top))
    below = ns.simulate(scene(gap=crest * (1 - part)), time=top + 0.5)
    above = ns.simulate(scene(gap=crest * (1 + part)), time=away.time)
    assert len(above.phases) == 1
    early = math.sqrt(2 * part * crest / -float(away.acceleration(top)))
    assert len(below.phases) >= 2
    assert top - below.phases[1].start == pytest.approx(early, rel=0.1)


@pytest.mark.parametrize("below", [1e-1, 1e-3, 1e-5])
def test_a_crest_behind_many_lower_ones_is_not_stepped_over(below: float) -> None:
    """Of two modes that begin apart: both are at their largest together only much later."""
    cell = case("clearance-2").cell
    squares, damping = np.array([1.0, 1.021**2]), np.zeros((2, 2))
    own = replace(cell.body, squares=squares, damping=damping, forcing=np.zeros(2))
    cell = replace(cell, body=own)
    regime = regimes(cell, nodes(cell))[0]
    w = scales(own, cell.omega)
    Y = np.array([-w[0], 0.0, 0.0, 1.021, 1.0, 0.0, 1.0])  # -cos(t), sin(1.021 t)
    form = np.array([[-1 / w[0], -1 / w[1], 0.0, 0.0, 0.0, 0.0, 2.0 - below]])
    s, how, _ = first_event(along(regime, Y, form), 1e4)
    t = np.linspace(0.0, s, 1_000_001)[:-1]
    values = 2.0 - below + np.cos(t) - np.sin(1.021 * t)
    assert how == EVENT
    assert s > 20
    assert values.min() > 0
    assert 2.0 - below + np.cos(s) - np.sin(1.021 * s) == pytest.approx(0.0, abs=1e-12)


#: Bodies and phases with poles of each kind: damped, held, at resonance, unstable.
POLES = ("clearance-2", "absorber-stick", "beam-10-spring", "resonance", "unstable")


@pytest.mark.parametrize("order", [1, 2, 4])
@pytest.mark.parametrize("name", POLES)
def test_a_form_stays_within_its_bounds(name: str, order: int) -> None:
    """Its derivatives and its least value, against matrix exponentials."""
    cell = case(name if name in POLES[:3] else "clearance-2").cell
    if name not in POLES[:3]:  # the first mode has the frequency of the forcing
        squares = cell.body.squares * (cell.omega**2 / cell.body.squares[0])
        damping = (-0.1 if name == "unstable" else 0.0) * np.eye(len(squares))
        cell = replace(cell, body=replace(cell.body, squares=squares, damping=damping))
    rng = np.random.default_rng(order)
    for regime in regimes(cell, nodes(cell)):
        n, t = regime.states, np.linspace(0.0, 3.0, 61)
        Y = rng.standard_normal(len(regime.generator))
        Y[n + 2] = 1.0
        own = along(regime, Y, regime.contacts[:, 0])
        rows = regime.contacts[:, 0] @ np.linalg.matrix_power(regime.generator, order)
        states = [expm(regime.generator * q) @ Y for q in t]
        found = np.array([rows @ state for state in states]).T
        h, bound = 0.5, np.empty(len(rows))
        for k in range(len(t)):
            within = (t >= t[k]) & (t <= t[k] + h)
            size = 1e-12 * np.abs(rows) @ np.abs(states[k])
            put_bounds(own, order, float(t[k]), h, bound)
            assert (np.abs(found[:, within]).max(axis=1) <= bound + size).all()
        values = np.array([regime.contacts[:, 0] @ state for state in states]).T
        rounding, low = 1e-9 * own.sizes, least(own, float(t[20]), float(np.abs(Y).max()))
        assert (values[:, 20:].min(axis=1) >= low - rounding).all()
