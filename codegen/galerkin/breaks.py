"""Functions with one break: smooth over a cell but for one derivative at one switch.

For a switch at ``t_p``, ``beta_n(t - t_p)`` has a jump in its derivative of order n - 1 alone.
With ``u = (t - t_p)/T_c`` on the cell that begins at the switch,

    beta_n = -B_n(u)/n!                    where the motion repeats after a cell,
    beta_n = E_(n-1)(u)/(2 (n - 1)!)       where it repeats with the opposite sign,

with the polynomials of Bernoulli and Euler; the jump is 1 by u, and
``d beta_n/dt = beta_(n-1)/T_c``.  On a phase that begins at the part `begin` of that cell and
lasts `length` of it, it is a polynomial of degree n: a short series of shifted Legendre
polynomials, with coefficients in closed form in `begin` and `length`, whatever the scene.
"""

import sympy as sp

from .legendre import in_legendre

#: Local time of a phase; where it begins and how long it is, as parts of the cell.
_w = sp.Symbol("w", real=True)
begin, length = sp.symbols("begin length", real=True)


def beta(n: int, u: sp.Expr, sign: int) -> sp.Expr:
    """Return ``beta_n`` at ``u`` from 0 to 1."""
    if sign == 1:
        return -sp.bernoulli(n, u) / sp.factorial(n) if n else sp.Integer(-1)
    return sp.euler(n - 1, u) / (2 * sp.factorial(n - 1)) if n else sp.Integer(0)


def on_phase(n: int, sign: int) -> tuple[sp.Expr, ...]:
    """Return the Legendre coefficients of ``beta_n(begin + length w)``, w from 0 to 1."""
    on_cell = sp.expand(beta(n, begin + length * _w, sign))
    found = in_legendre(on_cell, _w)
    return tuple(sp.horner(coefficient, wrt=begin) for coefficient in found)


def series(highest: int, sign: int) -> tuple[tuple[sp.Expr, ...], ...]:
    """Return the coefficients of ``beta_0, ..., beta_highest``, each filled up with zeros."""
    rows = (on_phase(n, sign) for n in range(highest + 1))
    return tuple(row + (sp.Integer(0),) * (highest + 1 - len(row)) for row in rows)
