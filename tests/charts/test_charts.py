"""Maps of two parameters: against closed forms, the solver, and themselves elsewhere."""

import csv
import json
import signal
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np
import pytest
from one_mass import NAMES
from shown import ROOT

import nonsmooth as ns
from nonsmooth.plots.charts import chart_figure
from nonsmooth.solver import chart as charts
from nonsmooth.solver.charts import block, following, lines
from nonsmooth.solver.existence.known import known_orbits
from nonsmooth.solver.results.interrupted import Interrupted

RESTITUTION = 0.8
STOP = ns.scene("impact")(damping=0, restitution=RESTITUTION)
AXES = {"frequency": (1.55, 2.6, 7), "gap": (0.1, 0.8, 5)}
FLAGS = ("impact", "--damping", 0, "--restitution", RESTITUTION)


def gap_at(kind: str, w: np.ndarray) -> np.ndarray:
    """Return the gap at which something happens to the orbit with one impact, undamped.

    With the speed v of the impact, v^2 (q^2 + e^2) + 2 g q v + g^2 = a^2, where a is the
    response without a stop, q and e what the impact adds; the trace of its map has v as well.
    """
    r, turn, a = RESTITUTION, 2 * np.pi / w, 1 / (1 - w * w)
    q, e = (1 + r) / 2 / np.tan(np.pi / w), (1 - r) / (2 * w)
    bend = (1 + r) * np.sin(turn)
    speed = bend * (1 / a - 1) / (2 * r * np.cos(turn) - 1 - r * r - bend * q / a)
    return {
        "grazing": np.abs(a),
        "fold": np.abs(a) * np.hypot(q, e) / e,
        "flip": np.abs(a) / np.sqrt(speed**2 * (q * q + e * e) + 2 * q * speed + 1),
    }[kind]


@pytest.fixture
def few_lines(monkeypatch: pytest.MonkeyPatch) -> None:
    """Look for orbits on the edges of a map alone, and on these at their ends."""
    monkeypatch.setattr(charts, "LINES", 2)
    monkeypatch.setattr(lines, "VALUES", 2)


def test_a_curve_is_found_once_though_many_lines_cross_it() -> None:
    """Where it ends on the border of the map an event is its last point."""
    case = ns.scene("impact")(damping=0.05, gap=0.5)
    found = ns.chart(case, {"frequency": (1.0, 3.0, 12), "restitution": (0.4, 0.9, 8)}).curves
    assert sorted(curve.kind for curve in found) == ["flip", "fold", "grazing"]


def test_a_flip_goes_on_where_two_multipliers_are_minus_one(few_lines) -> None:
    """A torus bifurcation begins there: on the flip, which ends at the range on both sides."""
    axes = {"frequency": (0.691, 0.6914, 2), "restitution": (0.77, 0.79, 2)}
    flip, torus = ns.chart(ns.scene("chain-impact")(), axes).curves
    assert (flip.kind, torus.kind) == ("flip", "torus")
    assert flip.why_it_ended == ("the end of the range", "the end of the range")
    assert np.allclose(flip.points[[0, -1], 1], [0.77, 0.79], rtol=1e-15)
    frequency, restitution = torus.points[0]
    on_flip = np.interp(restitution, flip.points[:, 1], flip.points[:, 0])
    assert frequency == pytest.approx(on_flip, abs=1e-8)


@pytest.mark.parametrize("duration", [0.3, 1e-6, 1e-12])
def test_monitors_are_differentiated_within_the_shortest_phase(monkeypatch, duration) -> None:
    """Of impacts that become ever faster: a longer difference ends before it begins."""
    monkeypatch.setattr(following, "monitor_at", lambda plane, table, which, y: y[0] ** 0.5)
    plane = np.zeros(1), None, None, None, None, 0
    y, along = np.array([duration, 1.0, 0.0]), np.array([1.0, 0.0, 0.0])
    slope = following.slope_of(plane, None, 0, y, np.ones(3), along)
    assert slope == pytest.approx(0.5 / duration**0.5, rel=1e-4)


def test_orbits_that_change_much_between_points_are_followed(few_lines) -> None:
    """A mass with dry friction that hardly moves: its stops become shorter like a root."""
    friction = ns.scene("dry-friction")(damping=0.02)
    chart = ns.chart(friction, {"force": (0.33, 0.45, 5), "frequency": (0.4, 0.9, 7)})
    assert {name for row in chart.motion for name in row} == {"two-stops", "sliding"}


