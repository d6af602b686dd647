"""Orbits, sweeps, families and modes as files that others read, and that read back the same.

JSON holds everything, with a digest; netCDF (extra ``netcdf``) as well, for tools that work
on arrays; CSV holds the rows of a sweep, a family or modes, and the motion of an orbit.
Numbers are in SI units, and every file says with which version and which mathematics it was
made.
"""

import json
import reprlib
from collections.abc import Mapping
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeAlias

from ..scene_files.error import SceneFileError
from .errors import FileError, damaged, other_kind
from .json_text import check_digest, sealed
from .kinds import Content
from .scenes.content import content_of
from .scenes.restored import restored
from .schema import check_schema
from .whole import whole

if TYPE_CHECKING:
    from netCDF4 import Dataset

#: An orbit, a sweep or a family of any oscillator, modes; or several orbits, families, modes.
Savable: TypeAlias = Any
Loaded: TypeAlias = Any

#: The endings of names.
SUFFIXES = (".json", ".csv", ".nc")


def save(thing: Savable, path: str | Path) -> None:
    """Write a file, whole or not at all.

    Parameters
    ----------
    thing : orbit, sweep, family or modes, or a sequence of orbits, of families or of modes
        What to save, of a case of any scene, or of one structure.
    path : str or Path
        Ends in ``.json``, ``.csv`` or ``.nc`` (netCDF-4).  A CSV is for other programs, and
        is not loaded: that of orbits has their motion over one period.

    Raises
    ------
    FileError
        A `ValueError`: if the name ends otherwise, or netCDF4 is not installed.
    TypeError
        If `thing` is none of these, or a sequence that is empty or of several kinds.
    OSError
        If the file cannot be written; then nothing is left of it.

    Examples
    --------
    >>> import tempfile, nonsmooth as ns
    >>> orbit = ns.solve(ns.scene("impact")(gap=0.2), order=8)
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     ns.save(orbit, f"{folder}/orbit.json")
    ...     ns.load(f"{folder}/orbit.json") == orbit
    True
    """
    target = Path(path)
    suffix = _suffix(target)
    content = _content(thing)
    with whole(target) as temporary:
        if suffix == ".csv":
            content.write_csv(temporary)
            return
        if suffix == ".json":
            temporary.write_text(sealed(content.document()), "utf-8", newline="")
        else:
            from . import netcdf  # noqa: PLC0415  (an extra)

            netcdf.write(content.title, content.document(), content.tables(), temporary)


def load(path: str | Path, scene: object = None) -> Loaded:
    """Read a file that `save` or the command line wrote.

    A file that was changed since is loaded with a `FileWarning`, if what it holds can be
    right: other spaces, another order of keys or a note in it do no harm.

    Parameters
    ----------
    path : str or Path
        Of a ``.json`` or ``.nc`` file.
    scene : str, Path or Scene, optional
        The scene of the file, as `nonsmooth.scene` takes it, if it is not shipped.

    Returns
    -------
    orbit, sweep, family or modes, or a list of orbits, of families or of modes
        With the bits of what was saved.

    Raises
    ------
    FileError
        A `ValueError`: if the file cannot be right (a period that is not positive, too many
        or too few numbers, an orbit that does not satisfy its equations, modes that are not
        those of the structure), is from a newer version, of another kind or scene, or of other
        equations.
    SceneFileError
        A `ValueError`: if `scene` is a file that is not as it must be.
    OSError
        If it cannot be read.
    """
    source = Path(path)
    suffix = _suffix(source)
    with source.open("rb"):  # a missing file is an OSError for every kind
        pass
    if suffix == ".csv":
        raise FileError(source, "CSV is for other programs; save as .json to load it")
    if suffix == ".nc":
        return _from_netcdf(source, scene)
    return _from_document(source, _document(source), scene)


def _content(thing: Savable) -> Content:
    """Return what is to be written of a result.

    Raises
    ------
    TypeError
        If it is not a result, or not one that is saved.
    """
    from .space.content import content_of as content_of_modes  # noqa: PLC0415  (SciPy)

    found: Content | None = content_of(thing) or content_of_modes(thing)
    if found is None:
        kinds = "an orbit, a family, modes, a sequence of one of these, or a sweep"
        raise TypeError(f"thing: got {reprlib.repr(thing)}, expected {kinds}")
    return found


def _suffix(path: Path) -> str:
    suffix = path.suffix.lower()
    if suffix not in SUFFIXES:
        raise FileError(path, f"expected a name that ends in one of {', '.join(SUFFIXES)}")
    if suffix == ".nc" and find_spec("netCDF4") is None:
        raise FileError(path, "netCDF needs netCDF4: pip install 'nonsmooth[netcdf]'")
    return suffix


def _document(path: Path) -> dict[str, Any]:
    """Return the document of a JSON file."""
    try:
        document = json.loads(path.read_bytes().decode("utf-8"))
    except (ValueError, RecursionError) as error:  # of the encoding, or of the JSON
        raise damaged(path, f"not JSON: {error}") from error
    if not isinstance(document, dict):
        raise FileError(path, "not a file of nonsmooth")
    return document


def _from_document(path: Path, document: Mapping[str, Any], scene: object = None) -> Loaded:
    """Return what a document holds."""
    check_schema(path, document.get("schema"))
    check_digest(path, document)
    try:
        if "structure" in document:
            from .space.restored import restored as restored_modes  # noqa: PLC0415  (SciPy)

            return restored_modes(path, document)
        if "scene" not in document:
            raise other_kind(path)
        return restored(path, document, scene)
    except (FileError, SceneFileError):
        raise
    except (AttributeError, KeyError, TypeError, ValueError) as error:
        raise damaged(path, _words(error)) from error


def _from_netcdf(path: Path, scene: object) -> Loaded:
    """Return what a netCDF file holds."""
    from netCDF4 import Dataset  # noqa: PLC0415  (an extra)

    from .netcdf_seal import has_seal, warn_without  # noqa: PLC0415

    is_sealed = has_seal(path)
    try:
        with Dataset(path) as file:
            file.set_auto_mask(False)
            check_schema(path, _whole_number(getattr(file, "schema", 0)))
            found, has_digest = _from_open(path, file, scene)
    except (FileError, SceneFileError):
        raise
    except (AttributeError, IndexError, KeyError, OSError, RuntimeError, ValueError) as error:
        raise damaged(path, _words(error)) from error
    if not (is_sealed or has_digest):
        warn_without(path)
    return found


def _from_open(path: Path, file: "Dataset", scene: object) -> tuple[Loaded, bool]:
    """Return what an open file holds, and whether it has a digest of its own."""
    from . import netcdf  # noqa: PLC0415  (an extra)

    if netcdf.DOCUMENT in file.variables:
        found = _from_document(path, netcdf.document_of(file), scene)
        netcdf.check_same(file, _content(found).tables())
        return found, True
    raise other_kind(path)


def _words(error: Exception) -> str:
    """Return what is wrong, in words: an error of Python with its name."""
    from .checks import NotRightError  # noqa: PLC0415

    return str(error) if isinstance(error, NotRightError) else f"{type(error).__name__} {error}"


def _whole_number(value: Any) -> object:
    """Return a number of a file as an int; what is not one as it is."""
    try:
        return int(value)
    except (TypeError, ValueError):
        return value
