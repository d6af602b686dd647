"""Who imports whom: no cycles."""

import ast
import graphlib
from collections.abc import Iterator, Mapping
from functools import cache
from pathlib import Path

import pytest
from shown import ROOT

#: Cycles that are closed by an import within a function, with the reason for it.
ALLOWED: Mapping[tuple[str, str], str] = {
    ("codegen.scene.data", "codegen.scene.check"): "a scene is checked when it is made",
    ("solver.orbit.orbit", "solver.accuracy.estimate"): "an estimate computes better orbits, "
    "and is found on the orbit that it is of",
    ("solver.case.case", "solver.case.registry"): "a case that is unpickled finds its scene",
    ("solver.case.numbers", "solver.case.registry"): "a scene finds the folders of its motions",
}


@cache
def modules(top: str) -> dict[str, Path]:
    """Return the modules of a folder by their dotted names."""
    found = {}
    for path in sorted((ROOT / top).rglob("*.py")):
        parts = path.relative_to(ROOT).with_suffix("").parts
        found[".".join(parts[:-1] if parts[-1] == "__init__" else parts)] = path
    return found


@cache
def imports(top: str, *, within_functions: bool) -> Mapping[str, frozenset[str]]:
    """Return what each module of a folder imports from the same folder.

    Parameters
    ----------
    top : str
        The folder.
    within_functions : bool
        Whether imports within functions count; those for types alone never do.
    """
    known = modules(top)
    return {
        name: frozenset(_imported(name, path, known, within_functions)) - {name}
        for name, path in known.items()
    }


def _imported(
    name: str, path: Path, known: Mapping[str, Path], within_functions: bool
) -> Iterator[str]:
    package = name if path.name == "__init__.py" else name.rpartition(".")[0]
    for node in _statements(ast.parse(path.read_text("utf-8")), within_functions):
        if isinstance(node, ast.Import):
            yield from (q.name for q in node.names if q.name in known)
            continue
        base = node.module or ""
        if node.level:
            parts = package.split(".")
            above = parts[: len(parts) - node.level + 1]
            base = ".".join([*above, *filter(None, [node.module])])
        base = base.removeprefix("nonsmooth.")
        for q in node.names:
            whole = f"{base}.{q.name}"
            if whole in known:
                yield whole
            elif base in known:
                yield base


def _statements(tree: ast.AST, within_functions: bool) -> Iterator[ast.Import | ast.ImportFrom]:
    for node in ast.iter_child_nodes(tree):
        if isinstance(node, ast.Import | ast.ImportFrom):
            yield node
        elif isinstance(node, ast.If) and "TYPE_CHECKING" in ast.unparse(node.test):
            continue
        elif within_functions or not isinstance(node, ast.FunctionDef):
            yield from _statements(node, within_functions)


def cycle(edges: Mapping[str, frozenset[str]]) -> list[str]:
    """Return the modules of a cycle; empty if there is none."""
    try:
        graphlib.TopologicalSorter(edges).prepare()
    except graphlib.CycleError as error:
        return list(error.args[1])
    return []


@pytest.mark.parametrize("top", ["codegen", "solver"])
def test_no_cycle_is_closed_when_modules_are_imported(top: str) -> None:
    assert cycle(imports(top, within_functions=False)) == []


@pytest.mark.parametrize("top", ["codegen", "solver"])
def test_the_only_cycles_within_functions_are_those_with_a_reason(top: str) -> None:
    edges = {
        name: frozenset(q for q in found if (name, q) not in ALLOWED)
        for name, found in imports(top, within_functions=True).items()
    }
    assert cycle(edges) == []
    for name, found in ALLOWED:
        if name.startswith(top):
            closed = {**edges, name: edges[name] | {found}}
            assert cycle(closed), f"{name} may import {found}: no reason is needed"


def test_a_cycle_is_seen() -> None:
    one, two, three = frozenset({"one"}), frozenset({"two"}), frozenset({"three"})
    assert set(cycle({"one": two, "two": three, "three": one})) == {"one", "two", "three"}
    assert cycle({"one": two, "two": three}) == []
    tree = ast.parse(
        "import a\nif TYPE_CHECKING:\n    import b\ndef f():\n    import c\n"
        "class D:\n    def g(self):\n        from .e import h\n"
    )
    assert len(list(_statements(tree, within_functions=True))) == 3
    assert len(list(_statements(tree, within_functions=False))) == 1