def test_a_cascade_of_impacts_is_not_followed_to_its_end(few_lines, monkeypatch) -> None:
    """It has orders of up to 40 impacts, each over half of the range of the one before."""
    monkeypatch.setattr(lines, "LEAST", 1.0)
    case = ns.scene("impact")(damping=0.05, restitution=0.7, frequency=2.8, cycles=2)
    axes, bounds = ("frequency", "gap"), ((2.2, 3.4), (-0.2, 0.1))
    stretches, _ = lines.line_of(case, axes, bounds, 0, 2)
    lengths = {len(stretch.course.order.steps) for stretch in stretches}
    assert lengths == set(range(1, max(lengths) + 1))
    assert 4 <= max(lengths) <= 8


def test_where_nothing_is_touched_the_motion_has_no_switches(few_lines) -> None:
    far = ns.scene("clearance")(force=0.05)
    chart = ns.chart(far, {"frequency": (0.3, 3, 4), "gap": (10, 30, 3)})
    assert {name for row in chart.motion for name in row} == {"only separated"}


@pytest.fixture(scope="module")
def found() -> ns.Chart:
    return ns.chart(STOP, AXES)


def test_the_closed_forms_are_those_of_the_references() -> None:
    for kind, w in (
        ("fold", 1.93383878222628754), ("flip", 1.09497644619305227), ("grazing", np.sqrt(3)),
    ):  # fmt: skip
        assert gap_at(kind, np.array(w)) == pytest.approx(0.5, rel=1e-14)


def test_curves_are_their_closed_forms_to_rounding(found: ns.Chart) -> None:
    """By the distance in the plane: a curve may be steep.

    Where the flip ends at no speed of the impact, its map has an entry beyond all bounds.
    """
    kinds = [curve.kind for curve in found.curves]
    assert sorted(kinds) == ["flip", "fold", "grazing"]
    for curve in found.curves:
        w, gap = curve.points.T
        regular = gap_at("grazing", w) - gap > 1e-3 if curve.kind == "flip" else w > 0
        slope = np.diff(gap_at(curve.kind, w + 1e-6 * np.array([[-1], [1]])), axis=0)[0] / 2e-6
        distance = (gap - gap_at(curve.kind, w)) / np.hypot(1, slope)
        assert np.abs(distance[regular]).max() < 1e-14
        assert np.count_nonzero(regular) > 10
        inside = [(w >= 1.55) & (w <= 2.6), (gap >= 0.1) & (gap <= 0.8)]
        assert np.all(inside)


def test_curves_end_at_the_range_or_where_they_meet(found: ns.Chart) -> None:
    ends = {curve.kind: curve for curve in found.curves}
    assert ends["grazing"].why_it_ended == ("the end of the range",) * 2
    for kind in ("fold", "flip"):  # at w = 2 both begin on the grazing
        curve = ends[kind]
        met = [why != "the end of the range" for why in curve.why_it_ended]
        assert sorted(met) == [False, True]
        point = curve.points[0 if met[0] else -1]
        assert point == pytest.approx([2, 1 / 3], abs=2e-3)


def test_regions_end_at_the_curves(found: ns.Chart) -> None:
    w, gap = np.meshgrid(*found.values)
    fold, flip, grazing = (gap_at(kind, w) for kind in ("fold", "flip", "grazing"))
    impacts = np.where(w < 2, gap < fold, gap < grazing)
    assert [*found.motions] == ["flight", "only flight"]
    np.testing.assert_array_equal(found.index == 0, impacts)
    stable = np.where(impacts, np.where(w < 2, 1, gap < flip), -1)  # undamped: neutral
    np.testing.assert_array_equal(found.stable, stable)
    assert set(stable.ravel()) == {1, 0, -1}


@pytest.mark.parametrize(
    "seed", [1, *(pytest.param(seed, marks=pytest.mark.long) for seed in range(2, 12))]
)
def test_a_random_map_says_what_the_solver_does(seed: int) -> None:
    random = np.random.default_rng(seed)
    case, axes = drawn(random)
    found = ns.chart(case, axes)
    told = {1: True, 0: False, -1: None}
    for _ in range(12):
        i, j = (int(random.integers(len(each))) for each in found.values[::-1])
        given = dict(
            zip(found.parameters, (found.values[0][j], found.values[1][i]), strict=True)
        )
        here = case.scene(**dict(case.values) | {n: float(q) for n, q in given.items()})
        orbits = known_orbits(here)
        every = [(name_of(q.case.scene), q.stable) for q in orbits]
        name = found.motion[i][j]
        if name is None:
            assert every == []
        elif name in {name for name, _ in every}:
            stable = told[int(found.stable[i, j])]
            assert (name, stable) in every
            assert stable or not any(stable for _, stable in every)
        elif not name.startswith("only "):  # of an order that is not declared
            orbit = ns.solve(here, phases=name, order=8)
            assert orbit.exact.stable == told[int(found.stable[i, j])]


