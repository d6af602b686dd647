"""Hashes of the inputs of kernels: a scene, and the program that derives its equations."""

import ast
import hashlib
from collections.abc import Iterable, Mapping
from dataclasses import fields, is_dataclass
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from nonsmooth.codegen.scene import Scene

#: Folders of the symbolic stage that kernels of users' scenes do not depend on.
OTHERS = {"scenes", "equations", "printing", "__pycache__"}

#: Modules that a scene file may import and be known by its text: they read no other file.
CLOSED = {
    "__future__", "collections", "dataclasses", "fractions", "functools", "itertools", "math",
    "numbers", "operator", "sympy", "typing",
}  # fmt: skip

#: Names by which a text reaches what is not in it.
OUTSIDE = {
    "__builtins__", "__file__", "__import__", "compile", "eval", "exec", "globals", "input",
    "open", "vars",
}  # fmt: skip


def stands_alone(text: bytes) -> bool:
    """Whether the text of a scene file alone determines its scene: it reads no other file.

    Examples
    --------
    >>> stands_alone(b"import sympy as sp"), stands_alone(b"import numpy as np")
    (True, False)
    """
    try:
        nodes = list(ast.walk(ast.parse(text)))
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return False
    return not any(map(_reaches_out, nodes))


def _reaches_out(node: ast.AST) -> bool:
    """Whether a part of a program imports another module, or names what reads files."""
    if isinstance(node, ast.Import):
        return any(each.name.split(".")[0] not in CLOSED for each in node.names)
    if isinstance(node, ast.ImportFrom):
        module = node.module or ""
        is_known = module == "nonsmooth.scene" or module.split(".")[0] in CLOSED
        return node.level > 0 or not is_known
    return isinstance(node, ast.Name) and node.id in OUTSIDE


def key_of_text(text: bytes) -> str:
    """Return the cache key of a scene file, from its text."""
    return _key(b"text", text)


def key_of_scene(scene: "Scene") -> str:
    """Return the cache key of a scene object, from its whole content."""
    return _key(b"scene", _content(scene).encode())


def _key(*parts: bytes) -> str:
    digest = hashlib.sha256(_generator())
    for part in parts:
        digest.update(len(part).to_bytes(8, "big") + part)
    return digest.hexdigest()[:24]


def _content(value: Any) -> str:
    """Return a text that determines a scene, or a part of it, completely."""
    if hasattr(value, "arrays"):  # a body: its matrices by their hashes
        hashes = {name: matrix.digest for name, matrix in value.arrays.items()}
        value = [hashes, [*value.at], value.ratio, value.modes]
    if is_dataclass(value):
        parts = (
            f"{field.name}={_content(getattr(value, field.name))}" for field in fields(value)
        )
        return f"{type(value).__name__}({', '.join(parts)})"
    if isinstance(value, Mapping):
        return f"{{{', '.join(f'{_content(k)}: {_content(v)}' for k, v in value.items())}}}"
    if isinstance(value, tuple | list):
        return f"({', '.join(map(_content, value))})"
    if isinstance(value, str | bool | int | float | None):
        return repr(value)
    from sympy import srepr  # noqa: PLC0415  (needed by every scene, so it is loaded)

    return str(srepr(value))


@cache
def _generator() -> bytes:
    """Return a hash of the source of the symbolic stage."""
    folder = (Path(__file__).resolve().parent.parent / "codegen").resolve()
    digest = hashlib.sha256()
    for path in _modules(folder):
        digest.update(path.relative_to(folder).as_posix().encode() + b"\0" + path.read_bytes())
    return digest.digest()


def _modules(folder: Path) -> Iterable[Path]:
    paths = folder.rglob("*.py")
    return sorted(path for path in paths if not OTHERS & {*path.relative_to(folder).parts})
