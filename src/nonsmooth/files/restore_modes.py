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

from . import checks
from .documents import mathematics_of_modes
from .file_errors import FileError

#: Largest difference of an error, and, as a part of it if it is above 1, of `jump_mismatch`.
ERROR, MISMATCH = 1e-11, 1e-6

#: What says what the numbers of a mode must be.
PARAMETERS = "its parameters"


def modes_in(path: Path, document: Mapping[str, Any]) -> Modes | list[Modes]:
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
    if "shapes" in document:
        raise FileError(path, "holds shapes of modes, which are not loaded: save the modes")
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
    if found != mathematics_of_modes(structure):
        raise FileError(path, f"modes of other equations ({found}): compute them anew")
    attached = attach(structure, document["position"], **document["parameters"])
    method, forced = document["method"], document["forced"]
    checks.one_of("method", method, METHODS)
    K = check_forced(structure, method, forced if method == "ritz-ck" else None)
    modes = at_order(attached, method, document["order"], K, len(document["modes"]))
    checks.equal("forced", forced, K)
    checks.equal("unknowns", document["unknowns"], modes.unknowns)
    checks.same("strength", document["strength"], attached.s, PARAMETERS)
    rows = zip(modes, document["modes"], strict=True)
    return replace(modes, found=tuple(_mode(mode, row) for mode, row in rows))


def _mode(mode: Mode, row: Mapping[str, Any]) -> Mode:
    """Return a mode with the bits of its row, which must be right."""
    name = f"mode {mode.number}"
    checks.equal(f"{name}: number", row["number"], mode.number)
    checks.equal(f"{name}: node", row["node"], mode.node)
    low, high = row["bounds"]
    exact_beta, mismatch = row["exact"]["beta"], row["jump_mismatch"]
    for key, value, expected in (
        ("eigenvalue", row["eigenvalue"], mode.eigenvalue),
        ("beta", row["beta"], mode.beta),
        ("frequency", row["frequency"], mode.frequency),
        ("exact beta", exact_beta, mode.exact_beta),
        ("omega", row.get("omega", mode.omega), mode.omega),
        ("modal mass", row.get("modal_mass", mode.modal_mass), mode.modal_mass),
        ("bound", high, mode.bounds[1]),
    ):
        checks.same(f"{name}: {key}", value, expected, PARAMETERS)
    for key, value, known, most in (
        ("bound", low, mode.bounds[0], checks.SAME * high),
        ("error", row["error"], mode.error, ERROR),
        ("jump_mismatch", mismatch, mode.jump_mismatch,
         MISMATCH * max(1, abs(mode.jump_mismatch or 0))),
    ):  # fmt: skip
        checks.near(f"{name}: {key}", value, known, most, PARAMETERS)
    return replace(
        mode,
        eigenvalue=row["eigenvalue"],
        exact_beta=exact_beta,
        error=row["error"],
        bounds=(low, high),
        jump_mismatch=mismatch,
    )
