"""Print the derived equations, numbered as in the paper: as text and as LaTeX.

Input: the records of Section 2 and of the methods.  Output: one string.
"""

from collections.abc import Iterable, Sequence

import sympy as sp
from sympy.printing.latex import LatexPrinter

from . import derive, section2
from .c1_legendre import ShiftedLegendre, TwiceIntegrated
from .system import Equation, GalerkinSystem

#: Longest line of mathematics, in characters of the plain form, before it is broken.
LINE = 70

PREAMBLE = r"""\documentclass[a4paper]{article}
\usepackage{amsmath}
\usepackage{amssymb}
\usepackage[margin=2cm]{geometry}
\allowdisplaybreaks
\title{Harmonic balance and Galerkin equations of the stick--slip oscillator}
\author{derived by \texttt{nonsmooth} after Kim and Perkins (2003)}
\date{}
\begin{document}
\maketitle
\noindent Equation numbers are those of W.-J.~Kim and N.~C.~Perkins, Harmonic
balance/Galerkin method for non-smooth dynamic systems, \emph{Journal of Sound and
Vibration} 261 (2003) 213--224.  What has no number there has none here.
"""


class _Latex(LatexPrinter):  # type: ignore[misc]
    """LaTeX with the paper's symbols."""

    def _print_Symbol(self, expr: sp.Symbol, style: str = "plain") -> str:
        names = {"t1": "t_{1}", "a0": "a_{0}", "c1": "c_{1}"}
        if expr.name.startswith("R_"):
            return rf"\mathcal{{R}}_{{({expr.name[2:]})}}"
        return names.get(expr.name) or str(super()._print_Symbol(expr))

    def _print_Indexed(self, expr: sp.Indexed) -> str:
        base, indices = str(expr.base.label), ", ".join(map(self._print, expr.indices))
        name = self._print(expr.base.label)
        if base[0] in "CS" and base[1:].isdigit():
            return rf"{base[0]}^{{({base[1:]})}}_{{{indices}}}"
        if base.startswith("H^"):
            return rf"H^{{\mathrm{{{base[2:]}}}}}_{{{indices}}}"
        return f"{name}_{{{indices}}}"

    def _print_Derivative(self, expr: sp.Derivative) -> str:
        (variable, order), *others = expr.variable_count
        function = expr.expr
        if not others and variable == sp.Symbol("t", positive=True) and function.func in _DOTS:
            dot = "dot" if order == 1 else "ddot"
            return rf"\{dot}{{{_DOTS[function.func]}}}\left(t\right)"
        return str(super()._print_Derivative(expr))

    def _print_Subs(self, expr: sp.Subs) -> str:
        (point,) = expr.point
        inner = str(self._print(expr.expr))
        return inner.replace(r"\left(t\right)", rf"\left({self._print(point)}\right)")

    def _print_Heaviside(self, expr: sp.Heaviside, exp: str | None = None) -> str:
        return rf"H\left({self._print(expr.args[0])}\right)"

    def _print_ShiftedLegendre(self, expr: ShiftedLegendre, exp: str | None = None) -> str:
        index, argument = map(self._print, expr.args)
        return rf"P^{{*}}_{{{index}}}\left({argument}\right)"

    def _print_TwiceIntegrated(self, expr: TwiceIntegrated, exp: str | None = None) -> str:
        index, argument = map(self._print, expr.args)
        return rf"Q_{{{index}}}\left({argument}\right)"


_DOTS = {sp.Function("x"): "x", sp.Function("g1"): "g_{1}"}

_SETTINGS = {"mul_symbol": None, "fold_short_frac": False}


def latex(expression: sp.Expr) -> str:
    """Return `expression` as LaTeX mathematics."""
    text = str(_Latex(_SETTINGS).doprint(expression))
    for name in ("R1", "R2", "R3", "g1"):
        text = text.replace(rf"\operatorname{{{name}}}", f"{name[0]}_{{{name[1]}}}")
    return text.replace(r"\operatorname{xdot}", r"\dot{x}").replace(r"\operatorname{q}", "q")


