"""Bad input: one line that names the argument, the value and what was expected; status 2."""

import os
from pathlib import Path

import pytest
from refusals import refused

from nonsmooth.kim_perkins import SECTION_4 as GOOD

POSITIVE = ("mass", "stiffness", "belt_speed", "mu_s", "normal_force")


@pytest.mark.parametrize("name", POSITIVE)
@pytest.mark.parametrize("value", ["abc", "0", "-1", "inf", "-inf", "nan", "1e400", ""])
@pytest.mark.parametrize("command", [("solve", "--method", "c1"), ("sweep",)])
def test_parameters_that_are_no_positive_number(run, name: str, value: str, command) -> None:
    flag = f"--{name.replace('_', '-')}"
    error = refused(run, *command, f"{flag}={value}")
    assert flag in error or f"{name}: got" in error
    assert "positive number" in error or "valid float" in error


@pytest.mark.parametrize("order", ["0", "-3", "1000001", "2.5", "many", ""])
@pytest.mark.parametrize("method", ["hb", "hb-c1", "c1"])
def test_an_order_that_the_method_cannot(run, method: str, order: str) -> None:
    error = refused(run, "solve", "--method", method, f"--order={order}")
    assert "order" in error
    assert "expected a whole number from 1" in error or "valid integer" in error


def case_file(folder: Path, text: str | bytes) -> Path:
    path = folder / "belt.toml"
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    return path


def table(**changes: object) -> str:
    values = {name: value for name, value in (GOOD | changes).items() if value is not None}
    return "[stick_slip]\n" + "".join(f"{name} = {value}\n" for name, value in values.items())


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("", "no table [stick_slip]"),
        ("stick_slip = 3\n", "no table [stick_slip]"),
        ("[belt]\nmass = 1\n", "no table [stick_slip]"),
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
    ],
)
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


@pytest.mark.parametrize(
    "content", [f"mass = {'9' * 5000}", "x = " + "[" * 100_000], ids=["figures", "depth"]
)
def test_a_case_file_beyond_what_python_reads(run, content: str, tmp_path: Path) -> None:
    case = tmp_path / "belt.toml"
    case.write_text(f"[stick_slip]\n{content}\n")
    assert f"--case: {case} is not TOML: " in refused(run, "solve", "--case", case)


def test_a_case_file_with_the_mark_of_an_editor(run, tmp_path: Path) -> None:
    case = tmp_path / "belt.toml"
    lines = "".join(f"{name} = {value}\n" for name, value in GOOD.items())
    case.write_text("[stick_slip]\n" + lines, encoding="utf-8-sig")
    assert run("solve", "--method", "c1", "--order", 5, "--case", case)[0] == 0


@pytest.mark.parametrize("command", ["equations", "solve", "simulate"])
def test_a_scene_of_no_letters_is_not_the_default(run, command: str) -> None:
    assert "got '', expected one of" in refused(run, command, "")
