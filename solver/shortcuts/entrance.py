"""How the paper's oscillator is reached: its verbs, imported when they are called."""

import math
from dataclasses import asdict
from typing import Any

from ..case.case import Case
from ..case.registry import load
from ..shortcut import Entrance
from .names import METHODS, SCENE
from .orbit.oscillator import StickSlip, alpha_of


def case_of(belt: StickSlip) -> Case:
    """Return an oscillator as a case of its scene."""
    return load(SCENE)(**asdict(belt))


def belt_of(case: Case) -> StickSlip:
    """Return a case of the scene as the paper's oscillator."""
    return StickSlip(**case.values)


def alpha_of_case(case: Case) -> float:
    """Return ``alpha`` of a case of the scene."""
    return float(alpha_of(case.values, math.sqrt))


def _solve(belt: StickSlip, *arguments: Any, **options: Any) -> Any:
    from .search.solve import solve  # noqa: PLC0415  (it loads parts of SciPy)

    return solve(belt, *arguments, **options)


def _sweep(belt: StickSlip, *arguments: Any, **options: Any) -> Any:
    from .search.sweep import sweep  # noqa: PLC0415  (it loads parts of SciPy)

    return sweep(belt, *arguments, **options)


def _exact(belt: StickSlip) -> Any:
    from .orbit.motion import exact  # noqa: PLC0415

    return exact(belt)


def _family(belt: StickSlip, *arguments: Any, **options: Any) -> Any:
    from .search.family import family  # noqa: PLC0415

    return family(belt, *arguments, **options)


ENTRANCES = (
    Entrance(
        StickSlip, SCENE, METHODS, case_of, _solve, _sweep, _exact, _family, METHODS["ck"]
    ),
)  # fmt: skip
