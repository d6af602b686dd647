"""The figures of the report, read back: motions, convergence, and what is said of all."""

import numpy as np
import pytest

pytest.importorskip("matplotlib")
pytest.importorskip("jinja2")

from computed import LIGHT, ODD, Exact, acceleration_errors, period_errors
from drawn import MARKERS, data, explained, labels, legend, longest, note, report_axes, words
from matplotlib.colors import to_rgb
from paper import METHODS

import nonsmooth as ns
from nonsmooth.report.captions import PLATES
from nonsmooth.report.figures import FIGURES, STYLES

EXACT = Exact(ODD)
NAMES = {"hb": "hb (3.1)", "hb-c1": "hb-c1 (3.2)", "c1": "c1 (3.3)"}


def smooth(part: np.ndarray, t1: float) -> np.ndarray:
    """Return where a curve is off its jumps: there rounding decides between the sides."""
    return (np.abs(part - t1) > 1e-9) & (part < 1 - 1e-9)


def test_the_sketch_names_what_the_oscillator_has() -> None:
    assert set(words(report_axes("fig-1a"))) == {"$M$", "$K$", "$V$", "$F_N$", "$x$"}


def test_friction_is_against_the_relative_velocity() -> None:
    axes = report_axes("fig-1b")
    assert labels(axes) == ("velocity relative to the belt [m/s]", "friction [N]")
    solid = [data(line) for line in axes.lines if line.get_linestyle() == "-"]
    static, kinetic = 0.9, 0.5  # N, of a normal force of 1 N
    ends = sorted((float(x[1]), float(y[0]), float(y[1])) for x, y in solid)
    # slower than the belt, friction drags the mass on; faster, it holds it back
    assert ends == [(-0.75, kinetic, kinetic), (0, -static, static), (0.75, -kinetic, -kinetic)]
    assert note(axes, r"$\mu_s F_N$").xy[1] == static
    assert note(axes, r"$\mu_k F_N$").xy[1] == kinetic


def test_the_phase_plane_is_a_line_and_an_arc() -> None:
    axes = report_axes("fig-2a")
    assert labels(axes) == ("displacement x [m]", "velocity [m/s]")
    x, v = data(longest(axes))
    away = x - EXACT.centre
    sticks = np.isclose(v, EXACT.speed, rtol=1e-12) & (np.abs(away) <= EXACT.reach * (1 + 1e-9))
    radius = np.hypot(EXACT.reach, EXACT.speed / EXACT.omega)
    np.testing.assert_allclose(np.hypot(away, v / EXACT.omega)[~sticks], radius, rtol=1e-9)
    assert 400 < sticks.sum() < 1000
    assert away.max() == pytest.approx(radius, rel=1e-4)
    assert away.min() == pytest.approx(-radius, rel=1e-4)
    assert v.min() == pytest.approx(-EXACT.omega * radius, rel=1e-4)
    for name, side in (("A", -1), ("B", 1)):
        place = (EXACT.centre + side * EXACT.reach, EXACT.speed)
        assert note(axes, name).xy == pytest.approx(place, rel=1e-12)
        dots = [data(d) for d in axes.lines if d.get_marker() == "o"]
        (dot,) = (d for d in dots if d[0][0] == note(axes, name).xy[0])
        assert np.ravel(dot) == pytest.approx(place, rel=1e-12)


@pytest.mark.parametrize(
    ("name", "derivative", "label"),
    [
        ("fig-2b", 0, "displacement [m]"),
        ("fig-2c", 1, "velocity [m/s]"),
        ("fig-2d", 2, "acceleration [m/s²]"),
    ],
)
def test_the_histories_are_those_of_the_exact_orbit(
    name: str, derivative: int, label: str
) -> None:
    axes = report_axes(name)
    assert labels(axes) == ("$t/T$", label)
    assert axes.get_xlim() == (0, 1.2)
    part, values = data(longest(axes))
    assert 1.19 < part.max() <= 1.2
    assert (np.diff(part) > 0).all()
    share = EXACT.t1 / EXACT.period
    off = smooth(part % 1, share) & (part % 1 > 1e-9)
    expected = EXACT.motion(part % 1, derivative)
    scale = np.abs(expected).max()
    np.testing.assert_allclose(values[off], expected[off], rtol=1e-9, atol=1e-9 * scale)
    assert note(axes, "stick").xy[0] == pytest.approx(share / 2)
    assert note(axes, "slip").xy[0] == pytest.approx((1 + share) / 2)
    shaded = [(stick.get_x(), stick.get_width()) for stick in axes.patches]
    assert shaded == [pytest.approx((0, share)), pytest.approx((1, min(share, 0.2)))]


def test_both_sides_of_the_two_jumps_and_the_centre_are_drawn() -> None:
    part, values = data(longest(report_axes("fig-2d")))
    for jump, sides in ((EXACT.t1 / EXACT.period, [0, -EXACT.jump]), (1, [EXACT.jump, 0])):
        assert values[np.abs(part - jump) < 2e-9] == pytest.approx(sides, rel=1e-7)
    axes = report_axes("fig-2b")
    assert note(axes, "$x_s$").xy == (1, pytest.approx(EXACT.centre))
    assert EXACT.centre == 0.0625  # m: 0.5 x 1 N / 8 N/m
    (level,) = (data(line)[1] for line in axes.lines if len(line.get_xdata()) == 2)
    assert level == pytest.approx([EXACT.centre] * 2)