def _broken(side: sp.Expr) -> list[str]:
    """Return a long sum as several lines of LaTeX, whole terms on each."""
    lines, length = [""], 0
    for term in _ordered_terms(side):
        size = len(str(term))
        text = latex(term)
        if lines[-1] and length + size > LINE:
            lines.append("")
            length = 0
        sign = "" if text.startswith("-") or lines == [""] else "+ "
        lines[-1] += f"{sign}{text} "
        length += size
    return lines


def _ordered_terms(side: sp.Expr) -> Sequence[sp.Expr]:
    if not isinstance(side, sp.Add) or len(str(side)) <= LINE:
        return [side]
    return list(side.as_ordered_terms())


def equation_latex(equation: Equation) -> str:
    """Return one equation as a displayed, tagged LaTeX environment."""
    first, *others = equation.sides
    rows = [latex(first)]
    for side in others:
        head, *more = _broken(side)
        rows.append(f"&= {head}")
        rows.extend(rf"&\quad {line}" for line in more)
    body = " \\\\\n".join([rows[0] + " " + rows[1], *rows[2:]] if others else rows)
    tag = rf"\tag{{{equation.number}}}" if equation.number else r"\notag"
    words = f"{equation.title}; {equation.where}" if equation.where else equation.title
    return (
        f"\\paragraph{{}}{_prose(words)}\n"
        f"\\begin{{equation}}\n\\begin{{aligned}}\n{body}\n\\end{{aligned}}\n{tag}\n"
        "\\end{equation}\n"
    )


def _prose(words: str) -> str:
    """Return plain words with the few signs that LaTeX would misread set as text."""
    signs = {"_": r"\_", "<=": r"$\le$", "< ": r"$<$ ", "!=": r"$\ne$", ">=": r"$\ge$"}
    signs |= {"|": r"$|$"}
    for plain, set_ in signs.items():
        words = words.replace(plain, set_)
    return words


def _sections(methods: Iterable[str]) -> list[tuple[str, Sequence[Equation]]]:
    """Return (heading, equations) for Section 2 and each of the `methods`."""
    sections: list[tuple[str, Sequence[Equation]]] = [
        (f"Section 2: {section2.TITLE}", section2.equations())
    ]
    for system in map(derive, methods):
        heading = f"Section {system.section}: {system.title} ({system.method})"
        sections.append((heading, system.equations))
        sections.append((f"Jacobian of Section {system.section}", system.jacobian))
    return sections


def latex_document(methods: Iterable[str]) -> str:
    """Return a LaTeX document, complete, with the equations of `methods`."""
    parts = [PREAMBLE]
    for heading, equations in _sections(methods):
        parts.append(f"\\section*{{{_prose(heading)}}}\n")
        parts.extend(equation_latex(equation) for equation in equations)
    return "\n".join([*parts, "\\end{document}\n"])


def equation_text(equation: Equation) -> str:
    """Return one equation as text for a terminal."""
    number = f"({equation.number})" if equation.number else "-"
    words = f"{equation.title}; {equation.where}" if equation.where else equation.title
    sides = [sp.sstr(side) for side in equation.sides]
    lines = [f"{number:>5}  {words}", f"       {sides[0]}"]
    return "\n".join([*lines, *(f"         = {side}" for side in sides[1:])])


def text_document(methods: Iterable[str]) -> str:
    """Return the equations of `methods` as text for a terminal."""
    parts = []
    for heading, equations in _sections(methods):
        parts.append(f"{heading}\n{'=' * len(heading)}\n")
        parts.extend(f"{equation_text(equation)}\n" for equation in equations)
    return "\n".join(parts)


def system_latex(system: GalerkinSystem) -> str:
    """Return the equations of one method as LaTeX, without a preamble."""
    return "\n".join(equation_latex(equation) for equation in system.equations)


def system_text(system: GalerkinSystem) -> str:
    """Return the equations of one method as text for a terminal."""
    return "\n\n".join(equation_text(equation) for equation in system.equations)
