"""Modes from their documents, if these can be right.

A document has the numbers of modes and not their shapes: these are computed anew from the
structure, and what the document says is held against the frequencies that come with them.
"""

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

from nonsmooth.solver.space.attached import attach
from nonsmooth.solver.space.expansions.methods import METHODS, check_forced
from nonsmooth.solver.space.mode import Mode
from nonsmooth.solver.space.modes import Modes, at_order
from nonsmooth.solver.space.structure import UnknownStructure, load

from .. import checks
from ..errors import FileError
from .documents import mathematics

#: Largest difference of an error, and, as a part of it if it is above 1, of `jump_mismatch`.
ERROR, MISMATCH = 1e-11, 1e-6


def restored(path: Path, document: Mapping[str, Any]) -> Modes | list[Modes]:
    """Return the modes that a document holds.

    Parameters
    ----------
    path : Path
        Where it stands, for messages.
    document : mapping
        As JSON has it: one expansion, or several in ``expansions`` or ``points``.

    Raises
    ------
    FileError
        If it holds no modes, or the structure or its equations are others.
    NotRightError
        A `ValueError`: if a number in it cannot be right.
    """
    if "modes" in document:
        return _modes(path, document, document["mathematics"])
    several = document.get("expansions", document.get("points"))
    if not several:
        raise FileError(path, "holds no modes; only modes of a structure can be loaded")
    return [_modes(path, each, document["mathematics"]) for each in several]


def _modes(path: Path, document: Mapping[str, Any], found: str) -> Modes:
    """Return the modes of one expansion."""
    try:
        structure = load(document["structure"])
    except UnknownStructure as error:
        raise FileError(path, f"of another nonsmooth: {error}") from error
    if found != mathematics(structure):
        raise FileError(path, f"modes of other equations ({found}): compute them anew")
    attached = attach(structure, document["position"], **document["parameters"])
    method, forced = document["method"], document["forced"]
    if method not in METHODS:
        raise checks.NotRightError(f"method is {method!r}, expected one of {METHODS}")
    K = check_forced(structure, method, forced if method == "ritz-ck" else None)
    modes = at_order(attached, method, document["order"], K, len(document["modes"]))
    for name, expected in (("forced", K), ("unknowns", modes.unknowns)):
        if document[name] != expected:
            raise checks.NotRightError(f"{name} is {document[name]!r}, expected {expected}")
    checks.same("strength", document["strength"], attached.s, "its parameters")
    rows = zip(modes, document["modes"], strict=True)
    return replace(modes, found=tuple(_mode(mode, row) for mode, row in rows))


def _mode(mode: Mode, row: Mapping[str, Any]) -> Mode:
    """Return a mode with the bits of its row, which must be right."""
    name = f"mode {mode.number}"
    for key in ("number", "node"):
        if row[key] != getattr(mode, key):
            expected = getattr(mode, key)
            raise checks.NotRightError(f"{name}: {key} is {row[key]!r}, expected {expected!r}")
    low, high = row["bounds"]
    numbers = {
        "eigenvalue": (row["eigenvalue"], mode.eigenvalue),
        "beta": (row["beta"], mode.beta),
        "frequency": (row["frequency"], mode.frequency),
        "exact beta": (row["exact"]["beta"], mode.exact_beta),
        "bound": (high, mode.bounds[1]),
    }
    for key, (value, expected) in numbers.items():
        checks.same(f"{name}: {key}", value, expected, "its parameters")
    _near(f"{name}: bound", low, mode.bounds[0], checks.SAME * high)
    _near(f"{name}: error", row["error"], mode.error, ERROR)
    most = MISMATCH * max(1, abs(mode.jump_mismatch or 0))
    _near(f"{name}: jump_mismatch", row["jump_mismatch"], mode.jump_mismatch, most)
    return replace(
        mode,
        eigenvalue=row["eigenvalue"],
        exact_beta=row["exact"]["beta"],
        error=row["error"],
        bounds=(low, high),
        jump_mismatch=row["jump_mismatch"],
    )


def _near(name: str, value: Any, expected: float | None, most: float) -> None:
    """Check that a number is another but for so much; both may be None."""
    if value is None or expected is None:
        right = value is expected
    else:
        right = checks.is_real(value) and abs(value - expected) <= most
    if not right:
        raise checks.NotRightError(f"{name} is {value!r}, but its parameters give {expected!r}")
