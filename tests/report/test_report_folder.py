"""What `nonsmooth report` refuses: folders that are not its own, libraries that are missing."""

from pathlib import Path

import pytest
from refusals import refused


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


def test_a_file_in_the_place_of_the_folder(run, tmp_path: Path) -> None:
    target = tmp_path / "report"
    target.write_text("x")
    assert "expected a folder" in refused(run, "report", "-o", target)


def test_a_folder_in_no_folder(run, tmp_path: Path) -> None:
    assert "does not exist" in refused(run, "report", "-o", tmp_path / "no" / "report")


@pytest.mark.parametrize("library", ["matplotlib", "jinja2"])
def test_what_a_report_needs_is_said(run, tmp_path: Path, library: str, monkeypatch) -> None:
    monkeypatch.setattr("nonsmooth.cli.output.find_spec", lambda name: name != library or None)
    error = refused(run, "report", "-o", tmp_path / "report")
    assert f"needs {library}: pip install 'nonsmooth[report]'" in error


def test_an_oscillator_that_float64_cannot_hold(run, tmp_path: Path) -> None:
    assert "alpha" in refused(run, "report", "--normal-force", 1e-12, "-o", tmp_path / "report")
    assert list(tmp_path.iterdir()) == []
