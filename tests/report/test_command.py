"""`nonsmooth report`: what it refuses, and one figure of the paper in a file."""

from pathlib import Path

import numpy as np
import pytest

pytest.importorskip("matplotlib")
pytest.importorskip("jinja2")

from computed import LIGHT, ODD, case
from drawn import data, labels, longest, note, report_axes
from matplotlib.figure import Figure
from refusals import refused

from nonsmooth.cli.paper import FIGURES as NUMBERS
from nonsmooth.report import build
from nonsmooth.report.captions import PLATES


def test_a_folder_is_needed(run) -> None:
    assert "-o" in refused(run, "report")


def test_a_folder_with_other_files_is_left_alone(run, tmp_path: Path) -> None:
    (tmp_path / "thesis.tex").write_text("x")
    assert "has thesis.tex in it" in refused(run, "report", "-o", tmp_path)
    assert [path.name for path in tmp_path.iterdir()] == ["thesis.tex"]


def test_a_page_that_report_did_not_make_is_left_alone(run, tmp_path: Path) -> None:
    (tmp_path / "index.html").write_text("mine")
    assert "has a page that is not ours" in refused(run, "report", "-o", tmp_path)
    assert (tmp_path / "index.html").read_text() == "mine"


def test_a_place_where_no_folder_can_be_is_refused(run, tmp_path: Path) -> None:
    target = tmp_path / "report"
    target.write_text("x")
    assert "expected a folder" in refused(run, "report", "-o", target)
    assert "does not exist" in refused(run, "report", "-o", tmp_path / "no" / "report")


@pytest.mark.parametrize("library", ["matplotlib", "jinja2"])
def test_what_a_report_needs_is_said(run, tmp_path: Path, library: str, monkeypatch) -> None:
    monkeypatch.setattr("nonsmooth.cli.output.find_spec", lambda name: name != library or None)
    error = refused(run, "report", "-o", tmp_path / "report")
    assert f"needs {library}: pip install 'nonsmooth[report]'" in error


def test_an_oscillator_that_float64_cannot_hold(run, tmp_path: Path) -> None:
    assert "alpha" in refused(run, "report", "--normal-force", 1e-12, "-o", tmp_path / "report")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("number", ["0", "7", "2a", "x"])
def test_another_number_is_refused_with_the_list(run, tmp_path: Path, number: str) -> None:
    error = refused(run, "report", "--figure", number, "-o", tmp_path / "fig.pdf")
    assert f"'--figure': '{number}' is not one of '1', '2', '3', '4', '5', '6'" in error
    assert list(tmp_path.iterdir()) == []


def test_a_name_that_is_not_that_of_a_picture_is_refused(run, tmp_path: Path) -> None:
    error = refused(run, "report", "--figure", 5, "-o", tmp_path / "fig5.txt")
    assert "expected a name that ends in one of .png, .svg, .pdf" in error


@pytest.fixture
def drawn(monkeypatch) -> list[Figure]:
    """Return the figures that are saved, of orbits that other tests have solved."""
    made: list[Figure] = []

    def keep(figure: Figure, target: Path) -> None:
        made.append(figure)
        target.write_bytes(b"")

    monkeypatch.setattr(build, "save", keep)
    monkeypatch.setattr(build, "Case", case)
    return made


def test_the_numbers_are_those_of_the_figures_of_the_report() -> None:
    assert [int(number) for number in NUMBERS] == [plate.number for plate in PLATES]


@pytest.mark.parametrize("plate", PLATES, ids=lambda plate: f"{plate.number}")
def test_the_command_draws_the_pictures_of_that_number(run, tmp_path, drawn, plate) -> None:
    target = tmp_path / "figure.pdf"
    assert run("report", "--figure", plate.number, "--normal-force", 100, "-o", target)[0] == 0
    (found,) = drawn
    for axes, name in zip(found.axes, plate.pictures, strict=True):
        alone = report_axes(name, LIGHT)
        assert labels(axes) == labels(alone)
        assert (axes.get_yscale(), axes.get_xlim()) == (alone.get_yscale(), alone.get_xlim())
        for line, expected in zip(axes.lines, alone.lines, strict=True):
            np.testing.assert_array_equal(data(line), data(expected))


def test_the_parts_of_a_figure_have_the_letters_of_the_paper(drawn) -> None:
    parts = build.plate(ODD, 2).axes
    assert [note(axes, "(").get_text() for axes in parts] == ["(a)", "(b)", "(c)", "(d)"]
    assert all(len(data(longest(axes))[0]) > 100 for axes in parts)


@pytest.mark.parametrize(("suffix", "begins"), [(".svg", b"<?xml"), (".png", b"\x89PNG")])
def test_a_figure_is_one_file(run, tmp_path: Path, suffix: str, begins: bytes) -> None:
    target = tmp_path / f"fig1{suffix}"
    assert run("report", "--figure", 1, "-o", target)[0] == 0
    assert [path.name for path in tmp_path.iterdir()] == [target.name]
    assert target.read_bytes().startswith(begins)