def drawn(random):
    """Return a case of a shipped scene, and two parameters with ranges."""
    scene = ns.scene(random.choice([q for q in NAMES if not q.startswith("stick")]))
    values = {q.name: q.default * np.exp(random.uniform(-0.4, 0.4)) for q in scene.parameters}
    most = {q.name: q.most for q in scene.parameters if q.most is not None}
    values |= {name: min(values[name], most[name]) for name in most}
    if "mu_k" in values:
        values["mu_k"] = min(values["mu_k"], 0.9 * values["mu_s"])
    names = [n for n, value in values.items() if value and n not in {"mu_k", "mu_s", *most}]
    axes = {}
    for name in random.choice(names, 2, replace=False):
        axes[str(name)] = (0.7 * values[name], 1.5 * values[name], int(random.integers(4, 9)))
    return scene(**{name: float(value) for name, value in values.items()}), axes


def name_of(scene) -> str:
    """Return what a map calls a motion that a scene declares."""
    return scene.motion or ",".join([*scene.phases, *["mirrored"] * scene.half_period])


def test_lines_and_blocks_may_be_computed_elsewhere(found: ns.Chart) -> None:
    with ThreadPoolExecutor(1) as executor:
        other = ns.chart(STOP, AXES, executor)
    assert other.as_dict() == found.as_dict()


@pytest.mark.long  # other processes have it in every run: test_the_command_has_the_map
def test_a_cluster_of_dask_is_an_executor(found: ns.Chart) -> None:
    distributed = pytest.importorskip("distributed")
    how = {"n_workers": 1, "threads_per_worker": 1, "dashboard_address": None}
    with distributed.LocalCluster(**how) as cluster, distributed.Client(cluster) as client:
        other = ns.chart(STOP, AXES, client)
    assert other.as_dict() == found.as_dict()


def test_tables_have_a_row_a_point(found: ns.Chart) -> None:
    pytest.importorskip("pandas")
    array = pytest.importorskip("xarray") and found.to_xarray()
    assert dict(array.sizes) == {"gap": 5, "frequency": 7}
    assert array.motion.values.tolist() == found.motion
    frame = found.to_dataframe()
    assert len(frame) == 35
    assert frame.attrs["restitution"] == RESTITUTION
    assert "frequency" not in frame.attrs


@pytest.mark.parametrize("suffix", [".json", ".nc"])
def test_a_map_is_saved_and_loaded(found: ns.Chart, tmp_path: Path, suffix: str) -> None:
    pytest.importorskip("xarray")
    ns.save(found, tmp_path / f"map{suffix}")
    assert ns.load(tmp_path / f"map{suffix}").as_dict() == found.as_dict()


def test_a_map_that_cannot_be_right_is_refused(found: ns.Chart, tmp_path: Path) -> None:
    path = tmp_path / "map.json"
    ns.save(found, path)
    document = json.loads(path.read_text())
    document["stable"] = document["stable"][:-1]
    path.write_text(json.dumps(document))
    with pytest.warns(ns.FileWarning), pytest.raises(ns.FileError, match="shape of stable"):
        ns.load(path)


def test_the_command_has_the_map(run, tmp_path: Path) -> None:
    path, vary = tmp_path / "map.csv", ("frequency=2.1:2.6:2", "gap=0.1:0.4:2")
    status, out, _ = run(
        "map", *FLAGS, *(q for each in vary for q in ("--vary", each)), "--json", "-o", path
    )
    document = json.loads(out)
    found = ns.chart(STOP, {"frequency": (2.1, 2.6, 2), "gap": (0.1, 0.4, 2)})
    assert status == 0
    assert document["axes"] == found.axes
    assert document["motion"] == found.motion
    kinds = [curve["kind"] for curve in document["curves"]]
    assert kinds == [curve.kind for curve in found.curves]
    assert {*kinds} == {"flip", "grazing"}
    with path.open(newline="") as file:
        rows = list(csv.DictReader(file))
    assert [row["motion"] for row in rows] == [q for row in found.motion for q in row]
    assert {row["stable"] for row in rows} == {"True", "False", ""}


