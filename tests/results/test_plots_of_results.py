"""``plot`` of every result: what is drawn, where, with which words."""

import sys
from dataclasses import replace

import numpy as np
import pytest

pytest.importorskip("matplotlib")

from matplotlib.figure import Figure
from results_things import MAKERS, MOTIONS, thing

import nonsmooth as ns
from nonsmooth.plots.axes import LEAST, draw_errors, legend_above
from nonsmooth.plots.families import family_figure
from nonsmooth.solver.scenes.methods import about


@pytest.fixture
def axes():
    """Return axes that no window has."""
    return Figure().subplots()


def curve(line) -> np.ndarray:
    return np.array([line.get_xdata(), line.get_ydata()], dtype=float)


@pytest.mark.parametrize("kind", MAKERS)
def test_every_result_is_drawn_on_the_given_axes(kind: str, axes) -> None:
    assert thing(kind).plot(axes) is axes
    assert axes.lines
    assert axes.get_xlabel() or kind == "modes"
    assert axes.get_ylabel()


@pytest.mark.parametrize("kind", MOTIONS)
def test_a_motion_against_time_has_both_sides_of_each_switch(kind: str, axes) -> None:
    motion = thing(kind)
    motion.plot(axes, quantity="acceleration", color="red")
    (line,) = axes.lines
    part, values = curve(line)
    same = {"rtol": 1e-10, "atol": 1e-10}
    once = part < 1
    assert part.max() == pytest.approx(
        1.2, abs=0.01
    )  # what follows a switch at the end is seen
    np.testing.assert_array_equal(values[~once], values[once][: (~once).sum()])
    np.testing.assert_allclose(
        values[once], motion.acceleration(part[once] * motion.period), **same
    )
    assert line.get_color() == "red"
    for switch in np.cumsum(motion.durations)[:-1] / motion.period:
        assert (switch - part > 0).any()
        assert np.abs(part - switch).min() < 1e-8
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("$t/T$", "acceleration [m/s²]")
    plane = motion.plot(Figure().subplots()).lines[0]
    x, v = curve(plane)
    times = part[once] * motion.period
    np.testing.assert_allclose(x[:-1], motion.displacement(times), **same)
    np.testing.assert_allclose(v[:-1], motion.velocity(times), **same)
    assert (x[0], v[0]) == (x[-1], v[-1])


def test_the_method_gives_the_look_and_the_label(axes) -> None:
    belt, orbit = thing("belt"), thing("orbit")
    ns.plot([thing("exact-belt"), belt, orbit], axes)
    exact, first, second = axes.lines
    assert exact.get_label() == "exact"
    assert (first.get_label(), first.get_color()) == ("c1, N = 6", about("ck").look["color"])
    assert second.get_label() == "c1-tau, N = 6"
    assert second.get_color() == about("ck-tau").look["color"]


def test_errors_of_a_sweep_and_of_a_belt(axes) -> None:
    sweep = thing("sweep")
    sweep.plot(axes, "discontinuous")
    assert [line.get_label() for line in axes.lines] == ["hb", "c0-tau"]
    expected = [[row.order, row.errors.discontinuous] for row in sweep.of("ck-tau")]
    np.testing.assert_array_equal(curve(axes.lines[1]).T, expected)
    assert (axes.get_yscale(), axes.get_ylabel()) == ("log", "error of $x'$")
    belts = thing("sweep-belt")
    drawn = belts.plot(Figure().subplots(), "period")
    expected = [[row.order, abs(row.errors.period)] for row in belts.of("c1")]
    np.testing.assert_array_equal(curve(drawn.lines[1]).T, expected)


def test_an_error_of_zero_is_drawn_at_the_floor_and_none_is_not(axes) -> None:
    draw_errors(axes, [1, 2, 3], [0.0, -1e-3, float("nan")])
    np.testing.assert_array_equal(axes.lines[0].get_ydata(), [LEAST, 1e-3, np.nan])


