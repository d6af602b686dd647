"""Broken scene files: one line that names the file and the field, status 2, no traceback."""

from pathlib import Path

import pytest
from refusals import refused
from user_files import BALL, write

import nonsmooth as ns

pytestmark = pytest.mark.usefixtures("cache")


def changed(old: str, new: str) -> str:
    """Return the good file with one thing changed."""
    assert BALL.count(old) == 1, old
    return BALL.replace(old, new)


#: What is wrong, the text, the line that is named, and what is said.
BROKEN = {
    "empty": ("", None, "defines no SCENE, expected SCENE = Scene(...)"),
    "another name": (changed("SCENE = ", "SCENES = "), None, "defines no SCENE"),
    "a number": ("SCENE = 3\n", None, "SCENE: got a value of type int, expected a Scene"),
    "syntax": ("\n\nx = (\n", 3, "'(' was never closed"),
    "a null byte": ("x = 1\0", None, "null bytes"),
    "it stops": ("\n1/0\n", 2, "ZeroDivisionError: division by zero"),
    "it stops deep": ("def f():\n    raise KeyError\nf()\n", 2, "KeyError"),
    "two lines": ("raise ValueError('a\\nb')", 1, "ValueError: a b"),
    "it leaves": ("import sys\nsys.exit(0)\n", 2, "SystemExit: 0"),
    "an import": ("import no_such_module", 1, "ModuleNotFoundError"),
    "a word": (changed("most=1", "moist=1"), 30, "unexpected keyword argument 'moist'"),
    "a unit": (changed('"m/s^2"', '"kg"'), 22, "phase flight: equation: units clash: a"),
    "no tuple": (changed("(FLIGHT,)", "FLIGHT"), 22, "phases: got a Phase, expected a tuple"),
}  # fmt: skip


@pytest.mark.parametrize("what", BROKEN)
def test_what_is_wrong_with_a_file_is_one_line(run, what: str, tmp_path: Path) -> None:
    text, line, words = BROKEN[what]
    path = write(tmp_path, text)
    error = refused(run, "solve", path)
    where = f"{path}, line {line}: " if line else f"{path}: "
    assert error.startswith(f"nonsmooth: {where}"), error
    assert words in error


@pytest.mark.parametrize("command", ["solve", "sweep", "generate", "scenes"])
def test_files_that_are_none(run, command: str, tmp_path: Path) -> None:
    path = tmp_path / "nothing.py"
    assert refused(run, command, path) == f"nonsmooth: {path}: there is no such file\n"
    assert (
        refused(run, command, tmp_path)
        == f"nonsmooth: {tmp_path}: a folder, expected a scene file\n"
    )
    assert "did you mean impact?" in refused(run, command, "impacd")


@pytest.mark.parametrize(
    ("name", "hint"),
    [
        ("case.toml", "; a case file is given by --case"),
        ("orbit.json", "; a saved orbit is given by --from-orbit of branch, or read by load"),
        ("ball.txt", ""),
    ],
)
def test_other_files_are_not_run(run, name: str, hint: str, tmp_path, monkeypatch) -> None:
    (tmp_path / name).write_text("print('it runs')\n")
    monkeypatch.chdir(tmp_path)
    for given in (tmp_path / name, f"./{name}", *([name] if hint else [])):
        words = f"expected a scene file, with a name in .py{hint}"
        assert refused(run, "solve", given) == f"nonsmooth: {Path(given)}: {words}\n"
    with pytest.raises(ns.SceneFileError, match="expected a scene file"):
        ns.equations("ck-tau", scene=f"./{name}")


def test_bytes_that_are_no_text(run, tmp_path: Path) -> None:
    path = tmp_path / "ball.py"
    path.write_bytes(b"\xff\xfe\x00")
    assert refused(run, "scenes", path).startswith(f"nonsmooth: {path}")


def test_a_file_without_its_ending_is_suggested(run, tmp_path: Path, monkeypatch) -> None:
    write(tmp_path)
    monkeypatch.chdir(tmp_path)
    assert "; did you mean ball.py?" in refused(run, "solve", "ball")


def test_what_a_file_prints_is_not_a_result(run, tmp_path: Path) -> None:
    path = write(tmp_path, "print('words')\nSCENE = 3\n")
    status, out, err = run("scenes", path, "--json")
    assert (status, out) == (2, "")
    assert err.startswith("words\n")


def test_from_python_it_is_an_error_of_its_own(tmp_path: Path) -> None:
    path = write(tmp_path, "SCENE = 3\n")
    for what in (path, str(path)):
        with pytest.raises(ns.SceneFileError, match="expected a Scene"):
            ns.scene(what)
    with pytest.raises(ns.SceneFileError) as caught:
        ns.scene(write(tmp_path, BROKEN["a unit"][0]))
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("what", [3, None, b"impact", ["impact"]])
def test_what_is_no_scene_at_all(what: object) -> None:
    with pytest.raises(TypeError, match="expected a name, the path of a scene file"):
        ns.scene(what)
