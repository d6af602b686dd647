"""Files are written whole or not at all; where they cannot be is said before the work."""

import os
import tempfile
from collections.abc import Callable
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING

import click

from nonsmooth.files.whole import whole

from .problems import Problem

#: What data can be written as.
DATA = (".json", ".csv", ".nc")

PICTURES = (".png", ".svg", ".pdf")

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from nonsmooth.files.api import Savable


def check_target(path: Path | None, suffixes: tuple[str, ...]) -> None:
    """Check that `path` has one of the suffixes and that its folder takes a file.

    Without suffixes it may have any, and is not a picture.

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
    if path.exists() and not path.is_file():
        raise Problem(f"-o: {path} is a device or a pipe, expected a file")
    folder = Path(os.path.realpath(path)).parent if path.is_symlink() else path.parent
    if not folder.is_dir():
        raise Problem(f"-o: the folder {folder} does not exist")
    try:
        handle, probe = tempfile.mkstemp(dir=folder)
    except OSError as error:
        raise Problem(f"-o: cannot write to {folder}: {error.strerror}") from error
    os.close(handle)
    os.unlink(probe)
    if suffixes and path.suffix.lower() in PICTURES:
        need_matplotlib()
    if path.suffix.lower() == ".nc":
        need("netCDF4", "-o: netCDF", "netcdf")
        need("xarray", "-o: netCDF", "netcdf")


def need_matplotlib() -> None:
    """Check that pictures can be drawn.

    Raises
    ------
    Problem
        Saying how to install what is missing.
    """
    need("matplotlib", "-o: a picture", "plot")


def need(library: str, what: str, extra: str) -> None:
    """Check that a library of an extra is installed.

    Raises
    ------
    Problem
        Saying what needs it, and how to install it.
    """
    if find_spec(library) is None:
        raise Problem(f"{what} needs {library}: pip install 'nonsmooth[{extra}]'")


def write_whole(path: Path, write: Callable[[Path], None]) -> None:
    """Let `write` make a temporary file beside `path`, then put it in its place.

    Raises
    ------
    Problem
        If the file cannot be written; then nothing is left of it.
    """
    try:
        with whole(path) as temporary:
            write(temporary)
    except OSError as error:
        raise Problem(f"-o: cannot write {path}: {error.strerror}") from error
    click.echo(f"wrote {path}", err=True)


def write_file(path: Path, thing: "Savable") -> None:
    """Write orbits, a sweep or families as .json, .csv or .nc."""
    from nonsmooth.files.api import save

    try:
        save(thing, path)
    except OSError as error:
        raise Problem(f"-o: cannot write {path}: {error.strerror}") from error
    click.echo(f"wrote {path}", err=True)


def write_picture(path: Path, figure: "Callable[[], Figure]") -> None:
    """Write what a function draws as .png, .svg or .pdf."""
    from nonsmooth.plots.axes import write

    write_whole(path, lambda target: write(figure, target))


def write_text(path: Path, text: str) -> None:
    """Write a text file whole or not at all."""

    def write(target: Path) -> None:
        target.write_text(text, "utf-8")

    write_whole(path, write)


def write_bytes(path: Path, content: bytes) -> None:
    """Write a binary file whole or not at all."""

    def write(target: Path) -> None:
        target.write_bytes(content)

    write_whole(path, write)
