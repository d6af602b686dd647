"""Who imports whom: no cycles."""

import ast
import graphlib
from collections.abc import Iterator, Mapping
from functools import cache
from pathlib import Path

from shown import ROOT

#: The folders of the package, and what they are called where it is imported.
TOPS = {"codegen": "codegen", "solver": "solver", "src/nonsmooth": ""}


@cache
def modules() -> dict[str, Path]:
    """Return the modules of the package by their dotted names within it."""
    found = {}
    for top, name in TOPS.items():
        for path in sorted((ROOT / top).rglob("*.py")):
            parts = path.relative_to(ROOT / top).with_suffix("").parts
            kept = parts[:-1] if parts[-1] == "__init__" else parts
            found[".".join(filter(None, [name, *kept]))] = path
    return found


@cache
def imports() -> Mapping[str, frozenset[str]]:
    """Return what each module imports of the package, within functions too; no types."""
    known = modules()
    return {
        name: frozenset(_imported(name, path, known)) - {name, ""}
        for name, path in known.items()
    }


def _imported(name: str, path: Path, known: Mapping[str, Path]) -> Iterator[str]:
    package = name if path.name == "__init__.py" else name.rpartition(".")[0]
    for node in _statements(ast.parse(path.read_text("utf-8"))):
        if isinstance(node, ast.Import):
            yield from (q.name for q in node.names if q.name in known)
            continue
        base = node.module or ""
        if node.level:
            parts = package.split(".")
            above = parts[: len(parts) - node.level + 1] if package else []
            base = ".".join([*above, *filter(None, [node.module])])
        base = base.removeprefix("nonsmooth.")
        for q in node.names:
            whole = f"{base}.{q.name}"
            if whole in known:
                yield whole
            elif base in known:
                yield base


def _statements(tree: ast.AST) -> Iterator[ast.Import | ast.ImportFrom]:
    for node in ast.iter_child_nodes(tree):
        if isinstance(node, ast.Import | ast.ImportFrom):
            yield node
        elif isinstance(node, ast.If) and "TYPE_CHECKING" in ast.unparse(node.test):
            continue
        else:
            yield from _statements(node)


def cycle(edges: Mapping[str, frozenset[str]]) -> list[str]:
    """Return the modules of a cycle; empty if there is none."""
    try:
        graphlib.TopologicalSorter(edges).prepare()
    except graphlib.CycleError as error:
        return list(error.args[1])
    return []


def room(name: str) -> str:
    """Return the room of a module: the part of a stage, or a folder of the package."""
    stage, _, rest = name.partition(".")
    return f"{stage}.{rest.partition('.')[0]}" if stage in TOPS.values() and rest else stage


def test_no_file_imports_one_that_imports_it() -> None:
    assert cycle(imports()) == []


def test_no_room_imports_one_that_imports_it() -> None:
    edges: dict[str, frozenset[str]] = {}
    for name, found in imports().items():
        others = {room(q) for q in found} - {room(name)}
        edges[room(name)] = edges.get(room(name), frozenset()) | others
    assert cycle(edges) == []
    assert {"solver.orbit", "codegen.galerkin", "plots"} <= edges.keys()


def test_a_cycle_is_seen() -> None:
    one, two, three = frozenset({"one"}), frozenset({"two"}), frozenset({"three"})
    assert set(cycle({"one": two, "two": three, "three": one})) == {"one", "two", "three"}
    assert cycle({"one": two, "two": three}) == []
    tree = ast.parse(
        "import a\nif TYPE_CHECKING:\n    import b\ndef f():\n    import c\n"
        "class D:\n    def g(self):\n        from .e import h\n"
    )
    assert len(list(_statements(tree))) == 3
