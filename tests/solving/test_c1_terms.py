"""Section 3.2 with more than one C1 function: motion, errors, coefficients, refusals."""

import json

import numpy as np
import pytest

import nonsmooth as ns
from nonsmooth.solver.shortcuts.orbit.methods import METHODS
from nonsmooth.solver.shortcuts.orbit.oscillator import DEFAULT
from nonsmooth.solver.shortcuts.orbit.samples import samples


@pytest.mark.parametrize("K", [2, 3, 6])
def test_the_motion_is_smooth_periodic_and_its_own_derivative(K: int) -> None:
    orbit = ns.solve(DEFAULT, "hb-c1", 9, c1_terms=K)
    T, t1, h = orbit.period, orbit.t1, 1e-5
    t = np.concatenate([np.linspace(h, t1 - h, 20), np.linspace(t1 + h, T - h, 40)])
    for value, slope in (("displacement", "velocity"), ("velocity", "acceleration")):
        f, df = getattr(orbit, value), getattr(orbit, slope)
        difference = (f(t + h / 2) - f(t - h / 2)) / h
        np.testing.assert_allclose(difference, df(t), atol=1e-4 * np.abs(df(t)).max())
        for join in (0.0, t1):
            assert f([join - 1e-12])[0] == pytest.approx(f([join + 1e-12])[0], abs=1e-9)
    assert orbit.displacement([t1])[0] == pytest.approx(0.2, abs=1e-12)  # mu_s F_N / K


@pytest.mark.parametrize("K", [1, 2, 5])
def test_samples_have_all_functions(K: int) -> None:
    orbit = ns.solve(DEFAULT, "hb-c1", 12, c1_terms=K)
    z = orbit.unknowns
    tau, displacement, velocity = samples(z, 12, K)
    t = np.mod(tau + z[-2] / 2, z[-1])
    for derivative, values in enumerate((displacement, velocity)):
        expected = METHODS["hb-c1"].evaluate(z, 12, t, derivative, 1.0)
        np.testing.assert_allclose(values, expected, atol=1e-12)


# Period errors at alpha = 1, N = 8 (mathematics.md, section 2).
@pytest.mark.parametrize(("K", "error"), [(1, 9.3e-5), (2, -1.7e-5), (3, 5.3e-8)])
def test_more_functions_help(K: int, error: float) -> None:
    orbit = ns.solve(DEFAULT, "hb-c1", 8, c1_terms=K)
    assert orbit.errors.period == pytest.approx(error, rel=0.05)
    assert orbit.estimate.period == pytest.approx(abs(error), rel=0.05)
    assert orbit.c1_terms == K


def test_errors_of_the_acceleration_are_estimated_too() -> None:
    for K in range(1, 7):
        orbit = ns.solve(DEFAULT, "hb-c1", 10, c1_terms=K)
        true, estimated = orbit.errors.acceleration, orbit.estimate.acceleration
        assert 0.9 * true <= estimated <= 1.1 * true + 1e-7


def test_further_coefficients_are_those_of_the_acceleration() -> None:
    orbit = ns.solve(DEFAULT, "hb-c1", 6, c1_terms=3)
    found = orbit.coefficients
    t = np.linspace(orbit.t1, orbit.period, 9)[1:-1]
    v = 2 * (t - orbit.t1) / (orbit.period - orbit.t1) - 1
    n, w = np.arange(1, 7), 2 * np.pi / orbit.period
    angle = w * np.multiply.outer(t, n)
    series = -(np.sin(angle) @ (n**2 * w**2 * np.array(found["a"])))
    series -= np.cos(angle) @ (n**2 * w**2 * np.array(found["b"]))
    T, s = orbit.period, orbit.period - orbit.t1
    g1 = found["c1"] * T * s * -6 * v  # the second derivative of (12)
    more = sum(c * v * (1 - v**2) ** i for i, c in enumerate(found["c"], start=1))
    np.testing.assert_allclose(series + g1 + more, orbit.acceleration(t), atol=1e-9)


def test_the_command_line_takes_several(run) -> None:
    status, out, _ = run("solve", "--order", 8, "--c1-terms", 3)
    assert status == 0
    assert "hb-c1(3)" in out
    assert max(map(len, out.splitlines())) <= 80
    _, out, _ = run("solve", "--method", "hb-c1", "--order", 8, "--c1-terms", 3, "--json")
    document = json.loads(out)
    assert document["c1_terms"] == 3
    assert len(document["coefficients"]["c"]) == 2
    arguments = ("--methods", "hb-c1", "--orders", "8,16", "--c1-terms", 3, "--json")
    _, out, _ = run("sweep", *arguments)
    document = json.loads(out)
    assert document["c1_terms"] == 3
    assert abs(document["rows"][0]["errors"]["period"]) < 1e-7


@pytest.mark.parametrize("terms", [0, 7, -1])
@pytest.mark.parametrize("command", ["solve", "sweep"])
def test_a_number_of_functions_that_is_none(run, command: str, terms: int) -> None:
    status, out, err = run(command, f"--c1-terms={terms}")
    assert (status, out) == (2, "")
    assert "--c1-terms" in err
    assert f"got {terms}" in err


@pytest.mark.parametrize(
    "others",
    [
        ("--method", "c1", "--order", 5),
        ("--method", "hb", "--order", 5),
        ("--tol", "1e-3"),
        ("--digits", 30),
        ("--method", "hb-c1", "--order", 201),
    ],
)
def test_where_several_cannot_be(run, others: tuple) -> None:
    status, out, err = run("solve", "--c1-terms", 3, *others)
    assert (status, out) == (2, "")
    assert "got" in err
    assert "expected" in err


def test_a_tolerance_chooses_among_the_methods_of_the_paper() -> None:
    with pytest.raises(ValueError, match="c1_terms: got 2 beside"):
        ns.solve(DEFAULT, tol=1e-3, c1_terms=2)


@pytest.mark.parametrize("terms", [True, 2.0, "2", None])
def test_another_kind_of_number(terms: object) -> None:
    with pytest.raises(ValueError, match="c1_terms: got"):
        ns.solve(DEFAULT, "hb-c1", 5, c1_terms=terms)  # type: ignore[arg-type]
