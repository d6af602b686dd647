"""Bad input: one line that names the argument, the value and what was expected; status 2."""

import os
from pathlib import Path

import pytest
from refusals import refused

from nonsmooth.kim_perkins import SECTION_4 as GOOD


def case_file(folder: Path, text: str | bytes) -> Path:
    path = folder / "belt.toml"
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    return path


def table(**changes: object) -> str:
    values = {name: value for name, value in (GOOD | changes).items() if value is not None}
    return "[stick_slip]\n" + "".join(f"{name} = {value}\n" for name, value in values.items())


WRONG: list[tuple[str | bytes, str]] = [
    ("", "no table [stick_slip]"),
    ("stick_slip = 3\n", "no table [stick_slip]"),
    ("[belt]\nmass = 1\n", "no table [stick_slip], but [belt]"),
    (b"\x00\xff\xfe\x80binary", "not a text file"),
    (b"\x00\x01\x02", "is not TOML"),
    ("[stick_slip\n", "is not TOML"),
    ("mass = \n", "is not TOML"),
    (table(mass=None), "mass: missing"),
    (table(mas=1.0), "mas: not a parameter of stick-slip; did you mean mass?"),
    (table(colour='"red"'), "colour: not a parameter of stick-slip"),
    (table(cycles=2), "cycles: not a parameter of stick-slip"),
    (table(mass='"10"'), "mass: got '10', expected a positive number"),
    (table(mass="true"), "mass: got True, expected a positive number"),
    (table(mass="[1.0]"), "mass: got [1.0], expected a positive number"),
    (table(mass="nan"), "mass: got nan"),
    (table(mass="inf"), "mass: got inf"),
    (table(mass="-2"), "mass: got -2"),
    (table(mu_k="0.5"), "expected less than mu_s"),
    (table(mass="1" + "0" * 400), "mass: got 1000"),
    (table() + "[other]\nx = 1\n", "unknown 'other'"),
    (f"[stick_slip]\nmass = {'9' * 5000}\n", "is not TOML"),
    ("x = " + "[" * 100_000, "is not TOML"),
]


@pytest.mark.parametrize(("text", "expected"), WRONG, ids=[words for _, words in WRONG])
def test_a_wrong_case_file(run, tmp_path: Path, text: str | bytes, expected: str) -> None:
    path = case_file(tmp_path, text)
    error = refused(run, "solve", "--case", path)
    assert expected in error
    assert str(path) in error


def test_a_case_file_that_cannot_be_read(run, tmp_path: Path) -> None:
    assert "cannot read" in refused(run, "solve", "--case", tmp_path / "none.toml")
    assert "cannot read" in refused(run, "solve", "--case", tmp_path)


@pytest.mark.parametrize("command", ["solve", "sweep", "equations"])
def test_an_output_that_cannot_be(run, tmp_path: Path, command: str) -> None:
    assert "does not exist" in refused(run, command, "-o", tmp_path / "none" / "x.json")
    folder = tmp_path / "x.json"
    folder.mkdir()
    assert "is a folder" in refused(run, command, "-o", folder)
    closed = Path("/proc/self")
    if os.name != "posix" or not closed.is_dir():
        closed = tmp_path
        closed.chmod(0o500)
    assert "cannot write" in refused(run, command, "-o", closed / "x.json")


def test_a_case_file_with_the_mark_of_an_editor(run, tmp_path: Path) -> None:
    case = case_file(tmp_path, table().encode("utf-8-sig"))
    assert run("solve", "--method", "c1", "--order", 5, "--case", case)[0] == 0


@pytest.mark.parametrize("command", ["equations", "solve", "simulate"])
def test_a_scene_of_no_letters_is_not_the_default(run, command: str) -> None:
    assert "got '', expected one of" in refused(run, command, "")
