"""The order in which terms and factors are shown: that of the paper, for every format alike.

SymPy's own order puts functions before coefficients and ``omega^2 x`` before ``x''``.
"""

import sympy as sp
from sympy.core.function import AppliedUndef


def terms(total: sp.Expr) -> list[sp.Expr]:
    """Return the terms of a sum: higher derivatives first, and no minus in front.

    Unless every term has one.

    Examples
    --------
    >>> t, w, m, k = sp.symbols("t omega mu_s mu_k", positive=True)
    >>> x = sp.Function("x")(t)
    >>> terms(w**2 * x + x.diff(t, 2) - w**2 * m)
    [Derivative(x(t), (t, 2)), omega**2*x(t), -mu_s*omega**2]
    >>> terms(m - k)
    [mu_s, -mu_k]
    """
    ordered = total.as_ordered_terms()
    if max(map(_derivative, ordered)) > 1:
        ordered = sorted(ordered, key=_derivative, reverse=True)
    return led_by_a_plus(ordered)


def led_by_a_plus(summands: list[sp.Expr]) -> list[sp.Expr]:
    """Return terms with the first that has no minus in front of the others."""
    plain = (i for i, term in enumerate(summands) if not term.could_extract_minus_sign())
    first = next(plain, 0)
    return [*summands[first : first + 1], *summands[:first], *summands[first + 1 :]]


def _derivative(term: sp.Expr) -> int:
    """Return 1 for a term with a motion, more by one for each time it is differentiated."""
    return max(map(_of_a_factor, sp.Mul.make_args(term)), default=0)


def _of_a_factor(factor: sp.Expr) -> int:
    if isinstance(factor, sp.Derivative):
        return 1 + int(factor.derivative_count)
    if hasattr(factor, "times_differentiated"):
        return 1 + int(factor.times_differentiated)
    if isinstance(factor, AppliedUndef):
        name = factor.func.__name__
        return 1 + int(name.count("'") + name.count("dot"))
    return 0


def factors(product: sp.Mul) -> sp.Expr:
    """Return a product, unevaluated, in the order shown.

    Numbers, symbols, brackets, coefficients, functions; a root over a root is one root.

    Examples
    --------
    >>> K, M, t = sp.symbols("K M t", positive=True)
    >>> factors(sp.sin(t) * sp.IndexedBase("a")[1] * (t + 1) * K).args
    (K, t + 1, a[1], sin(t))
    >>> factors(sp.sqrt(K) / sp.sqrt(M))
    sqrt(K/M)
    """
    number, without_number = product.as_coeff_Mul()
    ordered = sorted(_one_root(without_number.as_ordered_factors()), key=_rank)
    return sp.Mul(*([] if number == 1 else [number]), *ordered, evaluate=False)


def _one_root(all_factors: list[sp.Expr]) -> list[sp.Expr]:
    above = [q for q in all_factors if q.is_Pow and q.exp == sp.S.Half]
    below = [q for q in all_factors if q.is_Pow and q.exp == -sp.S.Half]
    if not above or not below:
        return all_factors
    radicand = sp.Mul(*(q.base for q in above), *(1 / q.base for q in below))
    root = sp.Pow(radicand, sp.S.Half, evaluate=False)
    return [root, *(q for q in all_factors if q not in (*above, *below))]


def _rank(factor: sp.Expr) -> int:
    base = factor.base if factor.is_Pow else factor
    if base.is_Symbol or base.is_NumberSymbol or base.is_Number:
        return 1
    if base.is_Add or base.is_Mul:
        return 2
    if isinstance(base, sp.Indexed):
        return 3 if base.is_real else 4
    return 5
