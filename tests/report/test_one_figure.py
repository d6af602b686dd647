"""`nonsmooth report --figure`: one figure of the paper in a file, its axes read back."""

from pathlib import Path

import numpy as np
import pytest

pytest.importorskip("matplotlib")
pytest.importorskip("jinja2")

from computed import LIGHT, ODD, case
from drawn import data, labels, longest, note, report_axes
from matplotlib.figure import Figure
from refusals import refused

from nonsmooth.cli.shortcuts.report import FIGURES as NUMBERS
from nonsmooth.report import build
from nonsmooth.report.captions import PLATES


@pytest.fixture(autouse=True)
def _known(monkeypatch) -> None:
    """Take orbits that other tests have solved."""
    monkeypatch.setattr(build, "Case", case)


def test_the_numbers_are_those_of_the_figures_of_the_report() -> None:
    assert [int(number) for number in NUMBERS] == [plate.number for plate in PLATES]


@pytest.mark.parametrize("plate", PLATES, ids=lambda plate: f"{plate.number}")
def test_a_figure_has_the_axes_of_its_pictures(plate) -> None:
    found = build.plate(ODD, plate.number).axes
    for axes, name in zip(found, plate.pictures, strict=True):
        alone = report_axes(name, ODD)
        assert labels(axes) == labels(alone)
        assert axes.get_yscale() == alone.get_yscale()
        assert axes.get_xlim() == alone.get_xlim()
        for drawn, expected in zip(axes.lines, alone.lines, strict=True):
            np.testing.assert_array_equal(data(drawn), data(expected))


def test_what_the_axes_of_figures_4_and_6_say() -> None:
    said = {n: [labels(axes) for axes in build.plate(ODD, n).axes] for n in (4, 6)}
    assert said == {
        4: [("order N", "T / T exact"), ("order N", "|T / T exact − 1|")],
        6: [("order N", "error (22) of the acceleration")],
    }


def test_the_parts_of_a_figure_have_the_letters_of_the_paper() -> None:
    parts = build.plate(ODD, 2).axes
    assert [note(axes, "(").get_text() for axes in parts] == ["(a)", "(b)", "(c)", "(d)"]
    assert [axes.get_xlim()[1] for axes in parts[1:]] == [1.2] * 3


@pytest.mark.parametrize(("suffix", "begins"), [(".svg", b"<?xml"), (".png", b"\x89PNG")])
def test_a_figure_is_one_file(run, tmp_path: Path, suffix: str, begins: bytes) -> None:
    target = tmp_path / f"fig1{suffix}"
    assert run("report", "--figure", 1, "-o", target)[0] == 0
    assert [path.name for path in tmp_path.iterdir()] == [target.name]
    assert target.read_bytes().startswith(begins)


@pytest.mark.parametrize("number", [2, 5, 6])
def test_the_command_draws_the_figure_of_that_number(
    run, tmp_path: Path, monkeypatch, number: int
) -> None:
    made: list[Figure] = []

    def keep(figure: Figure, target: Path) -> None:
        made.append(figure)
        target.write_bytes(b"")

    monkeypatch.setattr(build, "save", keep)
    target = tmp_path / "figure.pdf"
    assert run("report", "--figure", number, "--normal-force", 100, "-o", target)[0] == 0
    (found,) = made
    for axes, name in zip(found.axes, PLATES[number - 1].pictures, strict=True):
        expected = report_axes(name, LIGHT)
        assert labels(axes) == labels(expected)
        np.testing.assert_array_equal(data(longest(axes)), data(longest(expected)))


@pytest.mark.parametrize("number", ["0", "7", "2a", "x"])
def test_another_number_is_refused_with_the_list(run, tmp_path: Path, number: str) -> None:
    error = refused(run, "report", "--figure", number, "-o", tmp_path / "fig.pdf")
    assert f"'--figure': '{number}' is not one of '1', '2', '3', '4', '5', '6'" in error
    assert list(tmp_path.iterdir()) == []


def test_a_name_that_is_not_that_of_a_picture_is_refused(run, tmp_path: Path) -> None:
    error = refused(run, "report", "--figure", 5, "-o", tmp_path / "fig5.txt")
    assert "expected a name that ends in one of .png, .svg, .pdf" in error
