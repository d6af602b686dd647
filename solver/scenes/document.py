"""An orbit of a scene as the document that programs read, in SI units."""

import math
from dataclasses import asdict
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from .orbit import SceneOrbit

#: Of the document's keys and their meaning.
SCHEMA = 1

_NO_ERRORS = dict.fromkeys(("period", "times", "discontinuous"))


def document(orbit: "SceneOrbit") -> dict[str, Any]:
    """Return an orbit as a document of JSON: numbers, text, lists; None for what is unknown."""
    exact, errors = orbit.exact, orbit.errors
    content = {
        "schema": SCHEMA,
        "scene": orbit.case.scene.name,
        "class": orbit.smoothness,
        "motion": None,
        "method": orbit.method,
        "order": orbit.order,
        "functions": orbit.functions,
        "parameters": dict(orbit.case.values),
        "converged": orbit.converged,
        "iterations": orbit.iterations,
        "residual_norm": orbit.residual_norm,
        "phases": [
            {
                "name": phase.name,
                "duration": phase.duration,
                "start": {"displacement": phase.displacement, "velocity": phase.velocity},
            }
            for phase in orbit.phases
        ],
        "period": orbit.period,
        "forcing_phase": orbit.forcing_phase,
        "extremes": {name: list(ends) for name, ends in orbit.extremes.items()},
        "coefficients": orbit.coefficients,
        "admissible": orbit.admissible,
        "violations": list(orbit.violations),
        "exact": {
            "period": exact and exact.period,
            "forcing_phase": exact and exact.forcing_phase,
            "durations": exact and list(exact.durations),
        },
        "errors": asdict(errors) if errors else dict(_NO_ERRORS),
        "estimate": asdict(orbit.estimate),
    }
    return {name: _finite(value) for name, value in content.items()}


def _finite(value: Any) -> Any:
    """Return a document with None for what is infinite or not a number."""
    if isinstance(value, dict):
        return {name: _finite(part) for name, part in value.items()}
    if isinstance(value, list):
        return [_finite(part) for part in value]
    if isinstance(value, float) and not math.isfinite(value):
        return None
    return value