def test_families_along_their_parameter(axes) -> None:
    family = thing("family")
    family.plot(axes, "displacement")
    low, high, missing = map(curve, axes.lines)
    np.testing.assert_array_equal(low[0], [0.1, 0.2])
    np.testing.assert_allclose(high[1], [0.1, 0.2], rtol=1e-9)  # the stop
    np.testing.assert_array_equal(missing[0], [50.0])
    assert axes.get_xlabel() == "gap $g$ [m]"
    drawn = thing("family-belt").plot(Figure().subplots(), "period")
    np.testing.assert_array_equal(curve(drawn.lines[0])[1], thing("family-belt")["period"][1:])


def test_modes_have_the_exact_one_below(axes) -> None:
    modes = thing("modes")
    modes.plot(axes, number=2)
    exact, found, _ = axes.lines
    assert exact.get_label() == "exact"
    np.testing.assert_allclose(curve(exact)[1], curve(found)[1], atol=1e-3)
    x = curve(found)[0]
    np.testing.assert_array_equal(curve(found)[1], modes[1].shape(x))
    for number in (0, 4, True, 1.0):
        with pytest.raises(ValueError, match=r"number: got .*, expected .* 1 to 3"):
            modes.plot(number=number)


@pytest.mark.parametrize("quantity", ["shape", "discontinuous"])
def test_several_modes_have_one_exact_one_below_all(quantity: str, axes) -> None:
    def ritz(position: str) -> ns.Modes:
        return ns.modes("beam-mass", "ritz", 6, position=position, mass=10, count=1)

    both = [thing("modes"), ritz("1/3")]
    ns.plot(both, axes, quantity=quantity)
    names = [f"{modes.shown}, N = {modes.order}" for modes in both]
    assert axes.get_legend_handles_labels()[1] == ["exact", *names]
    exact, *above = [line for line in axes.lines if len(line.get_xdata()) > 2]
    assert exact.get_label() == "exact"
    assert len(above) == len(both)
    assert exact.get_zorder() < min(line.get_zorder() for line in above)
    ns.plot(ritz("1/4"), axes, quantity=quantity)  # another mode, which the legend explains
    wide = [line.get_label() for line in axes.lines if line.get_linewidth() == 3]
    assert wide == ["exact", "_exact"]


def test_a_simulation_from_a_time_on(axes) -> None:
    motion = thing("simulation")
    motion.plot(axes, "velocity", since=3.0)
    t, v = curve(axes.lines[0])
    assert 3.0 <= t.min() < 3.1
    assert t.max() == pytest.approx(motion.time)
    inside = slice(0, 10)
    np.testing.assert_allclose(v[inside], motion.velocity(t[inside]), rtol=1e-9, atol=1e-12)


@pytest.mark.parametrize("kind", MAKERS)
def test_a_quantity_that_there_is_not_is_refused(kind: str) -> None:
    with pytest.raises(ValueError, match=r"quantity: got 'colour', expected one of \w+, \w+"):
        thing(kind).plot(quantity="colour")


@pytest.mark.parametrize("wrong", [3, [], [3], "orbit"])
def test_what_is_no_result_is_not_drawn(wrong: object) -> None:
    with pytest.raises(TypeError, match=r"^result: got .*, expected an orbit"):
        ns.plot(wrong)


def test_new_axes_have_the_style_of_all_pictures() -> None:
    plt = pytest.importorskip("matplotlib.pyplot")
    plt.switch_backend("agg")
    axes = ns.plot([thing("belt"), thing("exact-belt")])
    assert [text.get_text() for text in axes.figure.legends[0].get_texts()] == [
        "c1, N = 6",
        "exact",
    ]
    assert axes.xaxis.get_gridlines()[0].get_visible()
    plt.close(axes.figure)


def test_new_axes_of_a_branch_explain_its_marks() -> None:
    plt = pytest.importorskip("matplotlib.pyplot")
    plt.switch_backend("agg")
    axes = ns.branch(ns.scene("impact")(), "frequency", 2.3, 2.55).plot()
    (legend,) = axes.figure.legends
    assert [text.get_text() for text in legend.get_texts()] == ["stable", "unstable", "flip"]
    plt.close(axes.figure)


