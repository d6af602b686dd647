"""Scenes with several motions: each is tried in its turn."""

from collections.abc import Callable
from typing import TypeVar

from .no_orbit import NoOrbit
from .scenes.case import Case

# What is found for the case of one motion.
Found = TypeVar("Found")


def of_any_motion(case: Case, find: Callable[[Case], Found]) -> Found:
    """Return what is found for the first motion of a case for which there is something.

    Raises
    ------
    NoOrbit
        If there is nothing for any; with the reasons of each.
    """
    tried: list[str] = []
    iterations, proven = 0, True
    for each in case.each_motion:
        try:
            return find(each)
        except NoOrbit as finding:
            if not case.scene.motions:
                raise
            tried += [f"{each.scene.motion}: {why}" for why in finding.reasons]
            iterations += finding.iterations
            proven = proven and finding.proven
    motions = ", ".join(case.scene.motions)
    error = NoOrbit(
        f"{case.scene.name}: no admissible orbit of any motion ({motions}) was found",
        proven,
        tuple(tried),
    )
    error.iterations = iterations
    raise error
