"""Draw expressions in lines of characters: fractions, sums, integrals, the paper's symbols.

Input: an expression.  Output: SymPy's form of a drawing, in Unicode or in plain ASCII.
"""

from functools import lru_cache

import sympy as sp
from sympy.printing.pretty.pretty import PrettyPrinter
from sympy.printing.pretty.pretty_symbology import pretty_use_unicode
from sympy.printing.pretty.stringpict import prettyForm, stringPict

from .order import factors, terms

SUBSCRIPTS = str.maketrans("0123456789+-()ijklmnrs", "₀₁₂₃₄₅₆₇₈₉₊₋₍₎ᵢⱼₖₗₘₙᵣₛ")
SUPERSCRIPTS = str.maketrans("0123456789+-()cijklmnsN", "⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻⁽⁾ᶜⁱʲᵏˡᵐⁿˢᴺ")

#: Words that are set high; Unicode has no q.
RAISED = str.maketrans("abcdefghijklmnoprstuvwxyz", "ᵃᵇᶜᵈᵉᶠᵍʰⁱʲᵏˡᵐⁿᵒᵖʳˢᵗᵘᵛʷˣʸᶻ")


#: Functions of an index and an argument, by the names of their classes.
LETTERS = {
    "bernoulli": "B",
    "euler": "E",
    "legendre": "P",
    "jn": "j",
    "ShiftedLegendre": "P*",
    "TwiceIntegrated": "Q",
}


def with_word(label: str) -> tuple[str, str]:
    """Return a name and the word of several letters below it, if it has one.

    Examples
    --------
    >>> with_word("d_flight"), with_word("F_N")
    (('d', 'flight'), ('F_N', ''))
    """
    name, _, word = label.partition("_")
    several = name and len(word) > 1 and word[0].isalpha()
    return (name, word) if several else (label, "")


