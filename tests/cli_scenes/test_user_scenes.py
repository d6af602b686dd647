"""Scenes of users: derived once, kept whole or not at all, found again without SymPy."""

import json
import math
import os
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import pytest
import sympy as sp
from refusals import refused
from user_files import BALL, kernels_of_impact, write

import nonsmooth as ns
from nonsmooth.codegen import generate
from nonsmooth.scene import Event, Parameter, Phase, Scene, a, forcing, v, x
from nonsmooth.scene_files import content, read, store
from nonsmooth.solver.no_orbit import NoOrbit
from nonsmooth.solver.scenes import sealed

pytestmark = pytest.mark.usefixtures("cache")


@pytest.fixture
def derivations(monkeypatch) -> list[str]:
    """Return the names of the scenes that are derived from now on, at no cost."""
    names: list[str] = []

    def sources(scene):
        names.append(scene.name)
        return kernels_of_impact(scene)

    monkeypatch.setattr(generate, "scene_sources", sources)
    return names


@pytest.mark.parametrize("name", ["size", "found", "residual", "np", "coefficients", "row"])
def test_a_parameter_may_have_a_name_that_kernels_use(name: str) -> None:
    """Equations do not use it, and kernels take a scene as numbers."""
    usual, other = (ns.solve(ns.scene(ball(gravity=q))()) for q in ("g", name))
    assert other.durations == usual.durations


def test_a_condition_names_what_it_is_on_whatever_its_words() -> None:
    made = ball()
    r = made.parameters[-1].symbol
    words = "gravity is not too strong"  # of another parameter
    with pytest.raises(ValueError, match=r"got restitution = 0\.8, expected"):
        ns.scene(replace(made, requires={words: 1 - 2 * r}))()


@pytest.mark.parametrize(("least", "question"), [(0, True), (1, False)])
def test_a_demand_of_the_wrong_sign_is_asked_about(least: int, question: bool) -> None:
    made = ball()
    amplitude = made.parameters[1].symbol
    flight = replace(made.phases[0], demands={"above": least * amplitude - x})
    with pytest.raises(NoOrbit) as caught:
        ns.solve(ns.scene(replace(made, phases=(flight,)))())
    why = caught.value.tried[0]
    assert why.endswith("; is the sign of this demand right?") is question
    assert why.startswith("solution 1: throughout flight, not true that above: by") is question


def ball(restitution: float = 0.8, name: str = "ball", gravity: str = "g") -> Scene:
    """Return a scene that is made in place."""
    A, Omega, r = sp.symbols("A Omega r", positive=True)
    g = sp.Symbol(gravity, positive=True)
    flight = Phase(
        "flight", a + g - A * Omega**2 * forcing, ends=Event(x, jump={v: -r * v}),
        demands={"above": x},
    )  # fmt: skip
    return Scene(
        name, "a ball",
        parameters=(
            Parameter("gravity", g, "m/s^2", 9.81, "gravity"),
            Parameter("amplitude", A, "m", 0.004, "amplitude"),
            Parameter("frequency", Omega, "rad/s", 50.0, "frequency"),
            Parameter("restitution", r, "", restitution, "restitution", most=1),
        ),
        phases=(flight,),
        frequency=Omega,
    )  # fmt: skip


def test_a_file_is_derived_once_and_solved(run, tmp_path: Path, cache: Path) -> None:
    path = write(tmp_path)
    status, out, err = run("solve", path, "--method", "c0-tau", "--order", 8, "--json")
    orbit = json.loads(out)
    assert status == 0
    assert "nonsmooth: deriving the equations of bouncing-ball, this once\n" in err
    assert orbit["scene"] == "bouncing-ball"
    by_hand = -math.pi * 9.81 / (0.004 * 50**2) * 0.2 / 1.8
    assert math.sin(orbit["forcing_phase"]) == pytest.approx(by_hand, rel=1e-12)
    assert orbit["phases"][0]["start"]["velocity"] == pytest.approx(
        0.8 * 9.81 * orbit["period"] / 1.8, rel=1e-12
    )
    (folder,) = cache.iterdir()
    assert folder.name == content.key_of_text(path.read_bytes())
    # in another process, without SymPy and without numba
    code = f"import sys, nonsmooth as ns; case = ns.scene({str(path)!r})()\n"
    code += "print(ns.solve(case, 'ck-tau', 8).forcing_phase, ns.solve(case, 'hb', 4).period)\n"
    code += "print([m for m in ('sympy', 'numba', 'nonsmooth.codegen') if m in sys.modules])"
    done = subprocess.run(
        [sys.executable, "-c", code], check=True, capture_output=True, text=True
    )
    assert done.stderr == ""
    first, second = done.stdout.splitlines()
    assert float(first.split()[0]) == orbit["forcing_phase"]
    assert second == "[]"


