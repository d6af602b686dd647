"""What the document of any scene has, for an orbit of the paper's methods."""

import math
from typing import Any

from nonsmooth.solver.no_orbit import NoOrbit
from nonsmooth.solver.shortcuts.names import PHASES, SCENE
from nonsmooth.solver.shortcuts.orbit.motion import ExactOrbit
from nonsmooth.solver.shortcuts.orbit.orbit import Orbit

#: The class of the motion.
CLASS = "C1"


def scene() -> dict[str, Any]:
    """Return scene and class, which every document begins with."""
    return {"scene": SCENE, "class": CLASS, "motion": None, "cycles": 1}


def head() -> dict[str, Any]:
    """Return which scene it is."""
    classes = [CLASS] * len(PHASES)
    return {
        "schema": 1, "scene": SCENE, "class": CLASS, "classes": classes, "motion": None,
        "cycles": 1,
    }  # fmt: skip


def motion(found: Orbit | NoOrbit) -> dict[str, Any]:
    """Return phases, phase of the forcing, which there is not, and ends of the motion."""
    nothing = dict.fromkeys(("displacement", "velocity"))
    if not isinstance(found, Orbit):
        phases: list[dict[str, Any]] = [
            {"name": name, "duration": None, "start": dict(nothing)} for name in PHASES
        ]
        return {
            "phases": phases,
            "forcing_phase": None,
            "memory": {},
            "extremes": dict(nothing),
        }
    starts, durations = (0.0, found.t1), (found.t1, found.period - found.t1)
    phases = [
        {
            "name": name,
            "duration": duration,
            "start": {
                "displacement": float(found.displacement(start)),
                "velocity": float(found.velocity(start)),
            },
        }
        for name, start, duration in zip(PHASES, starts, durations, strict=True)
    ]
    ends = {name: list(pair) for name, pair in found.extremes.items()}
    return {"phases": phases, "forcing_phase": None, "memory": {}, "extremes": ends}


def exact(reference: ExactOrbit) -> dict[str, Any]:
    """Return what of the exact orbit other scenes have."""
    durations = [reference.t1, reference.period - reference.t1]
    return {"forcing_phase": None, "durations": durations}


def errors(found: Orbit | NoOrbit, reference: ExactOrbit) -> dict[str, Any]:
    """Return the errors that other scenes have: of the times, and of what jumps first."""
    if not isinstance(found, Orbit):
        return dict.fromkeys(("times", "discontinuous"))
    T = reference.period
    stick, whole = found.errors.t1 * reference.t1 / T, found.errors.period
    largest = max(abs(stick), abs(whole - stick))
    return {"times": largest, "discontinuous": found.errors.acceleration_aligned}


def estimate(found: Orbit | NoOrbit) -> dict[str, Any]:
    """Return those errors as they are estimated; that of what jumps is not estimated apart."""
    if not isinstance(found, Orbit):
        return dict.fromkeys(("times", "discontinuous"))
    judged = found.estimate
    times = judged.period + judged.t1 * found.t1 / found.period
    return {"times": times if math.isfinite(times) else None, "discontinuous": None}
