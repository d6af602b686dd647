"""Files are written whole or not at all; where they cannot be is said before the work."""

import json
import math
import os
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import click

from .problems import Problem

#: Version of the JSON documents.
SCHEMA = 1

PICTURES = (".png", ".svg", ".pdf")


def check_target(path: Path | None, suffixes: tuple[str, ...]) -> None:
    """Check that `path` has one of the suffixes and that its folder takes a file.

    Raises
    ------
    Problem
        Naming the path and what was expected.
    """
    if path is None:
        return
    if suffixes and path.suffix.lower() not in suffixes:
        expected = ", ".join(suffixes)
        raise Problem(f"-o: got {path}, expected a name that ends in one of {expected}")
    if path.is_dir():
        raise Problem(f"-o: {path} is a folder, expected a file")
    if not path.parent.is_dir():
        raise Problem(f"-o: the folder {path.parent} does not exist")
    try:
        handle, probe = tempfile.mkstemp(dir=path.parent)
    except OSError as error:
        raise Problem(f"-o: cannot write to {path.parent}: {error.strerror}") from error
    os.close(handle)
    os.unlink(probe)
    if path.suffix.lower() in PICTURES:
        need_matplotlib()


def need_matplotlib() -> None:
    """Check that pictures can be drawn.

    Raises
    ------
    Problem
        Saying how to install what is missing.
    """
    from importlib.util import find_spec  # noqa: PLC0415

    if find_spec("matplotlib") is None:
        raise Problem("-o: a picture needs matplotlib: pip install 'nonsmooth[plot]'")


def write_whole(path: Path, write: Callable[[Path], None]) -> None:
    """Let `write` make a temporary file beside `path`, then put it in its place.

    Raises
    ------
    Problem
        If the file cannot be written; then nothing is left of it.
    """
    handle, name = tempfile.mkstemp(dir=path.parent, suffix=path.suffix)
    os.close(handle)
    temporary = Path(name)
    try:
        write(temporary)
        os.chmod(temporary, 0o666 & ~_umask())
        os.replace(temporary, path)
    except OSError as error:
        raise Problem(f"-o: cannot write {path}: {error.strerror}") from error
    finally:
        temporary.unlink(missing_ok=True)
    click.echo(f"wrote {path}", err=True)


def _umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask


def write_text(path: Path, text: str) -> None:
    """Write a text file whole or not at all."""

    def write(target: Path) -> None:
        target.write_text(text, "utf-8")

    write_whole(path, write)


def as_json(document: dict[str, Any]) -> str:
    """Return a JSON document with its schema version; what is not finite is null."""
    whole = {"schema": SCHEMA} | document
    return json.dumps(_finite(whole), indent=2, allow_nan=False)


def _finite(value: Any) -> Any:
    """Return `value` with null for numbers that JSON has no word for."""
    if isinstance(value, dict):
        return {key: _finite(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [_finite(item) for item in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value
