"""An orbit of a scene as a JSON document, in SI units."""

from dataclasses import asdict, fields
from typing import TYPE_CHECKING, Any

from ..orbit.errors import Errors
from ..presentation.documents import SCHEMA, finite
from ..scenes.classes import classes
from ..stability import in_words as stability

if TYPE_CHECKING:
    from ..exact import ExactOrbit
    from ..no_orbit import NoOrbit
    from ..scenes.case import Case
    from .orbit import Orbit


def document(orbit: "Orbit") -> dict[str, Any]:
    """Return an orbit as a JSON document: numbers, text, lists; None for unknown values."""
    content = {
        **_head(orbit.case, orbit.method, orbit.order, orbit.functions),
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
        **orbit.further,
        "period": orbit.period,
        "forcing_phase": orbit.forcing_phase,
        "memory": orbit.memory,
        "extremes": {name: list(ends) for name, ends in orbit.extremes.items()},
        "coefficients": orbit.coefficients,
        "admissible": orbit.admissible,
        "violations": list(orbit.violations),
        "exact": _of_exact(orbit.exact),
        "errors": errors_of(orbit.errors),
        "estimate": errors_of(orbit.estimate),
        **stability.document(orbit),
        "others": [_of_other(other) for other in orbit.others],
        "outcome": vars(orbit.outcome) | {"unknowns": orbit.unknowns.tolist()},
    }
    plain: dict[str, Any] = finite(content)
    return plain


def document_without_orbit(
    case: "Case", method: str, order: int | None, functions: int | None, finding: "NoOrbit",
    exact: "ExactOrbit | None",
) -> dict[str, Any]:  # fmt: skip
    """Return the document of a missing orbit: the same keys as for an orbit, and `status`."""
    ends = dict.fromkeys(("displacement", "velocity"))
    phases = () if case.scene.motions else case.cell.phases * case.cell.cells
    content = {
        **_head(case, method, order, functions),
        "converged": False,
        "iterations": finding.iterations,
        "residual_norm": None,
        "phases": [
            {"name": phase.name, "duration": None, "start": dict(ends)} for phase in phases
        ],
        "period": None,
        "forcing_phase": None,
        "memory": {},
        "extremes": dict(ends),
        "coefficients": None,
        "admissible": False,
        "violations": [finding.in_full],
        "exact": _of_exact(exact),
        "errors": errors_of(None),
        "estimate": errors_of(None),
        **stability.without_multipliers(),
        "others": [],
        "outcome": None,
        "status": finding.status,
    }
    content = case.completed(content, exact)
    plain: dict[str, Any] = finite(content)
    return plain


def _head(
    case: "Case", method: str, order: int | None, functions: int | None
) -> dict[str, Any]:
    """Return the entries of a document that state the problem: case, method, order."""
    return {
        "schema": SCHEMA,
        "scene": case.scene.name,
        "class": f"C{case.scene.k}",
        "classes": [] if case.scene.motions else [f"C{k}" for k in classes(case.cell)],
        "motion": case.scene.motion,
        "cycles": case.cycles,
        "method": case.called(method),
        "order": order,
        "functions": functions,
        "parameters": dict(case.values),
    }


def errors_of(errors: Errors | None) -> dict[str, float | None]:
    """Return errors by their names; each is None without an orbit."""
    return asdict(errors) if errors else dict.fromkeys(q.name for q in fields(Errors))


def _of_exact(exact: "ExactOrbit | None") -> dict[str, Any]:
    """Return the times of an exact orbit; each is None without one."""
    return {
        "period": exact and exact.period,
        "forcing_phase": exact and exact.forcing_phase,
        "durations": exact and list(exact.durations),
    }


def _of_other(exact: "ExactOrbit") -> dict[str, Any]:
    """Return motion, times and stability of another exact orbit of the case."""
    motion = {"motion": exact.case.scene.motion}
    return motion | _of_exact(exact) | stability.document(exact)
