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

from nonsmooth.cli.commands.paper import FIGURES as NUMBERS
from nonsmooth.report import build
from nonsmooth.report.captions import PLATES


def test_a_folder_is_needed(run) -> None:
    assert "-o" in refused(run, "report")


@pytest.mark.parametrize(
    ("file", "flags", "why"),
    [
        ("report/thesis.tex", (), "has thesis.tex in it"),
        ("report/index.html", (), "has a page that is not ours"),
        ("report", (), "expected a folder"),
        ("other", ("-o", "no/report"), "does not exist"),
        ("other", ("--normal-force", 1e-12), "alpha"),
        (
            "other",
            ("--figure", 5, "-o", "fig5.txt"),
            "a name that ends in one of .png, .svg, .pdf",
        ),
        *(
            (
                "other",
                ("--figure", n),
                f"'--figure': '{n}' is not one of '1', '2', '3', '4', '5', '6'",
            )
            for n in ("0", "7", "2a", "x")
        ),
    ],
)
def test_what_is_refused_leaves_everything_as_it_was(
    run, tmp_path: Path, monkeypatch, file: str, flags: tuple[object, ...], why: str
) -> None:
    monkeypatch.chdir(tmp_path)
    there = tmp_path / file
    there.parent.mkdir(exist_ok=True)
    there.write_text("mine")
    assert why in refused(run, "report", "-o", "report", *flags)
    assert [path for path in tmp_path.rglob("*") if path.is_file()] == [there]
    assert there.read_text() == "mine"
    assert {path.name for path in tmp_path.iterdir()} == {file.partition("/")[0]}


@pytest.mark.parametrize("library", ["matplotlib", "jinja2"])
def test_what_a_report_needs_is_said(run, tmp_path: Path, library: str, monkeypatch) -> None:
    monkeypatch.setattr("nonsmooth.extras.find_spec", lambda name: name != library or None)
    error = refused(run, "report", "-o", tmp_path / "report")
    assert f"needs {library}: pip install 'nonsmooth[report]'" in error


@pytest.fixture
def drawn(monkeypatch) -> list[Figure]:
    """Return the figures that are saved, of orbits that other tests have solved."""
    made: list[Figure] = []

    def keep(figure: Figure, target: Path, **options: object) -> None:
        made.append(figure)
        target.write_bytes(b"")

    monkeypatch.setattr(Figure, "savefig", keep)
    monkeypatch.setattr(build, "Case", case)
    return made


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


def test_the_figures_have_the_numbers_and_their_parts_the_letters_of_the_paper() -> None:
    assert [int(number) for number in NUMBERS] == [plate.number for plate in PLATES]
    parts = build.plate(ODD, 2).axes
    assert [note(axes, "(").get_text() for axes in parts] == ["(a)", "(b)", "(c)", "(d)"]
    assert all(len(data(longest(axes))[0]) > 100 for axes in parts)


@pytest.mark.parametrize(("suffix", "begins"), [(".svg", b"<?xml"), (".png", b"\x89PNG")])
def test_a_figure_is_one_file(run, tmp_path: Path, suffix: str, begins: bytes) -> None:
    target = tmp_path / f"fig1{suffix}"
    assert run("report", "--figure", 1, "-o", target)[0] == 0
    assert [path.name for path in tmp_path.iterdir()] == [target.name]
    assert target.read_bytes().startswith(begins)
