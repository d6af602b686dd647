"""generated/ is what the derivation gives, to the byte; and nothing old survives it."""

import dataclasses
import importlib.util
import os
import subprocess
import sys
import types
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import numba
import numpy as np
import pytest
import sympy as sp
from numpy.testing import assert_array_equal
from paper import METHODS

from nonsmooth import codegen as derived
from nonsmooth.codegen import derive, generate, scenes
from nonsmooth.codegen.expansions import kernels as kernels_of_a_scene
from nonsmooth.codegen.shortcuts import emit
from nonsmooth.codegen.system import ClosedForm, GalerkinSystem
from nonsmooth.solver import compiling
from nonsmooth.solver.shortcuts.search import kernels

DERIVE = """
import sys
from nonsmooth.codegen import generate, scenes
if len(sys.argv) > 1:
    scenes.names, generate.SHORTCUTS = lambda: tuple(sys.argv[1:]), "left_out"
    generate.space.sources = dict
for name, text in generate.sources().items():
    if (generate.FOLDER / name).read_text("utf-8") != text:
        print(name)
"""


@pytest.mark.parametrize("names", [("impact",), pytest.param((), marks=pytest.mark.long)])
def test_a_derivation_in_another_process_gives_the_committed_files(names: tuple[str]) -> None:
    """The text does not depend on the process: neither on its hashes nor on its clock.

    All is derived by `make test-long`, and by `make lint`.
    """
    environment = os.environ | {"PYTHONHASHSEED": "12345"}
    command = [sys.executable, "-c", DERIVE, *names]
    done = subprocess.run(command, check=True, env=environment, capture_output=True)
    assert done.stdout == b""


@pytest.mark.parametrize("method", [*derived.METHODS, *derived.SOLVED])
def test_the_kernels_of_the_paper_are_what_is_derived(method: str) -> None:
    path = generate.FOLDER / generate.SHORTCUTS / f"{method.replace('-', '_')}.py"
    assert path.read_text("utf-8") == emit.module_source(derive(method))


def test_the_folder_has_the_files_of_every_scene_and_no_others() -> None:
    found = {path.parent.name for path in generate.FOLDER.glob("*/scene.py")}
    assert found == {name.replace("-", "_") for name in scenes.names()}
    for scene in map(scenes.load, scenes.names()):
        folder = generate.FOLDER / scene.name.replace("-", "_")
        own = (scene.of_motion(motion) for motion in scene.motions)
        kernels = kernels_of_a_scene(next(own, scene))
        expected = {"__init__", "scene", *kernels}
        motions = [folder / motion.replace("-", "_") for motion in scene.motions]
        for each in motions or [folder]:
            assert {path.stem for path in each.glob("*.py")} == expected
        if motions:
            assert {path.stem for path in folder.glob("*.py")} == {"__init__", "scene"}
            assert {path.parent for path in folder.glob("*/scene.py")} == {*motions}


#: What stands for the derived files where only the handling of files is tested.
FILES = {
    "__init__.py": "# a\n",
    "hb.py": "x = 1\n",
    "c1.py": "y = 2\n",
    "scene/ck.py": "z = 3\n",
}


