"""Functions of class C^1 for smoother scenes: the same kernel, other rows (`ck-tau`)."""

from functools import partial

import numpy as np
import pytest
from galerkin.derived import loaded, module
from galerkin.oscillators import SCENES, case_of
from galerkin.solving import differences, jacobian, residual, solve, times_of

from nonsmooth.solver.kernels.registry import class_one

#: Times by another program, with 30 digits: durations, phase of the forcing.
REFERENCES = {
    ("S2a", 5): (
        "3.676749547846769668104",
        "0.8112399572815063868427",
        "5.351647832691110366691",
    ),
    ("S2a", 9): (
        "3.676748369290357331754",
        "0.8112411358379187231921",
        "5.351648588259198673366",
    ),
    ("S2b", 5): (
        "1.387245053151924630001",
        "3.445974413909295736864",
        "0.346939893318303846117",
    ),
    ("S2b", 9): (
        "1.387244976910693617859",
        "3.445974490150526749007",
        "0.3469386848424167799952",
    ),
    ("S4a", 5): ("1.123091218280280741078", "2.803899598706960807", "2.373608790851899660796"),
    ("S4a", 9): (
        "1.123091218271620354723",
        "2.803899598715621193355",
        "2.37360879086842460452",
    ),
}

#: Rough times of the undamped orbit.
TIMES = (1.4244, 3.4088, 5.3573)

SMOOTH = ("S2a", "S2b", "S4a", "S4b")


def once(name):
    """Return the kernel of a scene for functions of class C^1, as `solving` takes kernels."""
    return module(name, "ck_tau", class_one=True)


@pytest.mark.parametrize(("name", "order"), REFERENCES)
def test_times_are_those_of_another_program(name, order):
    expected = np.array(REFERENCES[name, order], dtype=float)
    kernel = once(name)
    z = solve(kernel, case_of(name), order, 1.01 * expected)
    np.testing.assert_allclose(times_of(kernel, z), expected, rtol=0, atol=1e-12)
    for p in range(
        2
    ):  # of degree N: what is beyond, and would be for a smoother motion, is not
        u = (1 + np.cos(np.linspace(0, np.pi, order + 6))) / 2
        acceleration = kernel.motion(case_of(name), z, p, u, 2)
        found = np.polynomial.legendre.legfit(2 * u - 1, acceleration, order + 3)
        assert np.abs(found[order + 1 :]).max() < 1e-13 * np.abs(found).max()


@pytest.mark.parametrize("name", SMOOTH)
def test_the_jacobian_is_the_derivative_of_the_residual(name):
    kernel, case = once(name), case_of(name)
    z = np.random.default_rng(7).uniform(0.5, 1.5, kernel.size(5))
    slopes = differences(partial(residual, kernel, case), z, 1e-3)
    for column, slope in zip(jacobian(kernel, case, z).T, slopes, strict=True):
        np.testing.assert_allclose(column, slope, rtol=0, atol=1e-9 * np.abs(column).max())


def test_only_smoother_motions_tested_alike_for_any_class_have_them():
    for name, method in (("S1", "ck-tau"), ("S3a", "ck-tau"), ("S4a", "ck"), ("S4a", "hb")):
        assert class_one(loaded(SCENES[name][0].label), method) is None, (name, method)
    assert class_one(loaded(SCENES["S4a"][0].label), "ck-tau") == "c1-tau"


@pytest.mark.parametrize("order", [2, 5, 6, 11])
def test_what_is_singular_at_an_orbit_that_is_its_own_reflection(order):
    """Two springs without damping: one change is free that moves no even, or no odd, condition.

    Reflection in time keeps the durations, and takes the forcing at mid-contact from psi to
    -psi: of an odd change the durations are zero, of an even one the phase at mid-contact.
    """
    kernel, free = module("S2b", "ck_tau"), once("S2b")
    symbols = [symbol.name for symbol in SCENES["S2b"][0].symbols]
    case = list(case_of("S2b"))
    case[symbols.index("c")] = 0.0
    z = solve(free, case, order, np.array(TIMES))
    Omega = case[symbols.index("Omega")]
    s, _, phi = times_of(kernel, z)
    assert abs(np.sin(phi + Omega * s / 2)) < 1e-12  # forced at its extreme at mid-contact
    # as unknowns of class C^2: a coefficient more a phase, of which there is none
    d = np.split(z[:-3], 2)
    smooth = np.concatenate([*(np.append(q, 0.0) for q in d), z[-3:]])
    J = jacobian(kernel, case, smooth)
    J /= np.abs(J).max(axis=1, keepdims=True)
    _, values, directions = np.linalg.svd(J)
    assert values[-1] < 1e-14
    assert values[-2] > 1e-4
    ds, rest, dphi = times_of(kernel, directions[-1])
    if order % 2:
        assert abs(dphi + Omega * ds / 2) < 1e-12
    else:
        assert max(abs(ds), abs(rest)) < 1e-12
    regular = np.linalg.svd(jacobian(free, case, z), compute_uv=False)
    assert regular[-1] > 1e-4
