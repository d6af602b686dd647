"""A new file can be read by whom the umask lets read it; one that is replaced, as before."""

import os
from collections.abc import Iterator
from importlib.util import find_spec
from pathlib import Path

import pytest

import nonsmooth as ns
from nonsmooth.cli.commands import tex
from nonsmooth.solver.trade import measured
from nonsmooth.solver.trade.measured import Trade

pytestmark = pytest.mark.skipif(os.name != "posix", reason="the modes are POSIX")

SOLVE = ("solve", "--method", "c1", "--order", 5)
SWEEP = ("sweep", "--methods", "c1", "--orders", "5,6")
VARY = ("sweep", "--vary", "mass=1:2:3", "--orders", 5)
EQUATIONS = ("equations", "--method", "c1")

DATA = ("result.json", "result.csv", "result.nc")
EVERY = [
    *((command, name) for command in (SOLVE, SWEEP, VARY) for name in DATA),
    *((SOLVE, "orbit.png"), (SWEEP, "sweep.svg"), (VARY, "family.pdf"), (VARY, "family.png")),
    *((EQUATIONS, f"equations.{suffix}") for suffix in ("txt", "tex", "html", "pdf")),
    (("digits",), "digits.json"),
    (("tradeoff",), "times.json"),
]


@pytest.fixture(params=[0o000, 0o022, 0o027, 0o077], ids=oct)
def umask(request) -> Iterator[int]:
    """Set a umask, and see that it is as it was in the end."""
    before = os.umask(request.param)
    yield request.param
    assert os.umask(before) == request.param


def mode_of(path: Path) -> int:
    return path.stat().st_mode & 0o777


def needs(name: str) -> None:
    if name.endswith(".nc"):
        pytest.importorskip("netCDF4")
    if name.endswith((".png", ".svg", ".pdf")):
        pytest.importorskip("matplotlib")


@pytest.fixture
def without_work(monkeypatch) -> None:
    """Replace what is written by what is quick."""
    monkeypatch.setattr(tex, "engine", lambda: "pdflatex")
    monkeypatch.setattr(tex, "pdf", lambda text: b"%PDF")
    if find_spec("matplotlib"):
        monkeypatch.setattr(
            "matplotlib.figure.Figure.savefig",
            lambda figure, path, **options: Path(path).write_bytes(b"a picture"),
        )
    monkeypatch.setattr("nonsmooth.solver.precision.digits.measure", lambda *arguments: [])
    monkeypatch.setattr(measured, "trade", lambda case, _: Trade(case, ()))


@pytest.mark.usefixtures("without_work")
@pytest.mark.parametrize("umask", [0o027], ids=oct, indirect=True)
@pytest.mark.parametrize(
    ("command", "name"), EVERY, ids=lambda value: value if isinstance(value, str) else value[0]
)
def test_every_file_has_the_mode_of_a_new_file(
    command: tuple[object, ...], name: str, umask: int, run, tmp_path: Path
) -> None:
    needs(name)
    target = tmp_path / name
    if command == ("digits",):
        pytest.importorskip("flint")
    assert run(*command, "-o", target)[0] == 0
    assert [path.name for path in tmp_path.iterdir()] == [name]
    assert mode_of(target) == 0o640


@pytest.mark.parametrize("name", DATA)
def test_a_saved_file_has_the_mode_of_a_new_file(name: str, umask: int, tmp_path: Path) -> None:
    needs(name)
    target = tmp_path / name
    ns.save(ns.family(ns.scene("impact")(), "mass", [1.0], order=5), target)
    assert mode_of(target) == 0o666 & ~umask


@pytest.mark.parametrize("mode", [0o600, 0o640, 0o664, 0o444], ids=oct)
@pytest.mark.parametrize("linked", [True, False], ids=["linked", "itself"])
def test_a_file_that_is_replaced_keeps_its_mode(
    mode: int, linked: bool, run, tmp_path: Path
) -> None:
    target = tmp_path / "orbit.json"
    target.write_text("old")
    target.chmod(mode)
    if linked:
        target = tmp_path / "link.json"
        target.symlink_to("orbit.json")
    assert run(*SOLVE, "-o", target)[0] == 0
    assert '"schema"' in target.read_text()
    assert mode_of(target) == mode


@pytest.mark.parametrize("there", [True, False], ids=["old", "new"])
def test_a_folder_and_the_files_in_it_have_theirs(
    there: bool, umask: int, run, tmp_path: Path, monkeypatch
) -> None:
    pytest.importorskip("matplotlib")
    pytest.importorskip("jinja2")
    target = tmp_path / "report"

    def build(belt: ns.StickSlip, folder: Path, done: object) -> None:
        (folder / "index.html").write_text('<meta name="generator" content="nonsmooth 1">')

    monkeypatch.setattr("nonsmooth.report.build.build", build)
    for _ in range(1 + there):
        assert run("report", "-o", target)[0] == 0
    assert mode_of(target) == 0o777 & ~umask
    assert mode_of(target / "index.html") == 0o666 & ~umask