@pytest.fixture
def few_files(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(generate, "sources", lambda: dict(FILES))


@pytest.mark.usefixtures("few_files")
def test_a_second_run_changes_nothing(tmp_path: Path) -> None:
    generate.write(tmp_path)
    before = {path: path.stat().st_mtime_ns for path in tmp_path.rglob("*.py")}
    assert len(before) == len(FILES)
    assert generate.write(tmp_path) == []
    assert {path: path.stat().st_mtime_ns for path in tmp_path.rglob("*.py")} == before


@pytest.mark.usefixtures("few_files")
def test_text_and_set_of_files_are_compared_without_writing(tmp_path: Path) -> None:
    generate.write(tmp_path)
    (tmp_path / "scene" / "extra.py").write_text("old = True\n")
    (tmp_path / "c1.py").unlink()
    (tmp_path / "hb.py").write_text("x = -1\n")
    expected = ["c1.py: missing", "hb.py: differs", "scene/extra.py: not generated"]
    assert generate.differences(tmp_path) == expected
    assert not (tmp_path / "c1.py").exists()
    assert (tmp_path / "hb.py").read_text() == "x = -1\n"
    changed = ["hb.py: written", "c1.py: written", "scene/extra.py: removed"]
    assert generate.write(tmp_path) == changed
    assert generate.differences(tmp_path) == []
    assert (tmp_path / "scene" / "ck.py").read_text() == FILES["scene/ck.py"]


@pytest.mark.parametrize("method", METHODS)
def test_header_says_what_the_file_is_and_hashes_it(method: str) -> None:
    system = derive(method)
    text = emit.module_source(system)
    assert text.startswith(f'"""Section {system.section}: {system.title}')
    assert "nonsmooth generate" in text
    module = kernels.module(method)
    assert emit.mathematics(system) == module.MATHEMATICS
    body = text[text.index("\n\n\n", text.index("BODY")) + 3 :]
    assert emit.digest(body) == module.BODY


@pytest.mark.parametrize("method", METHODS)
def test_every_closed_form_is_used(method: str) -> None:
    system = derive(method)
    for form in system.forms:
        assert emit.LOOPS[method].count(f"{form.name}(") >= 1, form.name


def test_powers_and_fractions_are_printed_to_keep_digits() -> None:
    x, y = sp.symbols("x y")
    form = ClosedForm("f", "f.", (x, y), (x**3 / 6 - y / (2 * x**2), -x * (y + 1) / 3))
    source = emit.function_source(form)
    assert "(x*x*x)/6 - y/(2*(x*x))" in source
    namespace: dict[str, object] = {}
    exec(source, namespace)
    assert namespace["f"](2.0, 5.0) == (8 / 6 - 5 / 8, -4.0)  # type: ignore[operator]


def changed(system: GalerkinSystem) -> GalerkinSystem:
    """Return the system with one wrong sign in the mathematics."""
    forms = tuple(
        dataclasses.replace(form, values=tuple(-v for v in form.values))
        if form.name == "initial_state"
        else form
        for form in system.forms
    )
    return dataclasses.replace(system, forms=forms)


def with_one_more(system: GalerkinSystem) -> Iterator[tuple[str, GalerkinSystem]]:
    """Yield the system with one value of a closed form changed, a value at a time."""
    for place, form in enumerate(system.forms):
        for i in range(len(form.values)):
            values = [value + int(k == i) for k, value in enumerate(form.values)]
            other = dataclasses.replace(form, values=tuple(values))
            forms = (*system.forms[:place], other, *system.forms[place + 1 :])
            yield f"{form.name}, value {i}", dataclasses.replace(system, forms=forms)


@pytest.mark.parametrize("method", [*derived.METHODS, *derived.SOLVED])
def test_every_value_of_every_closed_form_counts_in_the_hash(
    method: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    # Each form is spelt out once, and its source is that of the tests beside this one.
    spelt = cache(sp.srepr)
    monkeypatch.setattr(emit.sp, "srepr", spelt)
    monkeypatch.setattr(emit, "function_source", lambda form: form.name)
    hashes = {emit.mathematics(derive(method)): "nothing"}
    for what, other in with_one_more(derive(method)):
        found = emit.mathematics(other)
        assert found not in hashes, f"{what} counts as little as {hashes[found]}"
        hashes[found] = what
        assert f'\nMATHEMATICS = "{found}"' in emit.module_source(other)


@pytest.mark.parametrize("change", ["name", "arguments"])
def test_name_and_arguments_of_a_closed_form_count_in_the_hash(change: str) -> None:
    system = derive("hb")
    form = system.forms[0]
    other = {"name": f"{form.name}_2", "arguments": (*form.arguments[::-1], sp.Symbol("q"))}
    changed = dataclasses.replace(form, **{change: other[change]})
    forms = (changed, *system.forms[1:])
    assert emit.mathematics(dataclasses.replace(system, forms=forms)) != emit.mathematics(
        system
    )


def imported(path: Path) -> types.ModuleType:
    """Return a file of generated text as a module of its own, as a new process has it."""
    spec = importlib.util.spec_from_file_location("regenerated", path)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_a_cached_kernel_never_survives_a_regeneration(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A file with other mathematics, but the same size and time, is compiled anew.

    What is called changes, and its caller is found in the cache or not.
    """
    path = tmp_path / "regenerated.py"
    monkeypatch.setattr(sys, "dont_write_bytecode", True)
    monkeypatch.setattr(numba.config, "CACHE_DIR", str(tmp_path / "cache"))

    def start() -> tuple[tuple[float, float], int]:
        function = kernels.compile_functions(imported(path))["initial_residual"]
        found = function(1.0, 1, np.array([0.7, 0.2, -0.9]), 6.0)
        return found, sum(function.stats.cache_hits.values())

    right, wrong = (emit.module_source(s) for s in (derive("hb"), changed(derive("hb"))))
    size = max(len(right), len(wrong))
    path.write_text(right.ljust(size))
    os.utime(path, ns=(10**18, 10**18))
    first, hits = start()
    assert hits == 0
    again, hits = start()
    assert (again, hits) == (first, 1)
    path.write_text(wrong.ljust(size))
    os.utime(path, ns=(10**18, 10**18))
    after, hits = start()
    assert hits == 0
    assert after != first


def test_kernels_compile_where_no_cache_can_be_written(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def refuse(*arguments, **options):
        if options.get("cache"):
            raise RuntimeError("cannot cache function: no locator available")
        return njit(*arguments, **options)

    njit = numba.njit
    monkeypatch.setattr(numba, "njit", refuse)
    path = tmp_path / "c1.py"
    path.write_text(emit.module_source(derive("c1")))
    module = imported(path)
    monkeypatch.setattr(compiling, "_SAID", [])
    with pytest.warns(compiling.CacheWarning, match=str(tmp_path)):
        namespace = kernels.compile_functions(module)
    assert_array_equal(namespace["twice_integrated"](3), module.twice_integrated(3))
