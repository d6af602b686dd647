"""The oscillator from a case file, from flags, or both; flags override the file."""

from collections.abc import Callable, Mapping
from difflib import get_close_matches
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from ..case_files import read_case
from ..problems import Problem

if TYPE_CHECKING:
    from nonsmooth.solver.shortcuts.orbit.oscillator import StickSlip

#: Flags, with what their help says.
FLAGS = {
    "mass": "M in kg",
    "stiffness": "K in N/m",
    "belt_speed": "V in m/s",
    "mu_s": "static friction coefficient",
    "mu_k": "kinetic friction coefficient, 0 <= mu_k < mu_s",
    "normal_force": "F_N in N",
}

#: Table of a case file.
TABLE = "stick_slip"

CHOICE = "F_N = 400 N is assumed; the paper does not give it (see `nonsmooth report`)."


def parameter_options(command: Callable[..., Any]) -> Callable[..., Any]:
    """Add ``--case`` and one flag a parameter to a command."""
    for name, help_ in reversed(FLAGS.items()):
        flag = f"--{name.replace('_', '-')}"
        command = click.option(flag, name, type=float, help=help_)(command)
    help_ = "Case file with a table [stick_slip]; flags override it."
    return click.option("--case", type=click.Path(path_type=Path), help=help_)(command)


def _case_errors(table: Mapping[str, object], given: Mapping[str, object]) -> list[str]:
    """Return the keys that a case file has too many or too few."""
    errors = []
    for key in table.keys() - FLAGS.keys():
        close = get_close_matches(key, FLAGS, n=1)
        hint = f", did you mean {close[0]}?" if close else ""
        errors.append(f"{key}: unknown key{hint}")
    errors.extend(
        f"{key}: missing, expected {FLAGS[key]}"
        for key in FLAGS
        if key not in table and key not in given
    )
    return sorted(errors)


def belt_from(case: Path | None, flags: Mapping[str, float | None]) -> "StickSlip":
    """Return the oscillator that the command line describes.

    Without a case file, what no flag gives is the default case.

    Raises
    ------
    Problem
        With all mistakes at once.
    """
    from dataclasses import asdict  # noqa: PLC0415

    from nonsmooth.solver.case.parameters import ParameterError  # noqa: PLC0415
    from nonsmooth.solver.shortcuts.orbit.oscillator import DEFAULT, StickSlip, parameter_errors  # noqa: PLC0415

    given = {name: value for name, value in flags.items() if value is not None}
    if case is None:
        parameters: dict[str, Any] = asdict(DEFAULT) | given
        structure: list[str] = []
    else:
        table = read_case(case, (TABLE,))
        structure = _case_errors(table, given)
        parameters = {key: value for key, value in table.items() if key in FLAGS} | given
    errors = structure + parameter_errors(parameters)
    where = f"{case}: " if case else ""
    if errors:
        raise Problem(where + errors[0], below=errors[1:])
    try:
        return StickSlip(**parameters)
    except ParameterError as error:
        raise Problem(f"{where}{error}") from error


def caption(belt: "StickSlip") -> str:
    """Return one line on the oscillator, and who chose F_N."""
    from nonsmooth.solver.shortcuts.orbit.oscillator import DEFAULT  # noqa: PLC0415

    line = (
        f"M = {belt.mass:g} kg, K = {belt.stiffness:g} N/m, V = {belt.belt_speed:g} m/s, "
        f"mu_s = {belt.mu_s:g}, mu_k = {belt.mu_k:g},\nF_N = {belt.normal_force:g} N; "
        f"alpha = omega_n (mu_s - mu_k) F_N / (K V) = {belt.alpha:.6g}"
    )
    return f"{line}\n{CHOICE}\n" if belt == DEFAULT else f"{line}\n"
