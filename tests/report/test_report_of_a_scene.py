"""The page on one oscillator: its numbers, its figures, and that it stands by itself."""

import re
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import partial
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from one_mass import NAMES
from written import Elements

import nonsmooth as ns
from nonsmooth.report import pictures
from nonsmooth.report.pictures import figure
from nonsmooth.report.scenes import collected, gallery
from nonsmooth.report.scenes import scene_figures as figures
from nonsmooth.report.scenes.collected import (
    Collected,
    collect,
    overshoot,
    rate_of_jump,
    rate_of_times,
)
from nonsmooth.report.scenes.scene_page import GIBBS, beside, multipliers, page
from nonsmooth.solver.stability.monodromy import NoMultipliersError
from nonsmooth.solver.stability.stability import Stability

CASE = ns.scene("impact")(gap=0.2)


@pytest.fixture(scope="module")
def found() -> Collected:
    """Return the numbers of the page, from few orders."""
    patch = pytest.MonkeyPatch()
    patch.setattr(collected, "POWER_ORDERS", (4, 8, 16))
    patch.setattr(collected, "FACTOR_ORDERS", (2, 4, 6, 8))
    told: list[str] = []
    result = collect(CASE, ns.exact(CASE), told.append)
    patch.undo()
    assert len(told) == collected.steps(CASE)
    return result


def test_the_errors_are_those_of_the_orbits(found: Collected) -> None:
    ways = {way.name: (way, curve) for way, curve in found.curves.items()}
    assert list(ways) == [
        "hb", "hb-c0, K = 1", "hb-c0, K = 2", "hb-c0, K = 3", "c0", "c0-tau"
    ]  # fmt: skip
    way, curve = ways["hb-c0, K = 3"]
    orbit = ns.solve(CASE, "hb-ck", 8, functions=3)
    assert list(curve) == [4, 8, 16]
    assert curve[8] == orbit.errors
    assert list(ways["c0-tau"][1]) == [4, 6, 8]  # none at 2
    assert way.functions == 3


def test_a_fourier_series_rings_by_the_constant_of_gibbs() -> None:
    belt = ns.scene("stick-slip")()
    exact = ns.exact(belt)
    errors = [abs(overshoot(ns.solve(belt, "hb", N), exact) - GIBBS) for N in (20, 80)]
    assert errors[1] < 2e-3
    assert errors[1] < errors[0]
    assert abs(overshoot(ns.solve(belt, "ck-tau", 12), exact)) < 1e-6


def test_the_theory_is_that_of_the_references() -> None:
    """Hold it against the measured rates of each class: K = 0, 1, 2, 3."""
    expected = {
        "impact": [1, 1, 3, 3], "stick-slip": [1, 3, 3, 5], "clearance": [3, 5, 5, 7],
        "elastic-plastic": [3, 5, 5, 7],
    }  # fmt: skip
    for name, rates in expected.items():
        case = ns.scene(name)()
        assert [rate_of_times(case, K) for K in range(4)] == rates
    belt = ns.scene("stick-slip")()
    assert [rate_of_jump(belt, K) for K in range(4)] == [0.5, 1.5, 2.5, 3.5]
    assert rate_of_jump(ns.scene("impact")(), 1) == 1  # as slowly as the times


def test_the_slopes_that_are_drawn_are_those_of_theory(found: Collected) -> None:
    axes = figure(partial(figures.convergence, "times"), found).axes[0]
    drawn = {line.get_label(): line for line in axes.lines}
    curves = {way.name: curve for way, curve in found.curves.items()}
    assert list(drawn["hb"].get_ydata()) == [each.times for each in curves["hb"].values()]
    grey = [line for line in axes.lines if line.get_color() == "0.75"]
    slopes = [
        -np.diff(np.log(line.get_ydata())) / np.diff(np.log(line.get_xdata())) for line in grey
    ]
    assert [round(float(slope[0]), 9) for slope in slopes] == [1, 1, 3, 3]
    assert "error of the times" in axes.get_ylabel()


