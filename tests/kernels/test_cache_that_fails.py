"""Where numba's cache cannot be read or written, kernels are compiled and one line says so.

What is damaged in it is compiled anew, and what others could have written is not used.
"""

import errno
import importlib
import os
import random
import shutil
import subprocess
import sys
import warnings
from pathlib import Path

import numba
import pytest
from every_run import tried

import nonsmooth
from nonsmooth.cli.problems import print_warnings
from nonsmooth.solver.kernels import compiling
from nonsmooth.solver.kernels.compiling import CacheWarning, jit


@pytest.fixture
def double(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    """Return a function of a file, with an empty cache in a folder of its own."""
    (tmp_path / "doubling.py").write_text(
        "def double(x):\n    return 2 * x\n\n\ndef triple(x):\n    return 3 * x\n"
    )
    monkeypatch.syspath_prepend(tmp_path)
    monkeypatch.setattr(numba.config, "CACHE_DIR", str(tmp_path / "cache"))
    monkeypatch.setattr(compiling, "_SAID", [])
    yield importlib.import_module("doubling").double
    del sys.modules["doubling"]


def test_a_cache_that_works_is_used(double) -> None:
    assert [jit(double)(2), jit(double)(3)] == [4, 6]
    again = jit(double)
    assert again(4) == 8
    assert sum(again.stats.cache_hits.values()) == 1


def filled(double) -> tuple[object, list[Path]]:
    """Fill the cache with two functions of two types; return the other, and codes and index."""
    triple = sys.modules["doubling"].triple
    for function in (jit(double), jit(triple)):
        function(2), function(2.5)
    return triple, sorted(Path(function.stats.cache_path).glob("*.nb[ci]"))


def damage(files: list[Path], dice: random.Random) -> None:
    """Change a file as a disk, a crash or a hand might."""
    first, second = dice.sample(files, 2)
    content = bytearray(first.read_bytes())
    kind = dice.choice(("empty", "cut", "flip", "swap", "remove", "zeros"))
    if kind == "swap":
        first.write_bytes(second.read_bytes())
        second.write_bytes(content)
    elif kind == "remove":
        first.unlink()
    elif kind == "flip":
        content[dice.randrange(len(content))] ^= 1 << dice.randrange(8)
        first.write_bytes(content)
    else:
        size = 0 if kind == "empty" else dice.randrange(len(content))
        lost = len(content) - size if kind == "zeros" else 0
        first.write_bytes(content[:size] + bytes(lost))


#: Seeds of each kind of damage, to the code and, as a rule, to the index.
EACH_KIND = (0, 3, 6, 7, 9, 13, 14)


@pytest.mark.parametrize("seed", tried(range(300), every_run=EACH_KIND))
def test_damaged_files_are_compiled_anew(seed: int, double) -> None:
    triple, files = filled(double)
    damage(files, random.Random(seed))
    for _ in range(2):
        assert [jit(double)(2), jit(double)(2.5)] == [4, 5.0]
        assert [jit(triple)(2), jit(triple)(2.5)] == [6, 7.5]
    again = jit(double)
    assert again(4) == 8
    assert sum(again.stats.cache_hits.values()) == 1  # and kept anew


def test_code_in_the_place_of_another_is_not_run(double) -> None:
    """Well-formed code of another function, or of the same for other types."""
    triple, files = filled(double)
    double_1, double_2, triple_1 = (
        next(path for path in files if f"{name}-" in path.name and path.name.endswith(end))
        for name, end in (("double", "1.nbc"), ("double", "2.nbc"), ("triple", "1.nbc"))
    )
    double_1.write_bytes(triple_1.read_bytes())
    assert jit(double)(2) == 4
    double_2.write_bytes(double_1.read_bytes())
    assert [jit(double)(2.5), jit(double)(2), jit(triple)(2)] == [5.0, 4, 6]


@pytest.mark.skipif(not hasattr(os, "getuid"), reason="a system without numbers of users")
@pytest.mark.parametrize("what", ["folder", "index", "code"])
@pytest.mark.parametrize("how", ["written by others", "another user"])
def test_what_others_could_have_written_is_not_run(what: str, how: str, double) -> None:
    _, files = filled(double)
    path = {"folder": files[0].parent, "code": files[0], "index": files[2]}[what]
    if how == "written by others":
        path.chmod(0o777)
    elif os.getuid() == 0:
        os.chown(path, 12345, -1)
    else:
        pytest.skip("only root gives files to others")
    with pytest.warns(CacheWarning, match=rf"{path}: .*{how}; kernels are"):
        function = jit(double)
    with warnings.catch_warnings(action="error"):  # and nothing more is said
        assert [function(2), jit(double)(2.5)] == [4, 5.0]
    assert not function.stats.cache_path


@pytest.mark.skipif(not hasattr(os, "getuid"), reason="a system without numbers of users")
def test_a_group_that_may_change_the_source_may_write_to_the_cache(double) -> None:
    _, files = filled(double)
    for path in (files[0].parent, Path(sys.modules["doubling"].__file__).parent):
        path.chmod(0o775)
    assert jit(double).stats.cache_path


def test_what_is_kept_is_writable_by_its_user_alone(double) -> None:
    before = os.umask(0)
    try:
        _, files = filled(double)
    finally:
        assert os.umask(before) == 0
    for path in (files[0].parent, *files):
        assert path.stat().st_mode & 0o022 == 0


def test_a_cache_that_cannot_be_written(double, tmp_path: Path) -> None:
    function = jit(double)
    folder = Path(function.stats.cache_path)
    shutil.rmtree(folder)
    folder.touch()  # a file in its place: neither read nor written
    words = f"numba's cache: {folder}: Not a directory; kernels are compiled for this process"
    with pytest.warns(CacheWarning) as said:
        assert function(2) == 4
    assert [str(each.message).startswith(words) for each in said] == [True]
    assert function(2.5) == 5.0  # of other types, compiled too, and nothing more is said


def test_a_disk_that_is_full_when_it_is_written(double, monkeypatch) -> None:
    function = jit(double)

    def full(overloads: object) -> None:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr(function._cache._cache_file, "_save_index", full)
    with pytest.warns(CacheWarning, match="No space left on device"):
        assert function(2) == 4
    assert not list(Path(function.stats.cache_path).glob("*.nbc"))


def test_no_folder_can_be_written(double, monkeypatch) -> None:
    locator = numba.core.caching._CacheLocator

    def refuse(self) -> None:
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr(locator, "ensure_cache_path", refuse)
    with pytest.warns(CacheWarning, match="__pycache__: not writable, and no other folder is;"):
        function = jit(double)
    assert function(2) == 4


def test_the_command_line_says_it_in_one_line(monkeypatch, capsys) -> None:
    monkeypatch.setattr(warnings, "showwarning", warnings.showwarning)
    monkeypatch.setattr(compiling, "_SAID", [])
    with warnings.catch_warnings():
        warnings.simplefilter("always")
        print_warnings()
        compiling._warn_once("/a/folder", "full")
        compiling._warn_once("/another/folder", "full")
    words = "numba's cache: /a/folder: full; kernels are compiled for this process alone"
    assert capsys.readouterr().err == f"nonsmooth: {words}\n"


def test_warnings_of_others_stay_what_they_are(monkeypatch) -> None:
    shown = []
    monkeypatch.setattr(warnings, "showwarning", lambda *arguments: shown.append(arguments))
    with warnings.catch_warnings():
        warnings.simplefilter("always")
        print_warnings()
        warnings.warn("of another", UserWarning, stacklevel=1)
    assert [str(arguments[0]) for arguments in shown] == ["of another"]


#: The command, with kernels that are compiled at once.
COMPILED = """
from nonsmooth.solver.kernels.account import Account
Account.pays = lambda account: True
from nonsmooth.__main__ import main
main()
"""


@pytest.mark.long
def test_the_command_solves_with_files_of_no_size(tmp_path: Path) -> None:
    resource = pytest.importorskip("resource")
    environment = os.environ | {
        "NUMBA_CACHE_DIR": str(tmp_path / "cache"),
        "PYTHONPATH": str(Path(nonsmooth.__file__).parents[1]),
        "PYTHONDONTWRITEBYTECODE": "1",  # Python 3.11 keeps what is cut
    }
    done = subprocess.run(
        [sys.executable, "-c", COMPILED, "sweep", "--method", "hb", "--orders", "60-62"],
        env=environment, capture_output=True, text=True, check=False,
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (1000, 1000)),
    )  # fmt: skip
    assert done.returncode == 0
    assert done.stdout.count("  0.67") == 3
    said = [line for line in done.stderr.splitlines() if line.startswith("nonsmooth: ")]
    assert len(said) == 1
    assert said[0].startswith(f"nonsmooth: numba's cache: {tmp_path / 'cache'}")
    assert said[0].endswith(": File too large; kernels are compiled for this process alone")