class _Drawing(PrettyPrinter):  # type: ignore[misc]
    """SymPy's drawing with the paper's symbols, and sums and integrals three lines high."""

    def _name(self, label: str) -> str:
        if self._use_unicode and label.endswith(("^+", "^-")):
            return self._name(label[:-2]) + label[-1].translate(SUPERSCRIPTS)
        if label.endswith("'"):  # not a part of the word below
            return self._name(label[:-1]) + "'"
        name, word = with_word(label)
        if word:
            return f"{self._name(name)}_{word}"
        return str(super()._print_Symbol(sp.Symbol(label)).s)

    def _as_ordered_terms(self, expr: sp.Expr, order: str | None = None) -> list[sp.Expr]:
        return terms(expr)

    def _print_Mul(self, product: sp.Mul) -> prettyForm:
        ordered = factors(product)
        return super()._print_Mul(ordered) if ordered.is_Mul else self._print(ordered)

    def _print_Symbol(self, expr: sp.Symbol, bold_name: bool = False) -> prettyForm:
        return prettyForm(self._name(expr.name))

    def _print_Indexed(self, expr: sp.Indexed) -> prettyForm:
        return prettyForm(self._indexed(str(expr.base.label), expr.indices))

    def _indexed(self, label: str, indices: tuple[sp.Expr, ...]) -> str:
        index = ", ".join(map(sp.sstr, indices))
        if not self._use_unicode:
            return f"{label}[{index}]"
        name, _, raised = label.partition("^")
        short, word = with_word(name)
        if word and all(ord(letter) in RAISED for letter in word):
            name, raised = short, word.translate(RAISED)
        lowered = index.replace(" ", "").replace("*", "").translate(SUBSCRIPTS)
        if "N" in lowered:  # Unicode has none that is set low
            lowered = f"[{index}]"
        if "_" in name and not word:  # a letter below, apart from the indices
            lowered = f",{lowered}"
        return self._name(name) + raised.translate(SUPERSCRIPTS) + lowered

    def _print_Pow(self, expr: sp.Pow) -> prettyForm:
        base, exponent = expr.as_base_exp()
        if exponent.is_Rational and (exponent < 0 or exponent.q > 1):
            return super()._print_Pow(expr)
        form = self._print(base)
        if form.height() > 1:
            return super()._print_Pow(expr)
        if form.binding >= prettyForm.FUNC:
            form = prettyForm(*form.parens())
        above = sp.sstr(exponent)
        if self._use_unicode:
            product = "*" if "**" in above else ""
            above = above.replace(" ", "").replace("*", product).translate(SUPERSCRIPTS)
        else:
            above = f"**{above}" if exponent.is_Atom else f"**({above})"
        return prettyForm(*form.right(above), binding=prettyForm.ATOM)

    def _operator(self, sign: str, above: sp.Expr, below: str) -> prettyForm:
        """Return the sign of a sum or an integral with its limits, on the line of the sign."""
        over = str(self._print(above).s)
        width = max(len(sign), len(over), len(below))
        lines = (f"{line:^{width}} " for line in (over, sign, below))
        return prettyForm("\n".join(lines), baseline=1)

    def sum_sign(self, total: sp.Sum) -> prettyForm:
        """Return the sign of a sum, with the first and the last value of its index."""
        ((index, first, last),) = total.limits
        below = f"{index}={self._print(first).s}".replace(" ", "")
        return self._operator("∑" if self._use_unicode else "Sum", last, below)

    def _inside(self, expr: sp.Sum | sp.Integral) -> prettyForm:
        """Return what is summed or integrated, in brackets if it is a sum."""
        inside = self._print(expr.function)
        return prettyForm(*inside.parens()) if expr.function.is_Add else inside

    def _print_Sum(self, expr: sp.Sum) -> prettyForm:
        form = stringPict.next(self.sum_sign(expr), self._inside(expr))
        return prettyForm(*form, binding=prettyForm.MUL)

    def _print_Integral(self, expr: sp.Integral) -> prettyForm:
        ((variable, start, end),) = expr.limits
        sign = "∫" if self._use_unicode else "Int"
        head = self._operator(sign, end, str(self._print(start).s))
        form = stringPict.next(head, self._inside(expr), f" d{self._name(str(variable))}")
        return prettyForm(*form, binding=prettyForm.MUL)

    def _print_Derivative(self, expr: sp.Derivative) -> prettyForm:
        ((variable, order),) = expr.variable_count
        if isinstance(expr.expr, sp.core.function.AppliedUndef):
            return self._at(self._name(expr.expr.func.__name__) + "'" * int(order), variable)
        sign = "∂" if self._use_unicode else "d"
        return self._small(sign, expr.expr) / self._small(sign, variable)

    def _small(self, sign: str, expr: sp.Expr) -> prettyForm:
        """Return the differential of `expr`."""
        inside = self._print(expr)
        if not expr.is_Atom and not isinstance(expr, sp.Indexed):
            inside = prettyForm(*inside.parens())
        return prettyForm(*inside.left(sign))

    def _at(self, name: str, argument: sp.Expr) -> prettyForm:
        return prettyForm(*stringPict.next(name, prettyForm(*self._print(argument).parens())))

    def _print_Max(self, expr: sp.Max) -> prettyForm:
        return self._helper_print_function(expr.func, expr.args, func_name="max")

    def _print_Inner(self, expr: sp.Expr) -> prettyForm:
        left, right = ("⟨", "⟩") if self._use_unicode else ("<", ">")
        first, second = map(self._print, expr.args)
        return prettyForm(*stringPict.next(left, first, ", ", second, right))

    def _with_index(self, expr: sp.Expr) -> prettyForm:
        index, argument = expr.args
        return self._at(self._indexed(LETTERS[expr.func.__name__], (index,)), argument)

    _print_bernoulli = _print_euler = _print_legendre = _print_jn = _with_index
    _print_ShiftedLegendre = _print_TwiceIntegrated = _with_index  # noqa: N815  (of classes)

    def _print_KroneckerDelta(self, expr: sp.KroneckerDelta) -> prettyForm:
        return prettyForm(self._indexed("delta", expr.args))


@lru_cache(maxsize=10_000)  # drawn once what is measured for several widths of a line
def drawn(expression: sp.Expr, unicode: bool = True, sign: bool = False) -> prettyForm:
    """Return `expression` drawn, however wide; of a sum, on request, the sign alone.

    Examples
    --------
    >>> a, (n, N) = sp.IndexedBase("a"), sp.symbols("n N")
    >>> for line in drawn(sp.Symbol("a0") / 2 + sp.Sum(a[n], (n, 1, N)), unicode=False).picture:
    ...     print(line.rstrip())
    a0    N
    -- + Sum a[n]
    2    n=1
    """
    before = pretty_use_unicode(unicode)  # SymPy keeps the choice in a global
    try:
        drawing = _Drawing({"use_unicode": unicode, "wrap_line": False, "order": "none"})
        return drawing.sum_sign(expression) if sign else drawing._print(expression)
    finally:
        pretty_use_unicode(before)