def test_a_file_is_derived_again_when_it_or_the_program_changes(
    run, tmp_path: Path, cache: Path, derivations, monkeypatch
) -> None:
    path = write(tmp_path)
    for _ in range(2):
        assert run("scenes", path)[0] == 0
    run("scenes", write(tmp_path, name="copy.py"))
    assert derivations == ["bouncing-ball"]
    path.write_text(BALL.replace("0.004", "0.005"))
    run("scenes", path)
    assert derivations == ["bouncing-ball"] * 2
    monkeypatch.setattr(content, "_generator", lambda: b"another program")
    run("scenes", path)
    assert derivations == ["bouncing-ball"] * 3
    assert len(list(cache.iterdir())) == 3


def test_a_file_that_reads_others_is_known_by_its_scene(tmp_path, derivations) -> None:
    """As data in its folder may change, and a copy of it in another folder has others."""
    data = "pathlib.Path(__file__).with_name('data').read_text()"
    text = f"import pathlib\n{BALL.replace('0.004', f'float({data})')}"
    for folder, value in (
        ("one", "0.004"),
        ("two", "0.005"),
        ("one", "0.006"),
        ("one", "0.006"),
    ):
        (tmp_path / folder).mkdir(exist_ok=True)
        (tmp_path / folder / "data").write_text(value)
        ns.scene(write(tmp_path / folder, text, name="ball.py"))
    assert len(derivations) == 3


@pytest.mark.parametrize(
    "line",
    [
        "import numpy as np",
        "from nonsmooth import load",
        "from .matrices import M",
        "M = open('M')",
        "name = __file__",
        "exec('import numpy')",
        "no Python",
    ],
)
def test_a_text_that_reaches_out_does_not_stand_alone(line: str) -> None:
    alone = (
        "import math, sympy.abc\nfrom nonsmooth.scene import Scene\nfrom functools import cache"
    )
    assert content.stands_alone(alone.encode())
    assert not content.stands_alone(f"{alone}\n{line}".encode())


def test_the_hash_is_of_the_whole_symbolic_stage(tmp_path: Path) -> None:
    folder = tmp_path / "codegen"
    for name in ("a.py", "galerkin/b.py", "scenes/impact.py", "equations/c.py", "note.txt"):
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text("")
    found = [path.relative_to(folder).as_posix() for path in content._modules(folder)]
    assert found == ["a.py", "galerkin/b.py"]
    real = {path.name for path in content._modules(Path(generate.FOLDER).parent / "codegen")}
    assert {"generate.py", "whole_period.py", "ck_tau.py", "smoothness.py"} <= real


def test_a_scene_made_in_place_is_known_by_its_content(derivations, capsys) -> None:
    assert ns.scene(ball()).name == "ball"
    assert "deriving the equations of ball, this once" in capsys.readouterr().err
    assert ns.scene(ball()) == ns.scene(ball())
    assert derivations == ["ball"]
    ns.scene(ball(restitution=0.7))
    ns.scene(ball(gravity="G"))
    ns.scene(ball(name="other"))
    assert derivations == ["ball", "ball", "ball", "other"]
    assert capsys.readouterr().out == ""


def test_assumptions_of_symbols_are_content() -> None:
    first, second = (sp.Symbol("q", **{kind: True}) for kind in ("positive", "real"))
    assert content._content(first) != content._content(second)


def test_the_name_of_a_shipped_scene_is_refused(run, tmp_path: Path, derivations) -> None:
    for name in ("impact", "stick-slip-damped"):
        path = write(tmp_path, BALL.replace("bouncing-ball", name))
        assert f"name: got '{name}', the name of a shipped scene" in refused(run, "solve", path)
        with pytest.raises(ns.SceneFileError, match="shipped scene"):
            ns.scene(ball(name=name))
    assert derivations == []


