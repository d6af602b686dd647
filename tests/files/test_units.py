"""Units: the table of all that is written and shown, and that the motion is in SI units."""

import csv
import json
import re
from dataclasses import asdict
from pathlib import Path

import numpy as np
import pytest
import units
from units import BELT, METHODS

import nonsmooth as ns
from nonsmooth.solver.shortcuts.orbit.oscillator import DEFAULT

DOCUMENT = units.PARAMETERS | units.RESULTS | units.WALL_TIME

ORIGIN = ["schema", "version", "mathematics"]
ERRORS = [f"error_{name}" for name in ("period", "t1", "acceleration", "acceleration_aligned")]
ESTIMATES = [f"estimate_{name}" for name in ("period", "t1", "acceleration")]


def columns(path: Path) -> list[str]:
    with path.open(newline="") as file:
        return next(csv.reader(file))


def saved(thing: object, tmp_path: Path, suffix: str) -> Path:
    path = tmp_path / f"result{suffix}"
    ns.save(thing, path)
    return path


@pytest.mark.parametrize(("method", "terms"), METHODS)
def test_the_units_in_the_json_of_an_orbit(method: str, terms: int, tmp_path: Path) -> None:
    orbit = ns.solve(BELT, method, 7, c1_terms=terms)
    document = json.loads(saved(orbit, tmp_path, ".json").read_text())
    own = units.COEFFICIENTS[method]
    assert document["units"] == DOCUMENT | units.OF_ANY_SCENE | {"coefficients": {method: own}}
    assert set(document["coefficients"]) <= set(own)
    assert set(document["exact"]) == {"t1", "period", "forcing_phase", "durations"}


def test_the_units_in_the_json_of_several_orbits(run) -> None:
    document = json.loads(run("solve", "--order", 5, "--json")[1])
    assert document["units"] == DOCUMENT | units.OF_ANY_SCENE | {
        "coefficients": units.COEFFICIENTS
    }


def test_the_units_in_the_json_of_a_sweep(tmp_path: Path) -> None:
    document = json.loads(saved(ns.sweep(BELT, ["c1"], [5]), tmp_path, ".json").read_text())
    assert document["units"] == DOCUMENT


@pytest.mark.parametrize("parameter", units.PARAMETERS)
@pytest.mark.parametrize("suffix", [".json", ".csv", ".nc"])
def test_the_units_in_the_file_of_a_family(parameter: str, suffix: str, tmp_path: Path) -> None:
    value = getattr(BELT, parameter)
    path = saved(ns.family(BELT, parameter, [value, 1.1 * value], "c1", 9), tmp_path, suffix)
    numbers = ["alpha", "t1", "period", "amplitude", "stick_fraction"]
    estimates = ["estimate_period", "estimate_t1"]
    if suffix == ".json":
        document = json.loads(path.read_text())
        assert document["units"] == DOCUMENT | {"value": units.PARAMETERS[parameter]}
    elif suffix == ".csv":
        others = [name for name in units.PARAMETERS if name != parameter]
        expected = ["method", "order", "status", parameter, *numbers, *estimates, *others]
        assert columns(path) == [*expected, "c1_terms", "parameter", "rows", *ORIGIN]
    else:
        netcdf4 = pytest.importorskip("netCDF4")
        known = {name: units.RESULTS.get(name, "1") for name in (*numbers, *estimates)}
        known |= {parameter: units.PARAMETERS[parameter]}
        with netcdf4.Dataset(path) as file:
            assert _units(file) == known
            others = {name: value for name, value in asdict(BELT).items() if name != parameter}
            assert {name: file.getncattr(name) for name in others} == others
            assert parameter not in file.ncattrs()


def test_the_units_in_the_netcdf_of_a_sweep(tmp_path: Path) -> None:
    netcdf4 = pytest.importorskip("netCDF4")
    known = dict.fromkeys((*ERRORS, *ESTIMATES), "1")
    known |= {"t1": "s", "period": "s", "seconds": "s"}
    with netcdf4.Dataset(saved(ns.sweep(BELT, ["c1"], [5, 6]), tmp_path, ".nc")) as file:
        assert _units(file) == known


def test_the_units_in_the_netcdf_of_an_orbit(tmp_path: Path) -> None:
    netcdf4 = pytest.importorskip("netCDF4")
    orbit = ns.solve(BELT, "c1", 7)
    with netcdf4.Dataset(saved([orbit, orbit], tmp_path, ".nc")) as file:
        assert file["method"][:].tolist() == ["c1", "c1"]
        assert file["order"][:].tolist() == [7, 7]
        assert _units(file) == units.MOTION
        motion = orbit.displacement, orbit.velocity, orbit.acceleration
        for name, of in zip(list(units.MOTION)[1:], motion, strict=True):
            assert file[name].dimensions == ("orbit", "sample")
            assert np.array_equal(file[name][1], of(file["t"][1]))


def _units(where: object) -> dict[str, str]:
    """Return the units of the variables that are numbers."""
    variables = where.variables.items()
    return {name: v.units for name, v in variables if v.dtype == np.dtype("f8")}


