"""Orbits, sweeps and families of any scene from their documents, if these can be right."""

from collections.abc import Iterable, Mapping
from dataclasses import fields
from pathlib import Path
from typing import Any

import numpy as np

from nonsmooth.kim_perkins import StickSlip, StickSlipErrors, as_in_paper
from nonsmooth.scene import find
from nonsmooth.solver.arrays import Vector
from nonsmooth.solver.in_order import motion_of
from nonsmooth.solver.iteration.newton import Outcome
from nonsmooth.solver.kernels.kernel import Kernel
from nonsmooth.solver.kernels.registry import generic_method, kernel, mathematics
from nonsmooth.solver.orbit.errors import Errors
from nonsmooth.solver.results.branch import Branch, BranchEvent
from nonsmooth.solver.results.chart import Chart, EventCurve
from nonsmooth.solver.results.family import Beside, Family, FamilyRow
from nonsmooth.solver.results.orbit import Orbit
from nonsmooth.solver.results.sweep import Sweep, SweepRow
from nonsmooth.solver.scenes.case import Case
from nonsmooth.solver.scenes.loaded import LoadedScene, UnknownScene

from . import checks
from .file_errors import FileError, other_kind

#: What a row may say of itself.
STATUS = ("ok", "no-orbit", "not-converged")

#: Largest residual of an orbit, without units, as a part of its largest unknown.
RESIDUAL = 1e-8


def result_in(path: Path, document: Mapping[str, Any], scene: object = None) -> Any:
    """Return what a document of a scene holds.

    Parameters
    ----------
    path : Path
        Where it stands, for messages.
    document : mapping
        As JSON has it.
    scene : optional
        The scene, as `nonsmooth.scene` takes it, of one that is not shipped.

    Raises
    ------
    FileError
        If it holds nothing that can be restored, or the scene or its equations are others.
    NotRightError
        A `ValueError`: if a number in it cannot be right.
    """
    if "axes" in document:
        return _map(document, _case(path, {**document, "motion": None}, scene))
    if "why_it_ended" in document:
        return _branch(document, _case(path, document, scene))
    if "vary" in document:
        if "rows" not in document:  # states of a bifurcation diagram
            raise other_kind(path)
        return _family(path, document, _case(path, document, scene))
    if "rows" in document:
        if not {"functions", "rates"} & document.keys():  # rows of ``digits``
            raise other_kind(path)
        found = [row for row in document["rows"] if row.get("status") == "ok"]
        return _sweep(path, document, _case(path, document, scene, found))
    entries = document.get("orbits", [document])
    if not all("converged" in entry for entry in entries):
        raise other_kind(path)
    orbits = [_orbit(path, document | entry, scene) for entry in entries if entry["converged"]]
    if "orbits" not in document and not orbits:
        raise FileError(path, f"no orbit: {'; '.join(document['violations'])}")
    return orbits if "orbits" in document else orbits[0]


def _case(
    path: Path, document: Mapping[str, Any], scene: object,
    orbits: Iterable[Mapping[str, Any]] = (),
) -> Case:  # fmt: skip
    """Return the case of a document: of the paper's scene a `StickSlip`.

    But if the entries of its orbits have not what those of a `StickSlip` have, it was none.
    """
    name = document["scene"]
    try:
        loaded = find(name if scene is None else scene)
    except (UnknownScene, TypeError) as error:
        if scene is not None:
            raise FileError(path, str(error)) from error
        hint = "give its file or the scene itself as `scene`"
        raise FileError(path, f"of the scene {name!r}, which is not shipped: {hint}") from error
    if loaded.name != name:
        raise FileError(path, f"of the scene {name!r}, got {loaded.name!r}")
    if document.get("motion") is not None:
        loaded = motion_of(loaded, document["motion"])
    values = document["parameters"]
    missing = [q.name for q in loaded.parameters if q.name not in values]
    checks.check(not missing, f"parameters without {', '.join(missing)}")
    case = Case(loaded, values, document.get("cycles", 1))
    is_bare = any(name not in entry for entry in orbits for name in StickSlip.own_numbers)
    return case if is_bare else as_in_paper(case)


def _check_mathematics(
    path: Path, document: Mapping[str, Any], what: str, scene: LoadedScene,
    *choices: Iterable[str],
) -> None:  # fmt: skip
    """Refuse what was computed with other equations than those here, by one of the choices."""
    stored = document["mathematics"]
    if stored not in {mathematics(scene, methods) for methods in choices}:
        raise FileError(path, f"{what} of other equations ({stored}): compute it anew")