def test_a_scene_that_has_become_a_shipped_one_is_refused(
    run, tmp_path: Path, derivations, monkeypatch
) -> None:
    path = write(tmp_path)
    run("scenes", path)
    from nonsmooth.solver.kernels import registry

    monkeypatch.setattr(registry, "names", lambda: ("bouncing-ball",))
    assert "shipped scene" in refused(run, "scenes", path)


@pytest.mark.parametrize("how", ["file", "no folder"])
def test_without_a_cache_it_goes_on_with_a_word(
    run, tmp_path: Path, derivations, monkeypatch, how
) -> None:
    blocked = tmp_path / "blocked"
    blocked.write_text("")
    monkeypatch.setenv("XDG_CACHE_HOME", str(blocked if how == "file" else "/proc/none"))
    path = write(tmp_path)
    status, out, err = run("scenes", path)
    assert status == 0
    assert "bouncing-ball" in out
    assert "cannot write to" in err
    assert "derived for this run only" in err
    run("scenes", path)
    assert derivations == ["bouncing-ball"]
    (folder,) = store._FOR_NOW.values()
    assert not folder.is_relative_to(blocked)


def test_a_relative_cache_is_none(monkeypatch) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", "relative")
    assert store.root() == Path.home() / ".cache" / "nonsmooth" / "scenes"
    monkeypatch.delenv("XDG_CACHE_HOME")
    assert store.root() == Path.home() / ".cache" / "nonsmooth" / "scenes"


def test_a_derivation_that_breaks_off_leaves_nothing(
    run, tmp_path: Path, cache: Path, monkeypatch
) -> None:
    def broken(scene):
        yield "scene.py", "# half"
        raise ZeroDivisionError("no such\nintegral")

    monkeypatch.setattr(generate, "scene_sources", broken)
    error = refused(lambda *a: _without_progress(run(*a)), "scenes", write(tmp_path))
    assert "ball.py: bouncing-ball cannot be derived (after scene.py): " in error
    assert "ZeroDivisionError: no such integral" in error
    assert not cache.exists()


def _without_progress(outcome):
    status, out, err = outcome
    return status, out, "".join(q for q in err.splitlines(True) if "deriving" not in q)


def test_a_disk_that_fills_up_leaves_nothing(cache: Path, monkeypatch, capsys) -> None:
    written = sealed.write

    def full(files, folder):
        if folder.is_relative_to(cache):
            (folder / "scene.py").write_text("half")
            raise OSError(28, "No space left on device")
        written(files, folder)

    monkeypatch.setattr(sealed, "write", full)
    folder = store.keep("key", {"scene.py": "whole"})
    assert (folder / "scene.py").read_text() == "whole"
    assert "No space left on device" in capsys.readouterr().err
    assert list(cache.iterdir()) == []


def test_two_at_once_both_have_the_kernels(cache: Path) -> None:
    first = store.keep("key", {"scene.py": "a"})
    second = store.keep("key", {"scene.py": "b"})
    assert first == second == store.stored("key")
    assert (first / "scene.py").read_text() == "a"
    assert [path.name for path in cache.iterdir()] == ["key"]


def test_generate_of_a_file_says_where_its_kernels_are(
    run, tmp_path: Path, cache: Path, derivations
) -> None:
    status, out, _ = run("generate", write(tmp_path))
    (folder,) = cache.iterdir()
    assert (status, out) == (0, f"bouncing-ball: its kernels are in {folder}\n")


def test_a_case_file_of_a_users_scene(run, tmp_path: Path, derivations) -> None:
    path, case = write(tmp_path), tmp_path / "case.toml"
    case.write_text("[bouncing_ball]\nmass = 1\n")
    error = refused(
        lambda *a: _without_progress(run(*a)), "solve", path, "--case", case, below=5
    )
    assert "stiffness: missing" in error


@pytest.mark.skipif(os.sep != "/", reason="paths as on POSIX")
def test_what_is_a_path() -> None:
    assert [read.is_path(q) for q in ("impact", "./impact", "a/b", "impact.py", "a.b")] == [
        False, True, True, True, False,
    ]  # fmt: skip