@pytest.mark.parametrize(
    ("name", "methods", "order"),
    [("fig-3", ("hb",), 40), ("fig-3-detail", ("hb",), 40), ("fig-5", METHODS, 3)],
)
def test_each_acceleration_is_that_of_the_method_its_legend_names(
    name: str, methods: tuple[str, ...], order: int
) -> None:
    axes = report_axes(name)
    assert labels(axes) == ("$t/T$", "acceleration [m/s²]")
    found = explained(axes)
    assert list(found) == ["exact", *(NAMES[method] for method in methods)]
    part, values = data(found["exact"])
    off = smooth(part, EXACT.t1 / EXACT.period)
    np.testing.assert_allclose(
        values[off], EXACT.motion(part, 2)[off], rtol=1e-9, atol=1e-9 * EXACT.jump
    )
    for method in methods:
        orbit = ns.solve(ODD, method, order)
        part, values = data(found[NAMES[method]])
        off = smooth(part, orbit.t1 / orbit.period)
        expected = orbit.acceleration(part * orbit.period)
        np.testing.assert_allclose(
            values[off], expected[off], rtol=1e-9, atol=1e-9 * EXACT.jump
        )


def test_the_overshoot_is_marked_where_it_is() -> None:
    axes = report_axes("fig-3-detail")
    orbit = ns.solve(ODD, "hb", 40)
    times = np.linspace(orbit.t1 / 2, orbit.t1, 4_001)
    ripple = orbit.acceleration(times)
    high = ripple.max()
    mark = note(axes, "overshoot")
    assert mark.get_text() == f"overshoot {100 * high / EXACT.jump:.2f} % of the jump"
    where = times[ripple.argmax()] / orbit.period
    assert mark.xy == (pytest.approx(where, abs=1e-4), pytest.approx(high, rel=1e-4))
    assert any((data(line)[1] == mark.xy[1]).all() for line in axes.lines)
    own = note(axes, "where stick ends").xy
    level = float(orbit.acceleration(orbit.t1))
    assert own == pytest.approx((orbit.t1 / orbit.period, level), rel=1e-9)
    left, right = axes.get_xlim()
    assert left < where < own[0] < right
    bottom, top = axes.get_ylim()
    assert bottom < level < 0 < high < top


def exact_periods(belt: ns.StickSlip, method: str) -> dict[int, float]:
    """Return the periods of the lower orders in exact ones."""
    return {N: 1 + e for N, e in period_errors(belt, method).items() if N <= 12}


@pytest.mark.parametrize(
    ("name", "label", "scale", "expected", "floor"),
    [
        ("fig-4", "$T$ / $T$ exact", "linear", exact_periods, 0),
        ("fig-4-errors", "|$T$ / $T$ exact − 1|", "log", period_errors, 0),
        ("fig-6", "error (22) of the acceleration", "log", acceleration_errors, 1e-8),
    ],
)
def test_convergence_is_drawn_against_the_order(name, label, scale, expected, floor) -> None:
    axes = report_axes(name)
    assert labels(axes) == ("order $N$", label)
    assert axes.get_yscale() == scale
    found = explained(axes)
    assert list(found) == list(NAMES.values())
    for method, said in NAMES.items():
        orders, values = data(found[said])
        known = expected(ODD, method)
        assert orders.tolist() == list(known)
        assert found[said].get_marker() == MARKERS[method]
        sizes = np.abs(list(known.values()))
        above = sizes > floor
        assert above.sum() > 10
        # a few units in the last place of T/T_exact, which the test takes the difference of;
        # (22) sees the root of as little, by which two exact orbits differ
        np.testing.assert_allclose(values[above], sizes[above], rtol=1e-9, atol=floor or 1e-15)


def test_the_band_the_floor_and_the_least_periods_are_in_the_picture() -> None:
    axes = report_axes("fig-4")
    (shaded,) = axes.patches
    assert (shaded.get_y(), shaded.get_height()) == pytest.approx((0.999, 0.002))
    bottom, top = axes.get_ylim()
    assert bottom < min(exact_periods(ODD, "hb").values()) < 1 < top
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


def test_a_method_looks_the_same_in_all_figures() -> None:
    expected = {NAMES[method]: look["color"] for method, look in STYLES.items()}
    for name in ("fig-3", "fig-4", "fig-5", "fig-6"):
        found = legend(report_axes(name))
        assert expected.keys() & found.keys()
        assert all(found[q].get_color() == expected[q] for q in expected.keys() & found.keys())


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
        assert ("against N" in text) == (axes.get_xlabel() == "order $N$"), name
        if name in shown:
            assert text.lower().startswith(axes.get_ylabel().split()[0]), name
    assert described["fig-2a"].startswith("Phase plane")
    assert described["fig-4"].startswith("Period against N")
    assert described["fig-4-errors"].startswith("Size of the period error")