def _orbit(path: Path, document: Mapping[str, Any], scene: object) -> Orbit:
    case = _case(path, document, scene, [document])
    method = generic_method(case.scene, document["method"])
    functions, order = document.get("functions"), document["order"]
    methods = [entry["method"] for entry in document.get("orbits", [document])]
    if document["schema"] > 1:  # of the first the kernels are not there: see the residual
        _check_mathematics(path, document, "an orbit", case.scene, [method], methods)
    if document.get("outcome") is None:
        raise FileError(path, "an orbit without its unknowns, from before these were written")
    outcome = document["outcome"]
    z = np.array(outcome["unknowns"], dtype=float)
    z.flags.writeable = False
    equations = kernel(case.scene, method, functions)
    size = equations.size(order)
    checks.check(len(z) == size, f"{len(z)} unknowns, expected {size}")
    checks.check(bool(np.isfinite(z).all()), "unknowns that are not finite")
    off = _off(equations, equations.given(case, order), z)
    allowed = RESIDUAL * max(1.0, float(np.abs(z).max()))
    checks.check(off <= allowed, f"an orbit that does not satisfy its equations, by {off:.1e}")
    checks.not_negative("iterations", document["iterations"])
    for name in ("iterations", "correction", "residual_norm"):
        checks.not_negative(name, outcome[name])
    restored = Outcome(**outcome | {"unknowns": z})
    orbit = case.presented(
        Orbit(case, method, order, restored, document["iterations"], functions)
    )
    durations = [phase["duration"] for phase in document["phases"]]
    checks.times(document, durations)
    checks.same("period", document["period"], orbit.period, "its unknowns")
    for duration, expected in zip(durations, orbit.durations, strict=True):
        checks.same("a duration", duration, expected, "its unknowns")
    checks.check(orbit.admissible, f"no orbit: {'; '.join(orbit.violations)}")
    return orbit


def _off(equations: Kernel, arguments: Any, z: Vector) -> float:
    """Return by how much unknowns do not satisfy equations.

    Those of a body are of its times, and its other unknowns follow from them: by how much a
    step of Newton's method changes all.
    """
    R = np.empty(len(z))
    if equations.signals is None:
        equations.residual(arguments, z, R)
    else:
        R[:] = z
        equations.iterate(arguments, R, 1)
        R -= z
    return float(np.abs(R).max())


def _sweep(path: Path, document: Mapping[str, Any], case: Case) -> Sweep:
    methods = {row["method"] for row in document["rows"]}
    _check_mathematics(path, document, "a sweep", case.scene, methods)
    rows = tuple(_row(case, row) for row in document["rows"])
    return Sweep(case, rows, document["functions"])


def _row(case: Case, row: Mapping[str, Any]) -> SweepRow:
    values = {q.name: row[q.name] for q in fields(SweepRow) if q.name in row}
    if row["status"] == "ok":
        values["further"] = {name: value for name, value in row.items() if name not in values}
    values["method"] = generic_method(case.scene, row["method"])
    order = row["order"]
    checks.check(isinstance(order, int), f"order is {order!r}, expected a whole number")
    kind = StickSlipErrors if isinstance(case, StickSlip) else Errors
    values["errors"] = _errors(row, row["errors"], kind)
    values["estimate"] = _errors(row, row["estimate"])
    checks.not_negative("seconds", row["seconds"])
    return SweepRow(**values | _checked(row))


def _family(path: Path, document: Mapping[str, Any], case: Case) -> Family:
    _check_mathematics(path, document, "a family", case.scene, [document["method"]])
    parameter, rows = _parameter(case, document["vary"]["parameter"]), []
    for row in document["rows"]:
        case.with_value(parameter, row["value"])
        values = dict(row) | {"estimate": _errors(row, row["estimate"])} | _checked(row)
        values["extremes"] = _ends(row["extremes"]) if row["status"] == "ok" else None
        rows.append(FamilyRow(**values | _multipliers(row)))
    count = document["vary"]["count"]
    checks.check(len(rows) == count > 0, f"{len(rows)} rows of {count}")
    method = generic_method(case.scene, document["method"])
    expansion = (parameter, method, document["order"], document["functions"])
    return Family(case, *expansion, tuple(rows))


