"""What every file says of itself: schema, version, mathematics, units."""

import hashlib
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from nonsmooth.solver.shortcuts.orbit.oscillator import PARAMETERS
from nonsmooth.solver.shortcuts.search.kernels import module

from ..errors import FileError

#: Units of what is in a file, beside the parameters'; what is not here is a plain number.
UNITS = {"t1": "s", "period": "s", "seconds": "s", "amplitude": "m"}

#: Of what an orbit has as that of any scene.
UNITS_OF_ORBIT = {
    "duration": "s",
    "durations": "s",
    "forcing_phase": "rad",
    "displacement": "m",
    "velocity": "m/s",
}
COEFFICIENTS = {
    "hb": {"a0": "m", "a": "m", "b": "m"},
    "hb-c1": {"a0": "m", "a": "m", "b": "m", "c1": "m/s**4", "c": "m/s**2"},
    "c1": {"d": "m/s**(n + 2)"},
}


def mathematics(methods: Iterable[str]) -> str:
    """Return a hash of the closed forms behind these methods: 16 hexadecimal digits.

    Examples
    --------
    >>> mathematics(["hb"]) == mathematics(["c1"])
    False
    """
    names = sorted({name for method in methods for name in _modules(method)})
    text = "".join(module(name).MATHEMATICS for name in names)
    return hashlib.sha256(text.encode()).hexdigest()[:16]


def of_all_methods() -> str:
    """Return the hash for all methods of the paper."""
    return mathematics(COEFFICIENTS)


def _modules(method: str) -> tuple[str, str]:
    return (method, "c1-reduced" if method == "c1" else "hb-symmetric")


def origin(methods: Iterable[str]) -> dict[str, Any]:
    """Return version and mathematics, as files have them."""
    from nonsmooth import __version__  # noqa: PLC0415

    return {"version": __version__, "mathematics": mathematics(methods)}


def units(methods: Iterable[str] = ()) -> dict[str, Any]:
    """Return the units of what is in a file."""
    found: dict[str, Any] = {name: unit or "1" for name, (unit, _) in PARAMETERS.items()}
    found |= UNITS
    coefficients = {method: COEFFICIENTS[method] for method in methods}
    more = UNITS_OF_ORBIT | {"coefficients": coefficients}
    return found | (more if coefficients else {})


def check_mathematics(path: Path, found: object, methods: Iterable[str]) -> None:
    """Check that an orbit is of the equations that are here: it is evaluated with them.

    Raises
    ------
    FileError
        If it is not.
    """
    here = mathematics(methods)
    if found != here:
        raise FileError(
            path, f"an orbit of other equations ({found}, here {here}): compute it anew"
        )