def test_where_two_multipliers_become_real_their_curve_has_points(axes) -> None:
    case = ns.scene("impact")()
    ns.branch(case, "frequency", 2.3, 2.55).plot(axes, "multiplier")
    x, y = np.concatenate([curve(line) for line in axes.lines[:2]], axis=1)
    for value in (2.44, 2.45, 2.5):  # they meet at 2.439
        exact = max(map(abs, ns.exact(case.with_value("frequency", value)).multipliers))
        assert np.interp(value, x, y) == pytest.approx(exact, rel=1e-3)


def test_durations_of_orbits_at_the_same_value_are_drawn_apart(axes) -> None:
    """The one stable, the other not; on a branch also where a phase never ends."""
    spring = ns.scene("clearance")(force=0.3, damping=0.1, gap=1.0)
    ns.family(spring, "frequency", np.linspace(1.05, 1.22, 7)).plot(axes, "times")
    for line in axes.lines:
        assert (np.diff(line.get_xdata()) > 0).all()
    on_branch = ns.branch(spring, "frequency", 0.8, 1.3).plot(Figure().subplots(), "times")
    first, second, _, separated, *_ = on_branch.lines
    labels = [line.get_label() for line in (first, second)]
    assert labels == ["contact", "separated"]
    assert (separated.get_linestyle(), separated.get_color()) == ("--", second.get_color())
    x, y = curve(separated)
    assert (x.min(), y[x < 0.84].min()) == (0.8, 1.0)


def test_a_branch_that_begins_at_an_event_is_drawn_as_what_follows(axes) -> None:
    """Its first orbit has no verdict."""
    found = ns.branch(ns.scene("impact")(gap=0.5, damping=0.02), "frequency", 1.7, 2.6)
    rows = found.rows[[q.stable for q in found.rows].index(None) :]
    replace(found, rows=rows, events=()).plot(axes)
    assert {line.get_label() for line in axes.lines} & {"stable", "unstable"}
    assert "neither, to rounding" not in {line.get_label() for line in axes.lines}


def test_the_picture_of_a_family_explains_its_lines() -> None:
    spring = ns.scene("clearance")(force=0.3, damping=0.1, gap=1.0)
    figure = family_figure(ns.family(spring, "frequency", [0.82, 1.2]))
    found = [[text.get_text() for text in q.get_texts()] for q in figure.legends]
    assert found == [["stable", "no orbit"]]


@pytest.mark.parametrize("kind", ["orbit", "sweep-belt", "family", "modes", "simulation"])
def test_without_matplotlib_the_extra_is_named(kind: str, monkeypatch) -> None:
    found = thing(kind)
    for name in [name for name in sys.modules if name.startswith("nonsmooth.plots")]:
        monkeypatch.delitem(sys.modules, name)
    monkeypatch.setattr("nonsmooth.extras.find_spec", lambda name: None)
    with pytest.raises(ns.MissingExtra, match=r"matplotlib: pip install 'nonsmooth\[plot\]'"):
        found.plot()


def test_a_long_simulation_is_drawn_by_fewer_points(axes) -> None:
    motion = ns.simulate(ns.scene("impact")(gap=1e3), cycles=10_000)
    motion.plot(axes)
    assert 200_000 <= len(axes.lines[0].get_xdata()) < 210_000


@pytest.mark.parametrize("columns", [2, 5, 9])
def test_a_legend_above_is_no_wider_than_its_figure(columns: int) -> None:
    figure = Figure(figsize=(4, 3), layout="constrained")
    axes = figure.subplots()
    for i in range(7):
        axes.plot([0, 1], [0, i], label=f"an entry of the legend, {i}")
    legend_above(figure, axes, columns)
    (legend,) = figure.legends
    assert len(legend.texts) == 7
    assert legend.get_window_extent().width <= figure.bbox.width


def test_attractors_and_starts_without_one_are_in_the_legend(axes) -> None:
    case = ns.scene("clearance")(force=0.3, damping=0.01, gap=1.0, frequency=1.2)
    found = ns.basins(case, [-3.0, 3.0], [0.0], cycles=33)
    found.plot(axes)
    assert [line.get_label() for line in axes.lines] == ["not settled"]
