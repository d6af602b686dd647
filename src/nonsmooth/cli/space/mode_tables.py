"""Tables of modes, at most 80 columns wide, and what stands above and below them."""

import math
from collections.abc import Iterator, Sequence
from fractions import Fraction

from nonsmooth.solver.space.attached import Attached
from nonsmooth.solver.space.convergence import Convergence
from nonsmooth.solver.space.mode import Mode
from nonsmooth.solver.space.modes import Modes
from nonsmooth.solver.space.structure import Structure

from ..columns import Piece, filled, filled_parameters, table_of
from ..values import Vary


def _caption(attached: Attached, varied: str = "") -> str:
    """Return the structure with its class, and its parameters but for what is varied."""
    structure = attached.structure
    head = f"{structure.name}: {structure.title} (C{structure.k})"
    return f"{head}\n{filled_parameters(attached.described(varied))}\n"


def modes(expansions: Sequence[Modes]) -> Iterator[Piece]:
    """Show the modes by each expansion, a mode after the other, beside the exact ones."""
    yield _caption(expansions[0].attached)
    several = len(expansions) > 1
    table = table_of(
        "mode", *(["method", "f [Hz]"] if several else ["f [Hz]", "f_ex [Hz]"]),
        "omega [rad/s]", "f/f_ex-1", "proved", "jump law", "node",
    )  # fmt: skip
    for place in range(max(map(len, expansions))):
        with_mode = [expansion for expansion in expansions if place < len(expansion)]
        exact = f"{with_mode[0][place].exact_frequency:.9g}"
        for expansion in with_mode:
            mode = expansion[place]
            f, *cells = _cells(mode)
            names = [expansion.shown, f] if several else [f, exact]
            table.add_row(str(mode.number), *names, *cells)
        if several:
            omega = f"{2 * math.pi * with_mode[0][place].exact_frequency:.9g}"
            table.add_row(str(place + 1), "exact", exact, omega, "", "", "", "")
    for expansion in expansions:
        yield f"{expansion.shown}, N = {expansion.order}: {expansion.unknowns} unknowns"
    yield ""
    yield table
    yield f"\n{_legend(expansions[0].structure)}"


def _cells(mode: Mode) -> list[str]:
    proved = mode.proved_within
    return [
        f"{mode.frequency:.9g}",
        f"{mode.omega:.9g}",
        f"{mode.error:.1e}",
        "" if proved is None else f"{proved:.1e}",
        _law(mode.jump_mismatch),
        "" if mode.node is None else f"n = {mode.node}",
    ]


def _law(mismatch: float | None) -> str:
    if mismatch is None:
        return ""
    return "no jump" if mismatch == -1 else f"{mismatch:.1e}"


def _legend(structure: Structure) -> str:
    """Return what the headings mean."""
    broken, felt = _primes(structure.broken), _primes(structure.felt)
    law = f"s lambda {felt}" if structure.kind == "inertia" else f"s {felt}"
    negative = structure.jump * (-1 if structure.kind == "stiffness" else 1) < 0
    sign = "-" if negative else ""
    parts = [
        "f_ex: the exact frequency",
        "proved: how far f can be off, by bounds on both sides that do not know it",
        f"jump law: [{broken}]/({sign}{law}) - 1 at the attachment",
        "node: the mode is sin(n pi x/L), which the attachment does not feel",
    ]
    return filled("; ".join(parts) + ".")


def _primes(derivative: int) -> str:
    return "u" + "'" * derivative


def convergence(study: Convergence) -> Iterator[Piece]:
    """Show one row an expansion and order of a mode, and the rates."""
    structure = study.attached.structure
    yield _caption(study.attached)
    yield f"mode {study.number}\n"
    names = {(line.method, line.forced): line.name(study.attached) for line in study.lines}
    table = table_of(
        "method", "N", "unknowns", "omega [rad/s]", "lam/lam_ex-1", "u",
        _primes(structure.broken), "jump law",
    )  # fmt: skip
    for row in study.rows:
        head = (names[row.method, row.forced], str(row.order), str(row.unknowns))
        if row.beta is None:
            table.add_row(*head, "no such mode", "", "", "", "")
            continue
        omega = row.beta**structure.m * study.attached.frequency_unit
        table.add_row(
            *head,
            f"{omega:.9g}",
            f"{row.eigenvalue_error:.1e}",
            f"{row.shape:.1e}",
            f"{row.discontinuous:.1e}",
            _law(row.jump_mismatch),
        )
    yield table
    yield "\nPower of N in the error of lambda, fitted from N = 4 on above rounding:\n"
    rates = table_of("method", "fitted", "expected")
    for line in study.lines:
        fitted, expected = study.rate(line), study.expected(line)
        rates.add_row(
            line.name(study.attached),
            "" if fitted is None else f"{fitted:.2f}",
            _expected(line.method, expected),
        )
    yield rates


def _expected(method: str, expected: int | None) -> str:
    if expected is not None:
        return str(expected)
    return "faster than any" if method == "ck" else "none: it does not converge"


def family(
    attached: Attached, vary: Vary[Fraction], how: str, values: Sequence[str],
    expansions: Sequence[Modes],
) -> Iterator[Piece]:  # fmt: skip
    """Show the angular frequencies of the modes, a row a value of a parameter."""
    yield _caption(attached, vary.parameter)
    yield f"{vary.flag} varies; {how}; omega in rad/s\n"
    count = max(map(len, expansions))
    table = table_of(vary.flag, *(f"omega_{i + 1}" for i in range(count)), "off at most")
    for value, expansion in zip(values, expansions, strict=True):
        error = max(abs(mode.error) for mode in expansion)
        table.add_row(value, *(f"{mode.omega:.8g}" for mode in expansion), f"{error:.1e}")
    yield table