def _branch(document: Mapping[str, Any], case: Case) -> Branch:
    """Return a branch from its document."""
    parameter, rows = _parameter(case, document["vary"]), []
    for point in document["points"]:
        case.with_value(parameter, point["parameter"])
        for duration in point["durations"]:
            checks.not_negative("duration", duration)
        extras = {"motion": point["motion"], "stable": point["stable"]} | _multipliers(point)
        extras["beside"] = _beside(point.get("beside"))
        times, ends = _times(point), _ends(point["extremes"])
        rows.append(FamilyRow(point["parameter"], "ok", *times, ends, None, 0, True, **extras))
    events = tuple(BranchEvent(**event) for event in document["events"])
    why = document["why_it_ended"]
    contents = tuple(rows), events, (why["start"], why["end"])
    method, order = document.get("method", "exact"), document.get("order", 0)
    return Branch(case, parameter, method, order, document.get("functions"), *contents)


def _beside(row: Mapping[str, Any] | None) -> Beside | None:
    """Return the orbit of an expansion next to an exact one."""
    if row is None:
        return None
    checks.times(row, row["durations"])
    return Beside(*_times(row), Errors(**row["errors"]))


def _map(document: Mapping[str, Any], case: Case) -> Chart:
    """Return a map from its document."""
    first, second = (_parameter(case, name) for name in document["vary"])
    values = np.array(document["axes"][first]), np.array(document["axes"][second])
    shape = len(values[1]), len(values[0])
    motion, stable = np.array(document["motion"]), np.array(document["stable"])
    for name, array in (("motion", motion), ("stable", stable)):
        problem = f"the shape of {name} is {array.shape!r}, expected {shape!r}"
        checks.check(array.shape == shape, problem)
    motions = document["motions"]
    checks.check({*motion.ravel()} - {None} == {*motions}, "motion and motions differ")
    index = np.array([[motions.index(q) if q else -1 for q in row] for row in motion])
    codes = np.array([[-1 if q is None else int(q) for q in row] for row in stable])
    curves = (
        EventCurve(q["kind"], q["motion"], np.array(q["points"]), (why["start"], why["end"]))
        for q in document["curves"]
        for why in [q["why_it_ended"]]
    )
    return Chart(case, (first, second), values, tuple(motions), index, codes, tuple(curves))


def _parameter(case: Case, name: Any) -> Any:
    """Return the name of what varies, which has to be a parameter."""
    checks.check(name in case.values, f"{name!r} varies, which is not a parameter")
    return name


def _times(row: Mapping[str, Any]) -> tuple[Any, Any, tuple[Any, ...]]:
    """Return period, phase of the forcing and durations of a row."""
    return row["period"], row["forcing_phase"], tuple(row["durations"])


def _ends(extremes: Mapping[str, Any]) -> dict[str, Any]:
    """Return the ends of displacement and velocity."""
    for name, pair in extremes.items():
        right = len(pair) == 2 and all(map(checks.is_real, pair))
        checks.check(right, f"the extremes of {name} are {pair!r}, expected two numbers")
    return {name: tuple(pair) for name, pair in extremes.items()}


def _multipliers(row: Mapping[str, Any]) -> dict[str, Any]:
    """Return multipliers and strobe of a row; files from before these have none."""
    pairs = row.get("multipliers")
    values = pairs and tuple(complex(pair["re"], pair["im"]) for pair in pairs)
    strobe = row.get("strobe")
    return {"multipliers": values, "strobe": strobe and tuple(strobe)}


def _checked(row: Mapping[str, Any]) -> dict[str, Any]:
    """Return the durations of a row; what cannot be right is refused."""
    problem = f"status is {row['status']!r}, expected one of {STATUS}"
    checks.check(row["status"] in STATUS, problem)
    checks.not_negative("iterations", row["iterations"])
    if row["status"] != "ok":
        why = row.get("message")
        checks.check(
            isinstance(why, str), f"message is {why!r}, expected why there is no orbit"
        )
        return {"durations": None, "period": None}
    checks.times(row, row["durations"])
    return {"durations": tuple(row["durations"])}


def _errors(
    row: Mapping[str, Any], errors: Mapping[str, Any], kind: type[Errors] = Errors
) -> Errors | None:
    """Return errors; None without an orbit, or where nothing is known of them."""
    values = [errors.get(field.name) for field in fields(kind)]
    if row["status"] != "ok" or all(value is None for value in values):
        return None
    for name in ("times", "discontinuous"):
        checks.not_negative(name, errors[name])
    return kind(*(float("inf") if value is None else value for value in values))
