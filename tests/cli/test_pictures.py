"""Pictures of the command line, read back: curves, axes, legends."""

from dataclasses import asdict

import numpy as np
import pytest

pytest.importorskip("matplotlib")

from computed import ODD, Exact, acceleration_errors, period_errors
from drawn import MARKERS, data, explained, labels, legend, note
from paper import METHODS

import nonsmooth as ns
from nonsmooth.cli.shortcuts.families.family import job_from
from nonsmooth.plots.shortcuts.families import family_figure
from nonsmooth.plots.shortcuts.orbits import orbit_figure
from nonsmooth.plots.shortcuts.sweeps import convergence_figure
from nonsmooth.plots.shortcuts.trade import tradeoff_figure
from nonsmooth.shortcuts.tradeoff import Point

EXACT = Exact(ODD)
NAMES = {
    "hb": "hb: Fourier series (3.1)",
    "hb-c1": "hb-c1: with one $C^1$ function (3.2)",
    "c1": "c1: $C^1$ functions (3.3)",
}
CAPTION = (
    r"stick-slip oscillator, $\alpha = \omega_n (\mu_s - \mu_k) F_N / (K V)$ = 1.333, "
    "$F_N$ = 1 N"
)


def test_the_orbit_is_drawn_beside_the_exact_one() -> None:
    orbits = {method: ns.solve(ODD, method, 5) for method in METHODS}
    figure = orbit_figure(ODD, list(orbits.values()))
    plane, *histories = figure.axes
    assert labels(plane) == ("displacement [m]", "velocity [m/s]")
    assert [labels(axes) for axes in histories] == [
        ("t/T", "displacement [m]"),
        ("t/T", "velocity [m/s]"),
        ("t/T", "acceleration [m/s²]"),
    ]
    assert figure.get_supxlabel() == CAPTION
    names = {method: f"{name}, N = 5" for method, name in NAMES.items()}
    assert list(legend(figure)) == ["exact", *names.values()]
    curves = [explained(axes, figure) for axes in figure.axes]
    for derivative, found in enumerate(curves[1:]):
        part, values = data(found["exact"])
        inside = (np.abs(part - EXACT.t1 / EXACT.period) > 1e-9) & (part < 1)
        expected = EXACT.motion(part, derivative)[inside]
        np.testing.assert_allclose(values[inside], expected, rtol=1e-9, atol=1e-9)
        for method, orbit in orbits.items():
            part, values = data(found[names[method]])
            kind = ("displacement", "velocity", "acceleration")[derivative]
            expected = getattr(orbit, kind)(part * orbit.period)
            inside = (np.abs(part - orbit.t1 / orbit.period) > 1e-9) & (part < 1)
            np.testing.assert_allclose(values[inside], expected[inside], rtol=1e-9, atol=1e-9)
    for words in ("exact", *names.values()):  # the plane has what the histories have
        both = [data(found[words])[1] for found in curves[1:3]]
        closed = np.array(data(curves[0][words]))
        assert np.array_equal(closed[:, :-1], both)
        assert np.array_equal(closed[:, -1], closed[:, 0])


def test_several_c1_functions_are_said_to_be_several() -> None:
    orbit = ns.solve(ODD, "hb-c1", 5, c1_terms=3)
    words = "hb-c1: with 3 $C^1$ functions (3.2)"
    assert list(legend(orbit_figure(ODD, [orbit]))) == ["exact", f"{words}, N = 5"]
    swept = ns.sweep(ODD, ["hb-c1"], [4, 5], c1_terms=3)
    assert list(legend(convergence_figure(swept))) == [words]
    job = job_from(
        "mu-s=0.8:0.9:2", False, ODD, asdict(ODD) | {"mu_s": None}, ["hb-c1"], "5", 3
    )
    points = ns.family(ODD, "mu_s", [0.8, 0.9], "hb-c1", 5, c1_terms=3).points
    assert list(legend(family_figure(job.families({"hb-c1": points})))) == [words]


def test_the_convergence_is_drawn_against_the_order() -> None:
    figure = convergence_figure(ns.sweep(ODD, orders=range(1, 13)))
    period, size, acceleration = figure.axes
    assert labels(period) == ("order N", "T / T exact")
    assert labels(size) == ("order N", "|T / T exact - 1|")
    assert labels(acceleration) == ("order N", "error (22)")
    assert [axes.get_yscale() for axes in figure.axes] == ["linear", "log", "log"]
    titles = [axes.get_title() for axes in figure.axes]
    assert titles == ["period (Fig. 4)", "period error", "acceleration error (Fig. 6)"]
    assert figure.get_supxlabel() == CAPTION
    curves = [explained(axes, figure) for axes in figure.axes]
    assert list(curves[0]) == list(NAMES.values())
    for method, name in NAMES.items():
        assert curves[0][name].get_marker() == MARKERS[method]
        periods, accelerations = (
            {N: e for N, e in errors(ODD, method).items() if N <= 12}
            for errors in (period_errors, acceleration_errors)
        )
        errors = np.array(list(periods.values()))
        for found, expected in zip(
            curves, (1 + errors, np.abs(errors), list(accelerations.values())), strict=True
        ):
            orders, values = data(found[name])
            assert orders.tolist() == list(periods)
            # a few units in the last place of T/T_exact, which the test takes a difference of
            np.testing.assert_allclose(values, expected, rtol=1e-9, atol=1e-15)
    assert note(acceleration, "floor in float64").xy[1] == pytest.approx(2.0**-26)


