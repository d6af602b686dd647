"""Integrals that a kernel tabulates: a value for each index, and the derivative by each time.

The one integral of all expansions is the moment of a shifted Legendre polynomial,

    mu_l(kappa, theta) = int_0^1 P_l*(u) cos(kappa u + theta) du
                       = Re[i^l exp(i (theta + kappa/2))] j_l(kappa/2),

with the spherical Bessel function j_l.  Its derivatives stay in the family:

    d mu_l/d theta = mu_l(kappa, theta + pi/2),
    d mu_l/d kappa = [mu_l + ((l + 1) mu_(l+1) + l mu_(l-1))/(2 l + 1)](kappa, theta + pi/2)/2.
"""

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass

import sympy as sp

from ..python_text import python
from .weights import weights

l = sp.Symbol("l", integer=True, nonnegative=True)


#: The derivative of an entry by a time.
Rate = Callable[[tuple[sp.Expr, ...], sp.Symbol], sp.Expr]

#: An entry in closed form, by its index.
Known = Callable[[sp.Expr], sp.Expr | None]


@dataclass(frozen=True)
class Table:
    """One table of a kernel.

    Parameters
    ----------
    base : IndexedBase
        Its name.
    rate : callable
        ``rate(indices, time)``: the derivative of the entry, in entries of tables.
    fill : str
        What makes it, in Python, with `N` for the order.
    prepare : str
        A statement before that, which several tables may share.
    definition : Expr, optional
        What an entry is, in the index `l`, for the reader.
    known : callable, optional
        ``known(index)``: the entry in closed form, with a `KroneckerDelta` of two indices
        where it vanishes but for equal ones; None if this entry is looked up.
    """

    base: sp.IndexedBase
    rate: Rate
    fill: str
    prepare: str = ""
    definition: sp.Expr | None = None
    known: Known | None = None


class Moment(sp.Function):  # type: ignore[misc]
    """``mu_l(kappa, theta)``, unevaluated, for printing."""

    nargs = 3


def moment_rate(
    even: sp.IndexedBase, odd: sp.IndexedBase, kappa: sp.Expr, theta: sp.Expr
) -> tuple[Rate, Rate]:
    """Return the derivatives of ``mu_l(kappa, theta)`` and of it a quarter turn on.

    The first index of the tables is the degree; `kappa` and `theta` may have the others.
    """

    def rate_of(other: sp.IndexedBase, sign: int) -> Rate:
        def rate(indices: tuple[sp.Expr, ...], time: sp.Symbol) -> sp.Expr:
            degree, *rest = indices
            near = (degree + 1) * other[(degree + 1, *rest)]
            if degree != 0:
                near += degree * other[(degree - 1, *rest)]
            stretch = sign * (other[indices] + near / (2 * degree + 1)) / 2
            turn = sign * other[indices]
            return sp.diff(kappa, time) * stretch + sp.diff(theta, time) * turn

        return rate

    return rate_of(odd, 1), rate_of(even, -1)


def moment_tables(
    name: str, kappa: sp.Expr, theta: sp.Expr, length: str
) -> tuple[Table, Table]:
    """Return the tables of ``mu_l(kappa, theta)`` and ``mu_l(kappa, theta + pi/2)``.

    Parameters
    ----------
    name : str
        What the names end in.
    kappa, theta : Expr
        In the parameters and the unknown times.
    length : str
        Number of entries, in Python.
    """
    even, odd = sp.IndexedBase(f"mu_{name}"), sp.IndexedBase(f"nu_{name}")
    rates = moment_rate(even, odd, kappa, theta)
    prepare = f"over_{name} = legendre_moments({length}, {python(kappa)}, {python(theta)})"
    tables = []
    for row, (base, rate) in enumerate(zip((even, odd), rates, strict=True)):
        turned = theta + row * sp.pi / 2
        meaning = Moment(l, kappa, turned)
        tables.append(Table(base, rate, f"over_{name}[{row}]", prepare, definition=meaning))
    return tables[0], tables[1]


def tables_with_rates(
    name: str,
    durations: Sequence[sp.Symbol],
    source: str,
    prepare: str,
    known: Known | None = None,
) -> Iterator[Table]:
    """Yield a table that is computed with its derivatives by the durations, and those.

    Parameters
    ----------
    name : str
        Of the table; its derivatives have ``_by_<duration>`` behind it.
    durations : sequence of Symbol
    source : str
        What holds them in a kernel: the values first, then their derivatives.
    prepare : str
        The statements that make `source`; `rates` in them is whether derivatives are wanted.
    known : callable, optional
        See `Table`.
    """
    rates = {s: sp.IndexedBase(f"{name}_by_{s}") for s in durations}

    def rate(indices: tuple[sp.Expr, ...], time: sp.Symbol) -> sp.Expr:
        return rates[time][indices] if time in rates else sp.Integer(0)

    yield Table(sp.IndexedBase(name), rate, f"{source}[0]", prepare, known=known)
    for q, base in enumerate(rates.values()):
        yield Table(base, lambda indices, time: sp.Integer(0), f"{source}[{1 + q}]", prepare)


def by_time(expression: sp.Expr, time: sp.Symbol, tables: Iterable[Table]) -> sp.Expr:
    """Return the derivative by an unknown time, through what the tables hold as well."""
    looked_up = {table.base: table for table in tables}
    entries = {q for q in expression.atoms(sp.Indexed) if q.base in looked_up}
    total = sp.S.Zero
    for entry, weight in weights(expression, entries).items():
        total += sp.diff(weight, time) * entry
        if entry in entries:
            total += weight * looked_up[entry.base].rate(entry.indices, time)
    return total
