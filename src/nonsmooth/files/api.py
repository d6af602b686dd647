"""Orbits, sweeps and families as files that others can read, and that read back the same.

JSON holds everything, with a digest; netCDF (extra ``netcdf``) as well, for tools that work
on arrays; CSV holds the rows of a sweep or a family, and the motion of an orbit.  Numbers are
in SI units, and every file says with which version and which mathematics it was made.
"""

import reprlib
from collections.abc import Callable, Sequence
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from typing import Any, TypeAlias

from nonsmooth.solver.shortcuts.orbit.orbit import Orbit
from nonsmooth.solver.shortcuts.search.family import Family
from nonsmooth.solver.shortcuts.search.sweep import Sweep

from .errors import FileError
from .shortcuts.points import Points, of_families
from .whole import whole

Savable: TypeAlias = Orbit | Sequence[Orbit] | Sweep | Family | Sequence[Family] | Points
Loaded: TypeAlias = Orbit | list[Orbit] | Sweep | Family | list[Family]

#: The module of each kind of file.
SUFFIXES = {".json": "texts", ".csv": "tables", ".nc": "netcdf"}


def save(thing: Savable, path: str | Path) -> None:
    """Write a file, whole or not at all.

    Parameters
    ----------
    thing : Orbit or Family, or a sequence of these, or Sweep
        What to save; or `points.Points`, families that are not in memory.
    path : str or Path
        Ends in ``.json``, ``.csv`` or ``.nc`` (netCDF-4).  The CSV of orbits is their
        motion over one period, for other programs: it cannot be loaded.

    Raises
    ------
    FileError
        A `ValueError`: if the name ends otherwise, or netCDF4 is not installed.
    TypeError
        If `thing` is none of these, or a sequence that is empty or of both.
    OSError
        If the file cannot be written; then nothing is left of it.

    Examples
    --------
    >>> import tempfile, nonsmooth as ns
    >>> belt = ns.StickSlip(mass=10, stiffness=1000, belt_speed=1,
    ...                     mu_s=0.5, mu_k=0.25, normal_force=400)
    >>> orbit = ns.solve(belt, method="c1", order=7)
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     ns.save(orbit, f"{folder}/orbit.json")
    ...     ns.load(f"{folder}/orbit.json").period == orbit.period
    True
    """
    target = Path(path)
    form = _format(target)
    write, what = _writer(form, thing)
    with whole(target) as temporary:
        write(what, temporary)


def load(path: str | Path) -> Loaded:
    """Read a file that `save` or the command line wrote.

    Parameters
    ----------
    path : str or Path
        Of a ``.json``, ``.csv`` or ``.nc`` file.

    Returns
    -------
    Orbit, list of Orbit, Sweep, Family or list of Family
        With the bits of what was saved.

    Raises
    ------
    FileError
        A `ValueError`: if the file is damaged, from a newer version, of another kind, or
        an orbit of other equations.
    OSError
        If it cannot be read.
    """
    source = Path(path)
    form = _format(source)
    with source.open("rb"):  # a missing file is an OSError for every kind
        pass
    found: Loaded = form.read(source)
    return found


def _writer(form: Any, thing: Savable) -> tuple[Callable[[Any, Path], None], Any]:
    """Return what writes this kind of thing, and the thing as it takes it."""
    if isinstance(thing, Sweep):
        return form.write_sweep, thing
    if isinstance(thing, Points):
        return form.write_points, thing
    several = [thing] if isinstance(thing, Orbit | Family) else thing
    if isinstance(several, Sequence) and several:
        if all(isinstance(one, Orbit) for one in several):
            return form.write_orbits, several
        families = [one for one in several if isinstance(one, Family)]
        if len(families) == len(several):
            return form.write_points, of_families(families)
    kinds = "an orbit, a family, a sequence of one of these, or a sweep"
    raise TypeError(f"thing: got {reprlib.repr(thing)}, expected {kinds}")


def _format(path: Path) -> Any:
    """Return the module that writes and reads files of this name."""
    suffix = path.suffix.lower()
    if suffix not in SUFFIXES:
        raise FileError(path, f"expected a name that ends in one of {', '.join(SUFFIXES)}")
    if suffix == ".nc" and find_spec("netCDF4") is None:
        raise FileError(path, "netCDF needs netCDF4: pip install 'nonsmooth[netcdf]'")
    return import_module(f".shortcuts.{SUFFIXES[suffix]}", __package__)
