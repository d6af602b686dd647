"""Orbits, sweeps and families as files that others read, and that read back the same.

JSON holds everything, with a digest; netCDF (extra ``netcdf``) as well, for tools that work
on arrays; CSV holds the rows of a sweep, a family or modes, and the motion of an orbit.
Numbers are in SI units, and every file says with which version and which mathematics it was
made.  Modes are written alike, and computed anew, not loaded.
"""

import os
import reprlib
from collections.abc import Mapping, Sequence
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from nonsmooth.solver.results.branch import Branch
from nonsmooth.solver.results.chart import Chart
from nonsmooth.solver.results.family import Family
from nonsmooth.solver.results.orbit import Orbit
from nonsmooth.solver.results.sweep import Sweep

from ..whole import whole
from . import csv_rows, documents
from .file_errors import FileError, other_kind, refused
from .json_text import check_digest, parsed, sealed
from .restore_orbits import result_in

#: The endings of names.
SUFFIXES = (".json", ".csv", ".nc")


def save(thing: Any, path: str | Path) -> None:
    """Write a file, whole or not at all.

    Parameters
    ----------
    thing : orbit, sweep, family or modes, or a sequence of orbits or of modes
        What to save.
    path : str or Path
        Ends in ``.json``, ``.csv`` or ``.nc`` (netCDF-4).  A CSV is for other programs: that
        of orbits has their motion over one period.  `load` reads neither a CSV nor modes.

    Raises
    ------
    FileError
        A `ValueError`: if the name ends otherwise, or a library for netCDF is not installed.
    TypeError
        If `thing` cannot be saved, or is a sequence that is empty or of several kinds, or
        `path` is not the name of a file.
    OSError
        If the file cannot be written; no part of it is left behind.

    Examples
    --------
    >>> import tempfile, nonsmooth as ns
    >>> orbit = ns.solve(ns.scene("impact")(gap=0.2), order=8)
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     ns.save(orbit, f"{folder}/orbit.json")
    ...     ns.load(f"{folder}/orbit.json") == orbit
    True
    """
    target = _named(path)
    suffix = _suffix(target)
    kind, several = kind_of(thing)
    with whole(target) as temporary:
        if suffix == ".csv":
            csv_rows.write(temporary, csv_rows.ROWS[kind](several))
        elif suffix == ".json":
            text = sealed(documents.document_of(kind, several))
            temporary.write_text(text, "utf-8", newline="")
        else:
            from . import netcdf  # noqa: PLC0415  (an extra)

            netcdf.write(kind, several, temporary)


def load(path: str | Path, scene: object = None) -> Any:
    """Read a file that `save` or the command line wrote.

    A file that was changed since is loaded with a `FileWarning` if its content is still
    consistent: other spaces, another order of keys or a note in it do no harm.

    Parameters
    ----------
    path : str or Path
        A ``.json`` or ``.nc`` file.
    scene : str, Path or Scene, optional
        The scene of the file, as `nonsmooth.scene` takes it, if it is not shipped.

    Returns
    -------
    orbit, sweep or family, or a list of orbits
        Bit for bit what was saved.

    Raises
    ------
    FileError
        A `ValueError`: if the file is damaged (a period that is not positive, too many or too
        few numbers, an orbit that does not satisfy its equations), is from a newer version, of
        another kind or scene, or was computed with other equations.
    SceneFileError
        A `ValueError`: if `scene` is a file that does not define a scene.
    TypeError
        If `path` is not the name of a file.
    OSError
        If the file cannot be read.
    """
    source = _named(path)
    suffix = _suffix(source)
    with source.open("rb"):  # a missing file is an OSError for every kind
        pass
    if suffix == ".csv":
        raise FileError(source, "CSV is for other programs; save as .json to load it")
    if suffix == ".json":
        return _restored(source, parsed(source, source.read_bytes()), scene)
    from . import netcdf  # noqa: PLC0415  (an extra)

    file = netcdf.read(source)
    loaded = _restored(source, parsed(source, str(file[netcdf.DOCUMENT].values)), scene)
    with refused(source):
        netcdf.check_same(file, netcdf.arrays_of(*kind_of(loaded)))
    return loaded


def _named(path: object) -> Path:
    """Return the path of a file; a `TypeError` if it is no name of one."""
    if not isinstance(path, str | os.PathLike):
        raise TypeError(f"path: got {path!r:.80}, expected the name of a file")
    return Path(path)


def _suffix(path: Path) -> str:
    suffix = path.suffix.lower()
    if suffix not in SUFFIXES:
        raise FileError(path, f"expected a name that ends in one of {', '.join(SUFFIXES)}")
    if suffix == ".nc" and not (find_spec("netCDF4") and find_spec("xarray")):
        needs = "netCDF needs netCDF4 and xarray"
        raise FileError(path, f"{needs}: pip install 'nonsmooth[netcdf]'")
    return suffix


def _restored(path: Path, document: Mapping[str, Any], scene: object) -> Any:
    """Return the result that a document holds."""
    check_digest(path, document)
    with refused(path):
        if "structure" in document:
            raise FileError(
                path, "holds modes or shapes: they are not loaded, compute them anew"
            )
        if "scene" in document:
            return result_in(path, document, scene)
        raise other_kind(path)


def kind_of(thing: Any) -> tuple[str, Sequence[Any]]:
    """Return the kind of what is to be saved, and its results: one, or several.

    A `TypeError` is raised if it is not a result, or not one that is saved.

    Returns
    -------
    {"orbits", "sweep", "family", "branch", "map", "modes", "shapes"}, sequence
    """
    from nonsmooth.solver.space.mode import Shapes  # noqa: PLC0415
    from nonsmooth.solver.space.modes import Modes  # noqa: PLC0415  (SciPy)

    alone = {Sweep: "sweep", Chart: "map", Branch: "branch", Family: "family", Shapes: "shapes"}
    for cls, kind in alone.items():
        if isinstance(thing, cls):
            return kind, [thing]
    several: Any = [thing] if isinstance(thing, Orbit | Modes) else thing
    if _all_are(several, Orbit):
        return "orbits", several
    if _all_are(several, Modes) and len({item.structure for item in several}) == 1:
        return "modes", several
    kinds = (
        "an orbit, a branch, a family, a map, modes, their shapes, a sweep, or a sequence of "
        "orbits or modes"
    )
    raise TypeError(f"thing: got {reprlib.repr(thing)}, expected {kinds}")


def _all_are(things: Any, kind: type) -> bool:
    """Whether `things` is a nonempty sequence of results of one kind."""
    several = isinstance(things, Sequence) and not isinstance(things, str) and len(things) > 0
    return several and all(isinstance(thing, kind) for thing in things)
