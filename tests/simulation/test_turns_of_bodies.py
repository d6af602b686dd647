"""Motions of bodies once a period of the forcing: diagrams, and basins of attraction."""

import numpy as np
import pytest

import nonsmooth as ns
from nonsmooth.solver.simulation.bodies.units import state_of, units_of
from nonsmooth.solver.simulation.machines import machine_of

#: With impacts, and with a memory.
SCENES = ["chain-impact", "jenkins-absorber"]


@pytest.mark.parametrize("name", SCENES)
def test_a_diagram_begins_as_the_motion_from_rest(name: str) -> None:
    own = ns.scene(name)()
    period = 2 * np.pi / own.values["frequency"]
    motion = ns.simulate(own, cycles=12)
    (found,) = ns.diagram(own, "frequency", [own.values["frequency"]], 9, 3).states
    t = period * np.arange(10, 13) * (1 - 1e-15)
    assert found[:, 0] == pytest.approx(motion.displacement(t), abs=1e-12)
    assert found[:, 1] == pytest.approx(motion.velocity(t), abs=1e-12)


@pytest.mark.parametrize(
    ("name", "parameter", "factor"),
    [
        *((name, "frequency", 1.1) for name in SCENES),
        ("absorber-friction", "absorber_mass", 2.0), ("beam-impact", "modes", 0.8),
        ("beam-impact", "modes", 1.2),
    ],
)  # fmt: skip
def test_it_goes_on_where_the_value_before_was_left(name: str, parameter, factor) -> None:
    """In other units and modes: the contact is at the same place, at the same velocity."""
    own = ns.scene(name)()
    other = own.with_value(parameter, factor * own.values[parameter])
    one, two = machine_of(own.cell), machine_of(other.cell)
    last = one.strobed(one.at_rest(0.0), 7)[0][-1] * units_of(own, one)
    again = state_of(other, two, last)
    found = [
        float(row @ again.full) * other.units.of_motion(j)
        for j, row in enumerate(two.regimes[0].contacts[:2, 0])
    ]
    assert found == pytest.approx(last[:2], rel=1e-12)


def test_basins_lead_to_the_stable_orbits() -> None:
    own = ns.scene("chain-impact")()
    orbit = ns.solve(own)
    assert orbit.stable
    found = ns.basins(own, [-0.5, 0.0], [0.0, 0.5], 200)
    (attractor,) = found.attractors
    assert (found.index == 0).all()
    strobe = orbit.period * ((-orbit.forcing_phase / (2 * np.pi)) % 1.0)
    x = float(orbit.displacement(strobe)), float(orbit.velocity(strobe))
    assert attractor.states[0] == pytest.approx(x, abs=1e-5)


def test_a_body_is_released_from_where_it_is_said() -> None:
    machine = machine_of(ns.scene("chain-impact")().cell)
    begun = machine.released(-0.7, 0.4, 0.0)
    x, v = (float(row @ begun.full) for row in machine.regimes[0].contacts[:2, 0])
    assert (x, v) == pytest.approx((-0.7, 0.4), rel=1e-14)
