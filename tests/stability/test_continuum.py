"""Orbits that are one of a continuum: others are found beside them, and are orbits too."""

import numpy as np
import pytest

from nonsmooth.solver.exact import exact_orbit
from nonsmooth.solver.flow.exact_system import exact_kernel
from nonsmooth.solver.kernels import registry
from nonsmooth.solver.orbit.attempt import attempt
from nonsmooth.solver.simulation.simulate import simulate
from nonsmooth.solver.stability.continuum import is_one_of_a_continuum, whole_period
from nonsmooth.solver.stability.in_words import in_words

FRICTION, PLASTIC = registry.load("dry-friction"), registry.load("elastic-plastic")
EVEN = {"damping": 0, "mu_s": 0.05, "mu_k": 0.05}


@pytest.mark.parametrize("n", [2, 4])
def test_sliding_without_damping_at_even_parts_of_the_natural_frequency(n) -> None:
    """G. Csernak and G. Stepan, J. Sound Vib. 295 (2006) 649-658: asymmetric orbits beside."""
    case = FRICTION(frequency=1 / n, **EVEN).of_motion("sliding")
    orbit = exact_orbit(case)
    assert is_one_of_a_continuum(orbit)
    assert in_words(orbit).endswith(
        "a multiplier is 1: the orbit is one of a continuum, none isolated"
    )
    kernel = registry.kernel(case.scene, "ck-tau")
    assert is_one_of_a_continuum(attempt(kernel, case, 20, orbit.times))
    # from beside it, a simulation comes back to where it began, and not to the orbit
    first = orbit.phases[0]
    beside = (first.displacement + 1e-3, 0.0)
    motion = simulate(case, beside, 40, forcing_phase=orbit.forcing_phase)
    late = motion.phases[-3:]
    again = simulate(case, beside, 20, forcing_phase=orbit.forcing_phase).phases[-3:]
    for one, other in zip(late, again, strict=True):
        if one.name == other.name and abs(one.displacement - other.displacement) < 1e-3:
            assert one.displacement == pytest.approx(other.displacement, abs=1e-7)
    settled = [phase.displacement for phase in motion.phases if phase.displacement > 0][-2]
    assert abs(settled - first.displacement) > 1e-5


@pytest.mark.parametrize(
    ("scene", "values"),
    [
        (FRICTION, EVEN | {"frequency": 0.51}),
        (FRICTION, EVEN | {"frequency": 0.5, "damping": 1e-6}),
        (PLASTIC, {}),
        (registry.load("backlash"), {"damping": 0}),
        (registry.load("stick-slip"), {}),
    ],
)
def test_other_orbits_are_alone(scene, values) -> None:
    assert not is_one_of_a_continuum(exact_orbit(scene(**values)))


def test_without_hardening_any_mean_will_do() -> None:
    orbit = exact_orbit(PLASTIC(hardening=0))
    assert is_one_of_a_continuum(orbit)
    assert "one of a continuum" in in_words(orbit)


def test_at_a_fold_the_orbit_is_alone_though_a_multiplier_is_1() -> None:
    """Where two orbits meet; the frequency from its closed form, in 18 digits."""
    fold = {"damping": 0, "gap": 0.5, "restitution": 0.8, "frequency": 1.93383878222628754}
    angles = [
        exact_orbit(registry.load("impact")(**fold | {"frequency": fold["frequency"] - d}))
        for d in (1e-9, 1e-11)
    ]
    for orbit in angles:
        assert np.abs(orbit.multipliers - 1).min() < 1e-3
        assert not is_one_of_a_continuum(orbit)


@pytest.mark.parametrize("scene", ["dry-friction", "elastic-plastic", "backlash"])
def test_the_whole_period_has_the_same_orbit(scene) -> None:
    """Its mirror image spelled out, the orbit satisfies the equations of the whole."""
    orbit = exact_orbit(registry.load(scene)())
    cell = whole_period(orbit.case.cell)
    count = len(orbit.case.cell.phases)
    assert (len(cell.phases), cell.sign) == (2 * count, 1)
    states = [q for p in orbit.phases for q in (p.displacement, p.velocity)]
    units = orbit.case.units
    scaled = [q / units.of_motion(j % 2) for j, q in enumerate(states)]
    memory = [sign * q for q in orbit.memory_values for sign in (1, -1)]
    z = np.array([*scaled, *memory, *(s / units.time for s in orbit.durations), orbit.angle])
    R = np.empty(len(z))
    exact_kernel(cell).residual(cell, z, R)
    assert np.abs(R).max() < 1e-12 * np.abs(z).max()
