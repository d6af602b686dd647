"""Where results go: stdout, and files and folders that are written whole or not at all.

Where a file or a folder cannot be is said before the work; nothing of the user's is replaced
but files that are named, and folders that we made.
"""

import os
import shutil
import sys
import tempfile
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence, Set
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Any, cast

import click

from nonsmooth.extras import require
from nonsmooth.whole import whole

from .problems import Problem

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from .columns import Piece

#: What data can be written as.
DATA = (".json", ".csv", ".nc")

PICTURES = (".png", ".svg", ".pdf")

#: The libraries of a report, as `require` takes them.
FOR_REPORTS = (("matplotlib", "report", "report"), ("jinja2", "report", "report"))

#: Returns the document of a result; called once it is wanted.
Text = Callable[[], str]

#: The page of a folder, and what a page that we made has in it.
PAGE, MARK = "index.html", 'name="generator" content="nonsmooth '


def check_target(path: Path | None, suffixes: tuple[str, ...]) -> None:
    """Check that `path` has one of the suffixes and that its folder takes a file.

    Without suffixes it may have any, and is not a picture.  A `Problem` names the path and what
    was expected.
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
    check_folder_of(Path(os.path.realpath(path)) if path.is_symlink() else path)
    if suffixes and path.suffix.lower() in PICTURES:
        require("matplotlib", "plot", "-o: a picture")
    if path.suffix.lower() == ".nc":
        require("netCDF4", "netcdf", "-o: netCDF")
        require("xarray", "netcdf", "-o: netCDF")


def check_folder_of(path: Path) -> None:
    """Check that the folder of a path is there and takes another file.

    A `Problem` is raised if it does not.
    """
    folder = path.parent
    if not folder.is_dir():
        raise Problem(f"-o: the folder {folder} does not exist")
    try:
        tempfile.NamedTemporaryFile(dir=folder).close()
    except OSError as error:
        raise Problem(f"-o: cannot write to {folder}: {error.strerror}") from error


@contextmanager
def telling(path: Path) -> Iterator[None]:
    """Report that a file or folder is written; a `Problem` if it cannot be."""
    try:
        yield
    except OSError as error:
        raise Problem(f"-o: cannot write {path}: {error.strerror}") from error
    click.echo(f"wrote {path}", err=True)


def discard_stdout() -> None:
    """Let nothing more be printed on stdout: its reader has left."""
    with suppress(OSError):
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def write_whole(path: Path, write: Callable[[Path], object]) -> None:
    """Let `write` make a temporary file beside `path`, then put it in its place.

    A `Problem` is raised if the file cannot be written; then nothing is left of it.
    """
    with telling(path), whole(path) as temporary:
        write(temporary)


def write_text(path: Path, text: str) -> None:
    """Write a text file whole or not at all."""
    write_whole(path, lambda target: target.write_text(text, "utf-8"))


def drawn_by(name: str, *arguments: object) -> "Callable[[], Figure]":
    """Return what draws by a function of `nonsmooth.plots`, which is loaded when it draws.

    It is named with its module: ``sweeps.convergence_figure``.
    """

    def draw() -> "Figure":
        module, _, function = name.partition(".")
        figure = getattr(import_module(f"nonsmooth.plots.{module}"), function)(*arguments)
        return cast("Figure", figure)

    return draw


@dataclass(frozen=True)
class Destination:
    """Where the result of a command goes: as JSON or for a reader to stdout, and to a file.

    The suffix of the file is one that `check_target` let pass.
    """

    json: bool
    file: Path | None

    def show(self, text: Text, pieces: "Iterable[Piece]") -> None:
        """Print the document of a result or, not for ``--json``, its tables and texts.

        If the reader of stdout has left, the file is written all the same.
        """
        try:
            if self.json:
                click.echo(text(), nl=False)
            else:
                from .columns import print_pieces

                print_pieces(pieces)
        except BrokenPipeError:
            if self.file is None:
                raise
            discard_stdout()

    def write(
        self, text: Text, figure: "Callable[[], Figure]", data: Any = None,
        rows: "Callable[[], Sequence[Mapping[str, Any]]] | None" = None,
    ) -> None:  # fmt: skip
        """Write a result, if a file is named: its document, its data, else a picture of it.

        `nonsmooth.save` writes the data as .csv and .nc; of a result that it does not take,
        `rows` returns those of the .csv.
        """
        if self.file is None:
            return
        suffix = self.file.suffix.lower()
        if suffix == ".json":
            write_text(self.file, text())
        elif suffix not in DATA:
            from nonsmooth.plots.axes import write

            write_whole(self.file, lambda target: write(figure, target))
        elif rows is not None and suffix == ".csv":
            from nonsmooth.files import csv_rows

            table = rows()
            write_whole(self.file, lambda target: csv_rows.write(target, table))
        else:
            from nonsmooth.files.api import save

            with telling(self.file):
                save(data, self.file)


def check_folder(path: Path, files: Set[str]) -> None:
    """Check that a folder of these files can be put at `path`.

    It may be new, empty, or an earlier result: a page that we made, and no other files.  A
    `Problem` names the path and what was expected.
    """
    path = Path(os.path.abspath(path))
    names = set()
    if path.exists():
        if not path.is_dir() or path.is_symlink():
            raise Problem(f"-o: {path} is there, expected a folder or a new name")
        names = {entry.name for entry in path.iterdir()}
    check_folder_of(path)
    foreign = sorted(names - files)
    page = path / PAGE
    ours = page.is_file() and MARK in page.read_text("utf-8", errors="replace")
    if foreign or (names and not ours):
        problem = f"has {foreign[0]} in it" if foreign else "has a page that is not ours"
        raise Problem(
            f"-o: {path} {problem}; expected a new or empty folder, or one that report made"
        )


def write_folder(path: Path, write: Callable[[Path], None]) -> None:
    """Let `write` fill a temporary folder beside `path`, then put it in its place.

    A `Problem` is raised if it cannot be written; then what was there before is still there.
    """
    path = Path(os.path.abspath(path))
    temporary = Path(tempfile.mkdtemp(dir=path.parent, prefix=f".{path.name}-"))
    try:
        with telling(path):
            fresh = temporary / "made"
            fresh.mkdir(mode=0o777)
            write(fresh)
            if path.exists():
                os.replace(path, temporary / "before")
            os.replace(fresh, path)
    finally:
        if (temporary / "before").exists() and not path.exists():
            os.replace(temporary / "before", path)
        shutil.rmtree(temporary, ignore_errors=True)