def test_the_derivative_that_jumps_is_drawn_with_its_jump(found: Collected) -> None:
    axes = figure(figures.jumping, found).axes[0]
    exact = next(line for line in axes.lines if line.get_label() == "exact")
    part, values = exact.get_data()
    assert part[-1] == pytest.approx(1.2, abs=2e-3)
    phase = found.exact.phases[0]
    assert values[0] == pytest.approx(phase.velocity, rel=1e-12)  # C0: the velocity jumps
    before, after = values[part == 1]
    assert before == pytest.approx(-phase.velocity / CASE.values["restitution"], rel=1e-9)
    assert after == values[0]
    assert "m/s" in axes.get_ylabel()


def test_the_page_says_the_numbers(found: Collected) -> None:
    pictures = dict.fromkeys(figures.figures_of(CASE), '<svg viewBox="0 0 1 1"></svg>')
    assert set(pictures) == set(figures.FIGURES)
    assert set(figures.SKETCHES) >= set(NAMES)
    text = page(found, "<h3>equations</h3>", pictures)
    assert Elements(text).open == []
    assert not re.search(r'(?:src|href)="(?!#)', text)
    assert f"{found.exact.period:.12g}" in text
    assert f"{found.exact.forcing_phase:.12g}" in text
    assert "0.2 m" in text
    assert "x is continuous, x′ jumps where" in " ".join(text.split())
    curve = next(curve for way, curve in found.curves.items() if way.name == "c0-tau")
    assert f"{curve[8].times:.1e} at N = 8" in text
    beyond = gallery.overshoots(found).splitlines()
    for (name, orbit), line in zip(found.ringing.items(), beyond, strict=True):
        percent = 100 * overshoot(orbit, found.exact)
        assert f"{name}, N = {orbit.order}: {max(0.0, percent):.2g} %" in text
        assert line.startswith(name)
        assert line.endswith(f"{round(percent, 2) + 0.0:6.2f} %")  # and no -0.00
    assert text.count('role="img"') == len(pictures)
    lines = gallery.table_of_rates(found).splitlines()
    assert lines[0].split() == ["expansion", "times", "theory", "jump", "theory"]
    assert [line.split("  ")[0] for line in lines[1:]] == [way.name for way in found.curves]
    table = text.partition("<h3>Stability</h3>")[2].partition("</table>")[0]
    assert "The orbit is stable." in table
    assert "a shift in time" not in table  # it is forced
    rows = re.findall(r"<tr><td>(.*?)</td><td>(.*?)</td><th[^>]*>(.*?)</th></tr>", table)
    values = [
        float(modulus) * np.exp(1j * float(argument.replace("−", "-")))
        for modulus, argument, _ in rows
    ]
    assert values == pytest.approx(list(ns.exact(CASE).multipliers), rel=1e-4)
    assert [stable for _, _, stable in rows] == ["stable"] * 2


@pytest.mark.parametrize(
    ("value", "row"),
    [
        (0.5, ("0.5", "0", "stable")),
        (-1.25, ("1.25", "3.1416", "unstable")),
        (1 + 1e-13, ("1", "0", "neither, to rounding")),
        (0, ("0", "none", "stable")),
    ],
)
def test_a_multiplier_is_judged_by_its_modulus(value: float, row: tuple[str, ...]) -> None:
    values = np.array([value], dtype=complex)
    motion = SimpleNamespace(
        stability=Stability(values, 1.0, 1e-12), multipliers=values, stable=True
    )
    found = multipliers(motion)  # type: ignore[arg-type]
    shown = dict(zip(("modulus", "argument", "stable"), row, strict=True))
    assert (found["rows"], found["shift"]) == ([shown], True)


def test_rounding_beside_the_largest_is_printed_as_nothing() -> None:
    assert [beside(v, (-1.5, 0.2)) for v in (-1.25, 1e-13, -3e-16)] == ["-1.25", "1e-13", "0"]