def test_the_columns_of_a_csv(tmp_path: Path) -> None:
    path = saved(ns.sweep(BELT, ["c1"], [5]), tmp_path, ".csv")
    head = ["method", "order", "status", "t1", "period", "iterations", "seconds"]
    tail = [*units.PARAMETERS, "c1_terms", "rows", *ORIGIN]
    assert columns(path) == [*head, *ERRORS, *ESTIMATES, "message", *tail]
    path = saved(ns.solve(BELT, "c1", 5), tmp_path, ".csv")
    assert columns(path) == ["method", *units.MOTION]


SYMBOLS = {
    "mass": "M [kg]",
    "stiffness": "K [N/m]",
    "belt_speed": "V [m/s]",
    "mu_s": "mu_s",
    "mu_k": "mu_k",
    "normal_force": "F_N [N]",
}


@pytest.mark.parametrize("parameter", units.PARAMETERS)
def test_the_units_in_the_table_of_a_family(parameter: str, run) -> None:
    value = getattr(DEFAULT, parameter)
    _, out, _ = run("sweep", "--vary", f"{parameter}={value}:{0.9 * value}:2")
    head = re.split(r"\s{2,}", next(line for line in out.splitlines() if "method" in line))
    others = ["alpha", "T [s]", "amp. [m]", "stick/T", "estimate"]
    assert head == ["method", "N", SYMBOLS[parameter], *others]


@pytest.mark.parametrize(
    ("arguments", "expected"),
    [
        (("solve", "--order", 5), "method N T[s] T/T_ex-1 t1[s] (22) aligned estimate it"),
        (
            ("sweep", "--methods", "c1", "--orders", 5),
            "method N T[s] T/T_ex-1 t1/t1_ex-1 (22) estimate it",
        ),
        (("roots", "--order", 5), "slip[s] t1[s] T[s] mismatch verdict"),
    ],
    ids=["solve", "sweep", "roots"],
)
def test_the_units_in_the_heads_of_tables(arguments, expected: str, run) -> None:
    _, out, _ = run(*arguments)
    assert expected.split() in [line.replace(" [", "[").split() for line in out.splitlines()]
    assert "M = 10 kg, K = 1000 N/m, V = 1 m/s, mu_s = 0.5, mu_k = 0.25,\nF_N = 400 N;" in out


def test_the_units_of_what_prints_itself() -> None:
    lines = str(ns.solve(BELT, "c1", 7)).splitlines()
    period, stick = (re.fullmatch(r"  (\w+) += [\d.]+ (\w+)   .*", line) for line in lines[1:3])
    assert (period[1], period[2], stick[1], stick[2]) == ("T", "s", "t1", "s")
    head = str(ns.family(BELT, "mass", [1.0])).splitlines()[0]
    assert re.split(r"\s{2,}", head.strip()) == [
        "mass", "alpha", "T [s]", "amplitude [m]", "stick/T", "estimate",
    ]  # fmt: skip
    assert "T [s]" in str(ns.sweep(BELT, ["c1"], [5])).splitlines()[0]


@pytest.mark.parametrize("command", ["solve", "sweep", "roots", "report"])
def test_the_units_in_the_help(command: str, run) -> None:
    text = " ".join(run(command, "--help")[1].split())
    for words in (
        "--mass FLOAT M in kg",
        "--stiffness FLOAT K in N/m",
        "--belt-speed FLOAT V in m/s",
        "--normal-force FLOAT F_N in N",
    ):
        assert words in text


def test_the_motion_is_that_of_newtons_law_in_si_units() -> None:
    """Slip is ``M x'' + K x = mu_k F_N``, stick ends where ``K x = mu_s F_N``."""
    orbit, h = ns.solve(BELT, "c1", 24), 1e-5
    mass, stiffness, force = BELT.mass, BELT.stiffness, BELT.normal_force
    slip = np.linspace(orbit.t1 + 2 * h, orbit.period - 2 * h, 20)
    x, a = orbit.displacement(slip), orbit.acceleration(slip)
    np.testing.assert_allclose(mass * a + stiffness * x, BELT.mu_k * force, rtol=1e-9)
    stick = orbit.t1 * np.array([0.1, 0.5, 0.9])
    np.testing.assert_allclose(orbit.velocity(stick), BELT.belt_speed, rtol=1e-12)
    for t in (stick, slip):
        slope = (orbit.displacement(t + h) - orbit.displacement(t - h)) / (2 * h)
        np.testing.assert_allclose(orbit.velocity(t), slope, rtol=1e-6, atol=1e-8)
        slope = (orbit.velocity(t + h) - orbit.velocity(t - h)) / (2 * h)
        np.testing.assert_allclose(orbit.acceleration(t), slope, rtol=1e-6, atol=1e-7)
    end = orbit.displacement(orbit.t1)
    assert stiffness * end == pytest.approx(BELT.mu_s * force, rel=1e-9)
    x = orbit.displacement(np.linspace(0, orbit.period, 20_001))
    assert orbit.amplitude == pytest.approx((x.max() - x.min()) / 2, rel=1e-7)
    (point,) = ns.family(BELT, "mass", [mass]).points
    assert point["amplitude"] == pytest.approx(orbit.amplitude, rel=1e-12)
    assert point["period"] == pytest.approx(orbit.period, rel=1e-12)
