"""Orbits and sweeps as plain dictionaries, and back: what JSON holds."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import asdict, fields
from typing import Any

import numpy as np

from nonsmooth.solver.no_orbit import NoOrbit
from nonsmooth.solver.shortcuts.accuracy.errors import Errors
from nonsmooth.solver.shortcuts.accuracy.estimate import Estimate
from nonsmooth.solver.shortcuts.entrance import case_of
from nonsmooth.solver.shortcuts.full import by_quadrature
from nonsmooth.solver.shortcuts.names import SCENE
from nonsmooth.solver.shortcuts.orbit.methods import (
    METHODS,
    check_method,
    check_order,
    with_terms,
)
from nonsmooth.solver.shortcuts.orbit.motion import exact
from nonsmooth.solver.shortcuts.orbit.orbit import Orbit
from nonsmooth.solver.shortcuts.orbit.oscillator import StickSlip
from nonsmooth.solver.shortcuts.search import kernels
from nonsmooth.solver.shortcuts.search.family_points import STATUS
from nonsmooth.solver.shortcuts.search.newton import Outcome
from nonsmooth.solver.shortcuts.search.sweep import Row, Sweep

from .. import checks
from . import as_any_scene
from .origin import origin, units

#: Harmonics up to which the equations of an orbit that is loaded are evaluated: in a second.
MOST_CHECKED = 120

#: What `solve --json` has of an orbit that is an attribute of it.
ATTRIBUTES = ("residual_norm", "t1", "period", "coefficients")


def of_solution(
    belt: StickSlip, method: str, order: int, found: Orbit | NoOrbit
) -> dict[str, Any]:
    """Return one solution; with null for what an absent orbit lacks."""
    reference = exact(belt)
    head = as_any_scene.head()
    head |= {"method": method, "order": order, "parameters": asdict(belt)}
    times = {"t1": reference.t1, "period": reference.period}
    tail = as_any_scene.motion(found) | {"exact": times | as_any_scene.exact(reference)}
    also = as_any_scene.errors(found, reference), as_any_scene.estimate(found)
    if isinstance(found, Orbit):
        result: dict[str, Any] = {"converged": found.converged, "iterations": found.iterations}
        result |= {name: getattr(found, name) for name in ATTRIBUTES}
        result |= {"admissible": found.admissible, "violations": list(found.violations)}
        result["transition_mismatch"] = found.transition_mismatch
        result["multipliers"] = [
            {"re": q.real, "im": q.imag} for q in found.multipliers.tolist()
        ]
        result["stable"] = found.stable
        judged = {
            "errors": asdict(found.errors) | also[0],
            "estimate": asdict(found.estimate) | also[1],
        }
        more: dict[str, Any] = {"c1_terms": found.c1_terms} if found.c1_terms > 1 else {}
        outcome = vars(found.outcome) | {"unknowns": found.unknowns.tolist()}
        return head | result | tail | judged | more | {"outcome": outcome}
    result = {"converged": False, "iterations": found.iterations} | dict.fromkeys(ATTRIBUTES)
    result |= {"admissible": False, "violations": [str(found)]}
    result |= dict.fromkeys(("transition_mismatch", "multipliers", "stable"))
    judged = {
        "errors": dict.fromkeys(field.name for field in fields(Errors)) | also[0],
        "estimate": dict.fromkeys(field.name for field in fields(Estimate)) | also[1],
    }
    return head | result | tail | judged | {"outcome": None, "status": found.status}


def of_orbits(orbits: Sequence[Orbit]) -> dict[str, Any]:
    """Return the document of one orbit, or of several."""
    found = [of_solution(orbit.belt, orbit.method, orbit.order, orbit) for orbit in orbits]
    return found[0] if len(found) == 1 else several(found)


def several(documents: Sequence[dict[str, Any]]) -> dict[str, Any]:
    """Return the document of several orbits."""
    return {"scene": SCENE, "orbits": list(documents)}


def to_orbit(document: dict[str, Any]) -> Orbit:
    """Return the orbit of a document."""
    outcome = document["outcome"]
    unknowns = np.array(outcome["unknowns"], dtype=float)
    unknowns.flags.writeable = False
    orbit = Orbit(
        StickSlip(**document["parameters"]),
        check_method(document["method"]).name,
        document["order"],
        Outcome(**outcome | {"unknowns": unknowns}),
        document["iterations"],
        document.get("c1_terms", 1),
    )
    check_orbit(orbit)
    for name in ("period", "t1"):
        checks.positive(name, document[name])
        checks.same(name, document[name], getattr(orbit, name), "its unknowns")
    return orbit


def check_orbit(orbit: Orbit) -> None:
    """Check that the unknowns of an orbit satisfy their equations.

    Of a Fourier series of more than `MOST_CHECKED` harmonics only what (9) and (10) say.

    Raises
    ------
    NotRightError
        If they do not, or are not as many as these.
    """
    z, order, alpha = orbit.unknowns, orbit.order, orbit.belt.alpha
    terms = with_terms(METHODS[orbit.method], orbit.c1_terms).c1_terms
    check_order(order, METHODS[orbit.method])
    checks.unknowns(z, order + 3 if terms is None else 2 * order + 3 + terms)
    checks.positive("t1", orbit.t1)
    checks.positive("the duration of slip", orbit.period - orbit.t1)
    if terms is None or (order <= MOST_CHECKED and terms <= 1):
        R = np.empty(len(z))
        kernels.plain(orbit.method).residual(alpha, z, R)
    elif order <= MOST_CHECKED:
        R = by_quadrature(case_of(orbit.belt), order, terms, z)
    else:
        _, _, evaluate = orbit._dimensionless()
        start = np.zeros(1)
        R = np.array([evaluate(start, 0)[0] + alpha, evaluate(start, 1)[0] - 1])
    checks.residual(R, z)
    if not orbit.admissible:
        raise checks.NotRightError(f"no orbit: {'; '.join(orbit.violations)}")


def of_sweep(result: Sweep) -> dict[str, Any]:
    """Return a sweep over orders."""
    return {
        "parameters": asdict(result.belt),
        "rows": [row.as_dict() for row in result.rows],
        "c1_terms": result.c1_terms,
        "rates": {name: asdict(rate) for name, rate in result.rates().items()},
    }


def to_sweep(document: Mapping[str, Any]) -> Sweep:
    """Return the sweep of a document."""
    rows = tuple(to_row(row) for row in document["rows"])
    return Sweep(StickSlip(**document["parameters"]), rows, document["c1_terms"])


def to_row(row: dict[str, Any]) -> Row:
    """Return a row of a sweep; an error that is null beside an orbit is infinite."""
    found = row["status"] == "ok"
    if row["status"] not in STATUS or row["method"] not in METHODS:
        raise checks.NotRightError(f"a row {row['status']!r} of {row['method']!r}")
    checks.not_negative("iterations", row["iterations"])
    checks.not_negative("seconds", row["seconds"])
    if found:
        checks.positive("t1", row["t1"])
        checks.positive("period less t1", row["period"] - row["t1"])
        for name, value in (*row["estimate"].items(), *_unsigned(row["errors"])):
            checks.not_negative(name, value)
    values = {name: _known(row["errors"][name]) for name in row["errors"]}
    judged = {name: _known(row["estimate"][name]) for name in row["estimate"]}
    errors = Errors(**values) if found else None
    estimate = Estimate(**judged) if found else None
    return Row(**row | {"errors": errors, "estimate": estimate})


def _unsigned(errors: dict[str, Any]) -> list[tuple[str, Any]]:
    """Return the errors that have no sign."""
    return [(name, errors[name]) for name in ("acceleration", "acceleration_aligned")]


def _known(value: float | None) -> float:
    return math.inf if value is None else value


def with_origin(document: dict[str, Any], methods: Sequence[str]) -> dict[str, Any]:
    """Return a document that says where it comes from."""
    shown = methods if "coefficients" in document or "orbits" in document else ()
    return document | {"units": units(shown)} | origin(methods)
