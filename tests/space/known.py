"""References to 30 digits, and what several tests of modes share.

`references.json` has 210 structures: exact eigenvalues (bisection at 60 digits of the
characteristic equation), Ritz values at 38 digits.  One of these is left out, of beam-spring at
1/2 with strength 1e6 and two forced modes: a root was missed there.  It is computed anew in
`test_space_matrices`.
"""

import json
from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from nonsmooth.solver.space.attached import Attached
from nonsmooth.solver.space.structure import load, names

NAMES = names()

#: Those whose modes without a forced mode are felt.
FELT = tuple(name for name in NAMES if name != "beam-crack")


@cache
def references() -> tuple[dict[str, Any], ...]:
    text = (Path(__file__).parent / "references.json").read_text("utf-8")
    return tuple(json.loads(text))


@cache
def attached(name: str, position: str = "3/10", strength: float = 10.0) -> Attached:
    """Return a structure whose parameters are 1: what is attached is the strength."""
    structure = load(name)
    values = {q.name: 1.0 for q in structure.parameters}
    values[structure.attached.name] = float(strength)
    return Attached(structure, values, Fraction(position))


def of(reference: dict[str, Any]) -> Attached:
    try:
        Fraction(reference["position"])
        place = reference["position"]
    except ValueError:
        place = reference["position_30"]
    return attached(reference["structure"], place, float(reference["strength"]))


def exact_values(reference: dict[str, Any]) -> "np.ndarray[Any, Any]":
    return np.array([float(value) for value in reference["exact"]])