def test_a_picture_names_motions_and_curves(found: ns.Chart) -> None:
    (axes,) = chart_figure(found).axes
    said = [text.get_text() for text in axes.get_legend().get_texts()]
    assert said[:3] == ["1: flight", "2: only flight", "not stable"]
    assert sorted(said[3:]) == ["flip", "fold", "grazing"]
    assert {text.get_text() for text in axes.texts} == {"1", "2"}
    assert axes.get_xlabel() == r"frequency $\Omega$ [rad/s]"


@pytest.mark.parametrize(
    ("axes", "words"),
    [
        ({"gap": (0, 1, 5)}, "axes: got"),
        ({"gap": (0, 1, 5), "mess": (1, 2, 5)}, "parameter: got 'mess'"),
        ({"gap": (0, 1, 5), "mass": (1, 1, 5)}, "mass: got .* expected two different numbers"),
        ({"gap": (0, 1, 5), "mass": (1, 2, 1)}, "expected two different numbers, and 2 to"),
        ({"gap": (0, np.inf, 5), "mass": (1, 2, 5)}, "gap: got"),
    ],
)
def test_axes_that_cannot_be(axes, words: str) -> None:
    with pytest.raises(ValueError, match=words):
        ns.chart(STOP, axes)
    with pytest.raises(TypeError):
        ns.chart("impact", AXES)


def test_ranges_over_which_series_do_not_converge_are_refused(run, few_lines) -> None:
    """A kick changes the velocity by I/m: over a decade that is a series of many terms."""
    clock = str(ROOT / "examples/scenes/escapement.py")
    wide = ("--vary", "mass=0.01:5:2", "--vary", "kick=0.1:0.2:2")
    status, out, err = run("map", clock, *wide)
    assert (status, out) == (2, "")
    words = "--mass: got values from 0.01 to 5, and of kick from 0.1 to 0.2, over which"
    assert words in err
    decade = ns.chart(ns.scene(clock)(), {"mass": (0.5, 5.0, 2), "kick": (0.1, 0.2, 2)})
    assert decade.motion == [["swing", "swing"]] * 2


def test_ctrl_c_keeps_the_rows_that_are_done(found: ns.Chart, monkeypatch) -> None:
    calls = iter(range(1))

    def block_of(*arguments):
        if next(calls, None) is None:
            signal.raise_signal(signal.SIGINT)
        return block.block_of(*arguments)

    monkeypatch.setattr(charts, "block_of", block_of)
    with pytest.raises(Interrupted) as caught:
        ns.chart(STOP, AXES)
    part, rows = caught.value.done, int(str(caught.value).split()[0])
    assert 0 < rows < len(found.index)
    np.testing.assert_array_equal(part.index[:rows], found.index[:rows])
    assert (part.index[rows:] == -1).all()


def test_orbits_that_are_symmetric_on_an_edge_alone(few_lines) -> None:
    """Of half a period they are motions nowhere else, so that the whole ones are followed."""
    stops = ns.scene(ROOT / "examples/scenes/unequal_stops.py")
    branch = ns.branch(stops(left=0.9), "left", 0.9, 1.0)
    assert (branch[0].value, branch[-1].value) == (0.9, 1.0)
    chart = ns.chart(stops(), {"frequency": (1.1, 1.3, 3), "left": (0.9, 1.0, 3)})
    assert {name for row in chart.motion for name in row} == {"back,forth"}


def test_symmetric_orbits_have_one_name_all_over_a_map(monkeypatch) -> None:
    """Also where the declared order, of a whole period, is found as well."""
    monkeypatch.setattr(charts, "LINES", 2)
    stops = ns.scene(ROOT / "examples/scenes/unequal_stops.py")
    chart = ns.chart(stops(left=0.9), {"frequency": (1.0, 1.8, 5), "force": (0.7, 1.8, 4)})
    for force, names in zip(chart.values[1], chart.motion, strict=True):
        for frequency, name in zip(chart.values[0], names, strict=True):
            times = ns.exact(stops(left=0.9, frequency=frequency, force=force)).durations
            assert name == ("back,mirrored" if np.ptp(times) <= 1e-9 else "back,forth")
