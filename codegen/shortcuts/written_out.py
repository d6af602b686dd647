"""A method written out at one order: every sum carried out, every unknown by its name.

Input: the record of a method and a small ``N``.  Output: its conditions as numbered
statements with the abbreviations they need, or as equations in the unknowns alone.
"""

import operator
from collections.abc import Iterable, Iterator

import sympy as sp

from ..system import Equation, GalerkinSystem
from .paper.inner_product import C, N, S
from .paper.oscillator import PARAMETERS, UNKNOWN_TIMES, M, omega_n

#: Beyond, nobody reads it: (6) and (7) alone are 2 N equations of 2 N + 3 terms or more.
HIGHEST_ORDER = 5

#: The stiffness as a parameter of its own; the records have it as ``M omega_n**2``.
K = sp.Symbol("K", positive=True)

#: What the records have in place of parameters of the oscillator, in these.
IN_PARAMETERS = {
    omega_n: sp.sqrt(K / M),
    **{name: value.subs(omega_n, sp.sqrt(K / M)) for name, value in PARAMETERS.items()},
}

#: The equations that are solved, in the order in which the kernels have them.
CONDITIONS = ("5", "6", "7", "14", "18", "9", "10", "19", "20")


def check_order(order: object) -> int:
    """Return `order` as an int.

    Raises
    ------
    ValueError
        If it is not a whole number from 1 to 5.
    """
    try:
        number = 0 if isinstance(order, bool) else operator.index(order)  # type: ignore[arg-type]
    except TypeError:
        number = 0
    if not 1 <= number <= HIGHEST_ORDER:
        raise ValueError(
            f"order: got {order!r}, expected a whole number from 1 to {HIGHEST_ORDER}: "
            "written out, the equations grow with the square of N, and beyond they fill "
            "pages; without sums written out they hold for any N"
        )
    return number


def check_method(system: GalerkinSystem) -> None:
    """Check that a record is in the paper's unknowns.

    Raises
    ------
    ValueError
        If it is in others, such as those about mid-stick.
    """
    if not system.coefficients:
        raise ValueError(
            f"method: got {system.method!r}, expected hb, hb-c1 or c1: only the unknowns of "
            "the paper are written out"
        )


def _index(expression: sp.Expr) -> sp.Symbol | None:
    """Return the free index of `expression`, if it has one."""
    return next((q for q in expression.free_symbols if q.is_integer and q != N), None)


def _values(expression: sp.Expr, order: int) -> Iterator[tuple[dict[sp.Symbol, int], sp.Expr]]:
    """Yield `expression` with its sums carried out, for each value of its index."""
    index = _index(expression)
    if index is None:
        yield {}, _summed(expression, order)
        return
    for value in range(1 if index.is_positive else 0, order + 1):
        yield {index: value}, _summed(expression.subs(index, value), order)


def _summed(expression: sp.Expr, order: int) -> sp.Expr:
    """Return `expression` at one order; ``C_-k = C_k``, ``S_-k = -S_k``, ``S_0 = 0``."""
    done = expression.subs(N, order).doit()
    known = {}
    for entry in done.atoms(sp.Indexed):
        k = entry.indices[0]
        if entry.base == S and k <= 0:
            known[entry] = -S[-k] if k < 0 else sp.Integer(0)
        elif entry.base == C and k < 0:
            known[entry] = C[-k]
    return done.xreplace(known)


def unknowns(system: GalerkinSystem, order: int) -> tuple[sp.Expr, ...]:
    """Return the unknowns at one order: the paper's coefficients, ``t1`` and ``T``.

    Raises
    ------
    ValueError
        If the record is in others.

    Examples
    --------
    >>> from .. import derive
    >>> unknowns(derive("c1"), 2)
    (d[0], d[1], d[2], t1, T)
    """
    check_method(system)
    coefficients = (
        value for symbol in system.coefficients for _, value in _values(symbol, order)
    )
    return (*coefficients, *UNKNOWN_TIMES)


def conditions(system: GalerkinSystem, order: int) -> tuple[Equation, ...]:
    """Return the conditions at one order, as many as there are unknowns.

    Raises
    ------
    ValueError
        If the record is not in the paper's unknowns.
    """
    check_method(system)
    rows = []
    for number in CONDITIONS:
        if number not in {equation.number for equation in system.equations}:
            continue
        shown = system.equation(number)
        *_, closed, right = shown.sides
        for at, left in _values(closed, order):
            where = ", ".join(f"{index} = {value}" for index, value in at.items())
            rows.append(Equation(number, shown.title, (left, right), where))
    return tuple(rows)


def _definitions(system: GalerkinSystem, order: int) -> dict[sp.Expr, Equation]:
    """Return the statements of the record that define something, at every index."""
    rows = [
        (row, _index(row.sides[0]) or _index(row.sides[-1]))
        for row in system.equations
        if not row.number and isinstance(row.sides[0], sp.Symbol | sp.Indexed)
    ]
    # z, the half angle of harmonic k, is a name without the index that it depends on.
    silent = {row.sides[0]: index for row, index in rows if index and row.sides[0].is_Symbol}
    indexed = {name: sp.IndexedBase(name.name)[index] for name, index in silent.items()}
    found: dict[sp.Expr, Equation] = {}
    for row, index in rows:
        name, right = (side.xreplace(indexed) for side in (row.sides[0], row.sides[-1]))
        for value in range(1, 2 * order + 1) if index else (0,):
            at = {index: value} if index else {}
            found[name.subs(at)] = Equation("", row.title, (name.subs(at), right.subs(at)))
    return found


def abbreviations(
    system: GalerkinSystem, order: int, rows: Iterable[Equation]
) -> tuple[Equation, ...]:
    """Return the definitions of all that `rows` abbreviate, in the order of the record."""
    known = _definitions(system, order)
    used: set[sp.Expr] = set()
    pending = [side for row in rows for side in row.sides]
    while pending:
        for name in (pending.pop().atoms(sp.Symbol, sp.Indexed) & known.keys()) - used:
            used.add(name)
            pending.extend(known[name].sides)
    return tuple(row for name, row in known.items() if name in used)


def expanded(system: GalerkinSystem, order: int) -> tuple[sp.Eq, ...]:
    """Return the conditions at one order in the unknowns and the parameters alone.

    The parameters are ``M``, ``K``, ``V``, ``mu_s``, ``mu_k``, ``F_N``.  Spherical Bessel
    functions are written by sines and cosines.
    """
    order = check_order(order)
    rows = conditions(system, order)
    values = dict(row.sides for row in abbreviations(system, order, rows))

    def in_unknowns(side: sp.Expr) -> sp.Expr:
        while side.atoms(sp.Symbol, sp.Indexed) & values.keys():
            side = side.xreplace(values)
        return sp.expand_func(side.xreplace(IN_PARAMETERS))

    return tuple(sp.Eq(*map(in_unknowns, row.sides), evaluate=False) for row in rows)