def test_an_orbit_may_have_lost_multipliers_or_have_none(monkeypatch) -> None:
    row = {"modulus": "0", "argument": "none", "stable": "stable"}
    found = multipliers(ns.exact(ns.scene("stick-slip")()))  # autonomous
    assert found == {"rows": [row], "smaller": 0, "verdict": "stable", "shift": True}

    def touched(motion: object) -> None:
        raise NoMultipliersError("an event is touched")

    monkeypatch.setattr("nonsmooth.solver.orbit.motion.stability", touched)
    found = multipliers(ns.exact(ns.scene("impact")(gap=0.21)))
    assert found == {
        "rows": [], "smaller": 0, "verdict": "an event is touched", "shift": False
    }  # fmt: skip


def test_the_command_writes_a_folder_on_an_order_that_is_not_declared(
    run, tmp_path: Path, monkeypatch
) -> None:
    monkeypatch.setattr(collected, "POWER_ORDERS", (4,))
    monkeypatch.setattr(collected, "FACTOR_ORDERS", (12, 16))
    target = tmp_path / "page"
    flags = "--frequency", 0.12, "--damping", 0.05
    assert run("report", "dry-friction", *flags, "-o", target)[0] == 0
    names = {path.name for path in target.iterdir()}
    assert names == {"index.html"} | {
        name + suffix for name in figures.FIGURES for suffix in (".svg", ".pdf")
    }
    text = (target / "index.html").read_text("utf-8")
    assert "a driven mass with dry friction" in text
    assert 'id="sketch-' in text
    order = "slide,stop,-slide,stop,mirrored"
    assert f"The motion is <code>{order}</code>; a minus stands for the mirror image" in text
    assert re.findall("<h4>(.*?)</h4>", text) == ["slide", "stop"]
    assert text.count("It begins at a switch of class C1: x&#39;&#39; is the first") == 2
    assert "slide_m" in text  # the equations are those of this order


def test_a_page_on_a_structure(run, tmp_path: Path, monkeypatch) -> None:
    """Of impulses alone each order is exact; of many multipliers the largest are told."""
    monkeypatch.setattr(collected, "POWER_ORDERS", (8, 16))
    monkeypatch.setattr(collected, "FACTOR_ORDERS", (4, 6))
    monkeypatch.setattr(pictures, "SUFFIXES", (".svg",))
    texts, progress = [], []

    @contextmanager
    def counted(total: int, task: str) -> Iterator[Callable[[str], None]]:
        done: list[str] = []
        yield done.append
        progress.append((total, len(done)))

    monkeypatch.setattr("nonsmooth.cli.commands.paper.progress", counted)
    for name in ("chain-impact", "jenkins-absorber"):
        target = tmp_path / name
        assert run("report", name, "-o", target)[0] == 0
        text = (target / "index.html").read_text("utf-8")
        assert Elements(text).open == []
        assert "the structure answers it by its poles" in " ".join(text.split())
        assert "Gibbs" not in text
        assert 'id="sketch-' not in text
        texts.append(text)
    impacts, slides = texts
    assert [total - done for total, done in progress] == [0, 0]
    exact = ns.exact(ns.scene("chain-impact")())
    assert f"There are {len(exact.multipliers) - 8} smaller ones." in impacts
    assert f"{abs(exact.multipliers[0]):.5g}" in impacts
    assert not re.search("N\\^-", impacts)
    row = r"<th[^>]*>hb[^<]*</th><td>[^<]*</td><td>(.*?)</td>\s*<td>[^<]*</td><td>(.*?)</td>"
    theory = [(f"N^-{power}", "") for power in (3, 5, 5, 7)]
    assert re.findall(row, slides) == theory


def test_the_thesis_is_measured_beside_its_theory() -> None:
    rows = gallery.thesis(["dry-friction"], orders=(8, 16))
    assert [row[:3] for row in rows] == [("dry-friction", "C1", K) for K in range(4)]
    for _, _, _, measured, theory in rows:
        assert measured == pytest.approx(theory, abs=0.4)
