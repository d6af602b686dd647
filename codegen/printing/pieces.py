"""Cut a long expression where a line may be broken, for every format alike.

Input: one side of an equation, and what counts as too wide.  Output: its pieces, in order:
whole terms, and where a term by itself is too wide, the terms inside its bracket.
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache

import sympy as sp

from .order import led_by_a_plus, terms

#: A bracket that is a smaller part of its term than one in so many is not opened.
LEAST = 3


@dataclass(frozen=True)
class Piece:
    """A term that is not cut, with the brackets that open before and close behind it.

    Parameters
    ----------
    term : Expr
        The term itself.
    opens : tuple of Expr
        What each bracket that opens here belongs to: a factor, or a sum, for its sign.
    closes : str
        The brackets that close here.
    first : bool
        Whether it is the first of its side, where no plus is due.
    times : bool
        Whether it is a sum that multiplies the piece before it: then it has its own brackets.
    """

    term: sp.Expr
    opens: tuple[sp.Expr, ...] = ()
    closes: str = ""
    first: bool = False
    times: bool = False


def _terms(side: sp.Expr) -> list[sp.Expr]:
    """Return the terms in the order shown, those of ``a_1, a_2, ...`` last and by number."""
    if not isinstance(side, sp.Add):
        return [side]
    ordered = sorted(terms(side), key=_coefficient)
    without = [term for term in ordered if not _coefficient(term)[0]]
    return [*led_by_a_plus(without), *ordered[len(without) :]]


def _coefficient(term: sp.Expr) -> tuple[str, int]:
    """Return name and number of the coefficient in `term`; tables of integrals are none."""
    for factor in sp.Mul.make_args(term):
        if isinstance(factor, sp.Indexed) and factor.is_real and factor.indices[0].is_Integer:
            return str(factor.base), int(factor.indices[0])
    return "", 0


def _bracket(term: sp.Expr) -> tuple[sp.Expr, sp.Expr | None]:
    """Return what stands before the bracket of `term`, and what is inside, if it has one."""
    if isinstance(term, sp.Sum):
        return term, term.function
    sums = [factor for factor in term.args if isinstance(factor, sp.Add)]
    if not isinstance(term, sp.Mul) or not sums:
        return term, None
    inside = max(sums, key=lambda factor: len(_spelled(factor)))
    before = sp.Mul(*(factor for factor in term.args if factor is not inside))
    return before, None if isinstance(before, sp.Add) else inside


def _cut(side: sp.Expr, too_wide: Callable[[sp.Expr], bool]) -> Iterator[Piece]:
    for term in _terms(side):
        before, inside = _bracket(term)
        if inside is None or not too_wide(term):
            yield Piece(term)
        elif _is_short(inside, term):
            yield from (Piece(before), Piece(inside, times=True))
        else:
            yield from _opened(before, list(_cut(inside, too_wide)))


def _is_short(inside: sp.Expr, term: sp.Expr) -> bool:
    """Whether a bracket is so short a part of a product that no line is broken inside it."""
    short = LEAST * len(_spelled(inside)) < len(_spelled(term))
    return isinstance(term, sp.Mul) and short and "/" not in _spelled(inside)


@lru_cache(maxsize=1024)  # a side is cut again for each width that is tried
def _spelled(expression: sp.Expr) -> str:
    return str(expression)


def _opened(before: sp.Expr, parts: list[Piece]) -> list[Piece]:
    """Return the pieces in a bracket, with what stands before it and the bracket itself."""
    parts[0] = replace(parts[0], opens=(before, *parts[0].opens))
    bracket = {"": "", "[": "]", "(": ")"}[bracket_of(before)]
    parts[-1] = replace(parts[-1], closes=parts[-1].closes + bracket)
    return parts


def bracket_of(before: sp.Expr) -> str:
    """Return the bracket that opens behind a factor or the sign of a sum.

    Examples
    --------
    >>> x, n = sp.symbols("x n")
    >>> [bracket_of(q) for q in (x, sp.Sum(n + x, (n, 0, 1)), sp.Sum(n * x, (n, 0, 1)))]
    ['(', '[', '']
    """
    if not isinstance(before, sp.Sum):
        return "("
    return "[" if isinstance(before.function, sp.Add) else ""


def pieces(side: sp.Expr, too_wide: Callable[[sp.Expr], bool]) -> list[Piece]:
    """Return `side` as pieces: its terms, and those in the bracket of a term too wide.

    Examples
    --------
    >>> x, y = sp.symbols("x y")
    >>> [str(piece.term) for piece in pieces(y + x**2, lambda term: False)]
    ['x**2', 'y']
    >>> [(piece.opens, piece.closes) for piece in pieces(x * (x + y), lambda term: True)]
    [((x,), ''), ((), ')')]
    >>> wide = pieces(sp.sin(x) ** 9 * sp.cos(x) * (y + 1), lambda term: True)
    >>> [(str(piece.term), piece.times) for piece in wide]
    [('sin(x)**9*cos(x)', False), ('y + 1', True)]
    """
    head, *following = _cut(side, too_wide)
    return [replace(head, first=True), *following]


def signed(term: sp.Expr, first: bool) -> tuple[str, sp.Expr]:
    """Return the sign that is due before `term`, and `term` without it.

    Examples
    --------
    >>> signed(-2 * sp.Symbol("x"), first=False)
    ('-', 2*x)
    """
    if isinstance(term, sp.Add | sp.Sum) or not term.could_extract_minus_sign():
        return "" if first else "+", term
    coefficient, factors = term.as_coeff_mul(rational=False)
    if coefficient != -1:
        factors = (-coefficient, *factors)
    return "-", sp.Mul(*factors, evaluate=False)


def filled(widths: Sequence[int], limit: int) -> list[slice]:
    """Return which pieces go on which line, as many on each as fit.

    Examples
    --------
    >>> filled([3, 3, 3], 7)
    [slice(0, 2, None), slice(2, 3, None)]
    """
    starts, length = [0], 0
    for position, width in enumerate(widths):
        if length and length + width > limit:
            starts.append(position)
            length = 0
        length += width
    return [slice(*ends) for ends in zip(starts, [*starts[1:], len(widths)], strict=True)]
