"""``nonsmooth solve --digits N``: period and end of stick in many digits."""

from dataclasses import asdict
from typing import TYPE_CHECKING, Any

import click

from ..flint import need_flint
from ..problems import Problem

if TYPE_CHECKING:
    from nonsmooth.solver.no_orbit import NoOrbit
    from nonsmooth.solver.shortcuts.orbit.orbit import Orbit


#: Most harmonics that are refined: the matrix is dense.
MOST_REFINED = 2000


def check_digits(digits: int | None, order: int) -> None:
    """Check the number of digits, and the order that is to have them, before the work.

    Raises
    ------
    Problem
        If it is out of range, or python-flint is missing.
    """
    if digits is None:
        return
    need_flint("--digits")
    from nonsmooth.shortcuts.twin import FEWEST, MOST  # noqa: PLC0415

    if not FEWEST <= digits <= MOST:
        expected = f"a whole number from {FEWEST} to {MOST}"
        raise Problem(f"--digits: got {digits}, expected {expected}")
    if order > MOST_REFINED:
        raise Problem(f"--order: got {order}, expected at most {MOST_REFINED} with --digits")


def add_precise(document: dict[str, Any], found: "Orbit | NoOrbit", digits: int) -> None:
    """Add ``precise`` to the document of an orbit: its numbers as decimal strings."""
    from nonsmooth.shortcuts.twin import PrecisionError, precise  # noqa: PLC0415
    from nonsmooth.solver.shortcuts.orbit.orbit import Orbit  # noqa: PLC0415

    if not isinstance(found, Orbit):
        document["precise"] = None
        return
    try:
        result = asdict(precise(found, digits))
    except PrecisionError as error:
        raise Problem(str(error), status=1) from error
    errors = {name: result.pop(f"error_{name}") for name in ("period", "t1")}
    document["precise"] = result | {"errors": errors}


def show_precise(documents: list[dict[str, Any]]) -> None:
    """Print the digits, a number a line."""
    for document in documents:
        numbers = document["precise"]
        if numbers is None:
            continue
        click.echo(
            f"\n{document['method']}, N = {document['order']}, {numbers['digits']} digits"
        )
        click.echo(f"  T  [s] = {numbers['period']}")
        click.echo(f"  t1 [s] = {numbers['t1']}")
        click.echo(f"  T/T_ex - 1   = {numbers['errors']['period']}")
        click.echo(f"  t1/t1_ex - 1 = {numbers['errors']['t1']}")