@pytest.mark.parametrize(
    ("vary", "log", "label"),
    [("belt-speed=0.3:3:5", True, "belt speed [m/s]"), ("mu-s=0.6:1.2:4", False, "mu s")],
)
def test_a_family_is_drawn_along_its_parameter(vary: str, log: bool, label: str) -> None:
    name = vary.partition("=")[0].replace("-", "_")
    flags = asdict(ODD) | {name: None}
    job = job_from(vary, log, ODD, flags, ["hb", "c1"], "24", 1)
    values = job.vary.values(0, job.vary.count)
    points = {m: ns.family(ODD, name, values, m, 24).points for m in ("hb", "c1")}
    figure = family_figure(job.families(points), log)
    assert [axes.get_ylabel() for axes in figure.axes] == [
        "period $T$ [s]",
        "amplitude [m]",
        "stick fraction $t_1/T$",
        "estimated error of $T$",
    ]
    assert [axes.get_xlabel() for axes in figure.axes] == ["", "", label, label]
    assert [axes.get_xscale() == "log" for axes in figure.axes] == [log] * 4
    assert [axes.get_yscale() == "log" for axes in figure.axes] == [log, log, False, True]
    (one,) = figure.legends
    assert one.get_title().get_text() == "$N = 24$"
    curves = [explained(axes, figure) for axes in figure.axes]
    assert list(curves[0]) == [NAMES["hb"], NAMES["c1"]]
    for axes in curves:
        for curve in axes.values():
            assert data(curve)[0].tolist() == values.tolist()
    orbits = [Exact(ns.StickSlip(**asdict(ODD) | {name: value})) for value in values]
    exact = (
        [orbit.period for orbit in orbits],
        [float(np.hypot(orbit.reach, orbit.speed / orbit.omega)) for orbit in orbits],
        [orbit.t1 / orbit.period for orbit in orbits],
    )
    for found, expected in zip(curves, exact, strict=False):
        np.testing.assert_allclose(data(found[NAMES["c1"]])[1], expected, rtol=1e-9)
        np.testing.assert_allclose(data(found[NAMES["hb"]])[1], expected, rtol=5e-2)
        assert np.abs(data(found[NAMES["hb"]])[1] / expected - 1).max() > 1e-4
    true = np.abs(data(curves[0][NAMES["hb"]])[1] / exact[0] - 1)
    np.testing.assert_allclose(data(curves[3][NAMES["hb"]])[1], true, rtol=0.05)
    assert data(curves[3][NAMES["c1"]])[1].max() < 1e-12


POINTS = [
    Point("float64", "hb", 1, 4, None, 1e-4, 3e-2, 2.5e-2, True),
    Point("float64", "hb", 1, 8, None, 5e-4, 2e-2, 1.5e-2),
    Point("float64", "hb-c1", 1, 4, None, 2e-4, 4e-3, 3.5e-3, True),
    Point("float64", "hb-c1", 3, 4, None, 3e-4, 6e-5, 5.5e-5, True),
    Point("float64", "c1", 1, 9, None, 2.5e-4, 7e-4, 6.5e-4, True),
    Point("precise", "c1", 1, 24, 30, 2e-2, 8e-30, None, True),
]


def test_time_against_error_is_drawn_with_its_front() -> None:
    (axes,) = tradeoff_figure(POINTS).axes
    assert labels(axes) == ("time of one orbit [s]", "relative error of the period")
    assert (axes.get_xscale(), axes.get_yscale()) == ("log", "log")
    found = {line.get_label(): line for line in axes.lines}
    times, errors = data(found.pop("the front"))
    assert times.tolist() == [1e-4, 2e-4, 2.5e-4, 3e-4, 2e-2]
    assert errors.tolist() == [3e-2, 4e-3, 7e-4, 6e-5, 8e-30]
    curves = {words: np.transpose(data(line)).tolist() for words, line in found.items()}
    assert curves == {
        NAMES["hb"]: [[1e-4, 3e-2], [5e-4, 2e-2]],
        NAMES["hb-c1"]: [[2e-4, 4e-3]],
        "hb-c1 with 3 $C^1$ functions": [[3e-4, 6e-5]],
        NAMES["c1"]: [[2.5e-4, 7e-4]],
        "c1, many digits": [[2e-2, 8e-30]],
    }
    assert note(axes, "K = 3").xy == (3e-4, 6e-5)
    handles = legend(axes)
    assert set(handles) == {"the front", *curves}
    for method, marker in MARKERS.items():
        assert (
            handles[NAMES[method]].get_marker() == found[NAMES[method]].get_marker() == marker
        )
