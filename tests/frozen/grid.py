"""The commands whose numbers are frozen, and what each of them says today.

Numbers are hexadecimal, so that a last bit counts; seconds are left out.
"""

import json
from collections.abc import Callable, Iterator
from typing import Any

import nonsmooth as ns
from nonsmooth.cli.shortcuts.digits import document as digits
from nonsmooth.cli.shortcuts.roots import _rows as roots
from nonsmooth.files.shortcuts.documents import of_solution, of_sweep
from nonsmooth.shortcuts.digits import cells, measure
from nonsmooth.solver.no_orbit import NoOrbit
from nonsmooth.solver.shortcuts.orbit.oscillator import DEFAULT

METHODS = ("hb", "hb-c1", "c1")
ALPHAS = (0.01, 0.1, 0.3, 1.0, 3.0, 10.0, 30.0)
ORDERS = (1, 3, 7, 12, 20, 40)

#: What is the same for every orbit: stick forgets perturbations.
CONSTANT = ("multipliers", "stable")

Row = dict[str, Any]


def oscillator(alpha: float, mass: float = 1.0, time: float = 1.0) -> ns.StickSlip:
    """Return an oscillator of this alpha, the units of mass and time being so many SI units."""
    return ns.StickSlip(
        mass=10 * mass,
        stiffness=1000 * mass / time**2,
        belt_speed=1 / time,
        mu_s=0.5,
        mu_k=0.25,
        normal_force=400 * alpha * mass / time**2,
    )


def _solution(belt: ns.StickSlip, method: str, order: int, **options: Any) -> Row:
    try:
        found: ns.Orbit | NoOrbit = ns.solve(belt, method, order, **options)
    except NoOrbit as finding:
        found = finding
    row = of_solution(belt, method, order, found)
    return {name: value for name, value in row.items() if name not in CONSTANT}


def solved() -> Iterator[Row]:
    """Yield one orbit for each method, alpha and order."""
    for method in METHODS:
        for alpha in ALPHAS:
            for order in ORDERS:
                yield _solution(oscillator(alpha), method, order)


def with_many_functions() -> Iterator[Row]:
    """Yield Section 3.2 with one to six C1 functions."""
    for terms in range(1, 7):
        for order in (5, 12):
            yield _solution(DEFAULT, "hb-c1", order, c1_terms=terms)


def with_many_harmonics() -> Iterator[Row]:
    """Yield series beyond the dense matrix, without their tens of thousands of numbers."""
    for method in ("hb", "hb-c1"):
        for order in (300, 20_000):
            row = _solution(DEFAULT, method, order)
            del row["outcome"], row["coefficients"]
            yield row


def in_other_units() -> Iterator[Row]:
    """Yield the default oscillator in units of 1e-12 and 1e12."""
    for method in METHODS:
        for mass, time in ((1e-12, 1.0), (1e12, 1.0), (1.0, 1e-12), (1.0, 1e12)):
            yield _solution(oscillator(1.0, mass, time), method, 10)


def swept() -> Iterator[Row]:
    """Yield a sweep over orders, and its rates."""
    yield of_sweep(ns.sweep(DEFAULT, METHODS, range(1, 16)))


def varied() -> Iterator[Row]:
    """Yield the orbits along the belt's speed, a row each."""
    speeds = [0.1 * 10 ** (i / 6) for i in range(13)]
    for method, order in (("c1", 24), ("c1", 7), ("hb", 20), ("hb-c1", 20)):
        family = ns.family(DEFAULT, "belt_speed", speeds, method, order)
        names = family.points.dtype.names
        for point in family.points:
            yield {
                "method": method,
                "order": order,
                **dict(zip(names, point.item(), strict=True)),
            }


def all_roots() -> Iterator[Row]:
    """Yield every real solution of Section 3.3 at some orders."""
    for alpha in (0.25, 1.0, 4.0):
        for order in (3, 4, 7, 8):
            yield {"alpha": alpha, "order": order, "roots": roots(oscillator(alpha), order)}


def digits_kept() -> Iterator[Row]:
    """Yield `digits --quick`."""
    yield digits(measure(cells(quick=True), lambda _: None))


#: What is frozen, by the name of its file.
GRIDS: dict[str, Callable[[], Iterator[Row]]] = {
    "solve": solved,
    "c1_terms": with_many_functions,
    "harmonics": with_many_harmonics,
    "units": in_other_units,
    "sweep": swept,
    "vary": varied,
    "roots": all_roots,
    "digits": digits_kept,
}


def exactly(value: Any) -> Any:
    """Return a document with its numbers in hexadecimal, without seconds."""
    if isinstance(value, float):
        return value.hex()
    if isinstance(value, dict):
        return {key: exactly(item) for key, item in value.items() if key != "seconds"}
    if isinstance(value, (list, tuple)):
        return [exactly(item) for item in value]
    if hasattr(value, "tolist"):
        return exactly(value.tolist())
    return value


def text(name: str) -> str:
    """Return what the program says today, a row a line."""
    rows = [json.dumps(exactly(row), sort_keys=True) for row in GRIDS[name]()]
    return "[\n" + ",\n".join(rows) + "\n]\n"
