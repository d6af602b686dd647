"""The figures of the report that show convergence, read back, and what is said of all."""

import numpy as np
import pytest

pytest.importorskip("matplotlib")
pytest.importorskip("jinja2")

from computed import LIGHT, ODD, acceleration_errors, period_errors
from drawn import MARKERS, data, explained, labels, legend, note, report_axes
from matplotlib.colors import to_rgb
from paper import METHODS

from nonsmooth.report.captions import PLATES
from nonsmooth.report.figures import FIGURES
from nonsmooth.style import STYLES

NAMES = {"hb": "hb (3.1)", "hb-c1": "hb-c1 (3.2)", "c1": "c1 (3.3)"}


def test_periods_are_in_exact_periods_with_the_band_of_the_paper() -> None:
    axes = report_axes("fig-4")
    assert labels(axes) == ("order N", "T / T exact")
    assert axes.get_yscale() == "linear"
    (band,) = axes.patches
    assert (band.get_y(), band.get_height()) == pytest.approx((0.999, 0.002))
    found = explained(axes)
    for method, name in NAMES.items():
        errors = {N: e for N, e in period_errors(ODD, method).items() if N <= 12}
        orders, values = data(found[name])
        assert orders.tolist() == list(errors)
        np.testing.assert_allclose(values, 1 + np.array(list(errors.values())), rtol=1e-12)
        assert found[name].get_marker() == MARKERS[method]
    bottom, top = axes.get_ylim()
    assert bottom < min(data(found["hb (3.1)"])[1]) < 1 < top


@pytest.mark.parametrize(
    ("name", "label", "errors", "floor"),
    [
        ("fig-4-errors", "|T / T exact − 1|", period_errors, 0),
        ("fig-6", "error (22) of the acceleration", acceleration_errors, 1e-8),
    ],
)
def test_errors_are_drawn_against_the_order_on_a_logarithmic_scale(
    name: str, label: str, errors, floor: float
) -> None:
    axes = report_axes(name)
    assert labels(axes) == ("order N", label)
    assert axes.get_yscale() == "log"
    found = explained(axes)
    assert list(found) == list(NAMES.values())
    for method, words_ in NAMES.items():
        expected = errors(ODD, method)
        orders, values = data(found[words_])
        assert orders.tolist() == list(expected)
        sizes = np.abs(list(expected.values()))
        above = sizes > floor
        assert above.sum() > 10
        # a few units in the last place of T/T_exact, which the test takes the difference of
        np.testing.assert_allclose(values[above], sizes[above], rtol=1e-9, atol=1e-15)
        assert found[words_].get_marker() == MARKERS[method]


def test_the_band_and_the_floor_are_marked_where_they_are() -> None:
    band, floor = report_axes("fig-4-errors"), report_axes("fig-6")
    assert note(band, "0.1 %").xy[1] == 1e-3
    assert [1e-3, 1e-3] in [list(line.get_ydata()) for line in band.lines]
    assert note(floor, "floor in float64").xy[1] == pytest.approx(2.0**-26)
    assert [2.0**-26] * 2 in [list(line.get_ydata()) for line in floor.lines]


def test_a_method_without_an_orbit_is_said_to_have_none() -> None:
    found = legend(report_axes("fig-5", LIGHT))
    assert list(found) == ["exact", "hb (3.1)", "hb-c1 (3.2)", "c1 (3.3): no orbit"]
    expected = [N for N in range(1, 41) if N not in period_errors(LIGHT, "c1")]
    assert 4 in expected
    orders, _ = data(explained(report_axes("fig-6", LIGHT))["c1 (3.3)"])
    assert set(expected).isdisjoint(orders.tolist())


def test_methods_are_told_apart_without_colours() -> None:
    for name in ("marker", "linestyle"):
        assert len({str(style[name]) for style in STYLES.values()}) == len(METHODS)
    luminances = [
        np.dot(to_rgb(style["color"]), (0.299, 0.587, 0.114)) for style in STYLES.values()
    ]
    assert max(luminances) < 0.6  # on white paper


def test_every_picture_has_a_plate_that_says_what_is_against_what() -> None:
    described = {name: text for plate in PLATES for name, text in plate.pictures.items()}
    assert list(described) == list(FIGURES)
    shown = ("fig-1b", "fig-2b", "fig-2c", "fig-2d", "fig-3", "fig-5", "fig-6")
    for name in (*shown, "fig-4", "fig-4-errors"):
        axes, text = report_axes(name), described[name]
        assert (axes.get_yscale() == "log") == ("logarithmic" in text), name
        assert ("against N" in text) == (axes.get_xlabel() == "order N"), name
        if name in shown:
            assert text.lower().startswith(axes.get_ylabel().split()[0]), name
    assert described["fig-2a"].startswith("Phase plane")
    assert described["fig-4"].startswith("Period against N")
    assert described["fig-4-errors"].startswith("Size of the period error")
