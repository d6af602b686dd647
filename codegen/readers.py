"""What a reader calls on a record, found here: its LaTeX, its text, the record written out.

`system.READERS` is filled when `codegen` is imported; a printer is imported when it is asked.
"""

from collections.abc import Iterable
from importlib.util import find_spec

import sympy as sp

from .system import READERS, Equation, GalerkinSystem


def _latex(equation: Equation) -> str:
    from .printing.latex import displayed  # noqa: PLC0415

    return displayed(equation)


def _all_latex(equations: Iterable[Equation]) -> str:
    from .printing.latex import equation_latex  # noqa: PLC0415

    return "\n".join(map(equation_latex, equations))


def _notebook(equations: Iterable[Equation]) -> str:
    from .printing.latex import in_notebook  # noqa: PLC0415

    return in_notebook(equations)


def _text(equation: Equation, unicode: bool) -> str:
    from .printing.text import equation_text  # noqa: PLC0415

    return equation_text(equation, unicode)


def _unknowns(system: GalerkinSystem, order: int) -> tuple[sp.Expr, ...]:
    _check_can_be_written_out(system)
    from .shortcuts.written_out import check_order, unknowns  # noqa: PLC0415

    return unknowns(system, check_order(order))


def _expanded(system: GalerkinSystem, order: int) -> tuple[sp.Eq, ...]:
    _check_can_be_written_out(system)
    from .shortcuts.written_out import expanded  # noqa: PLC0415

    return expanded(system, order)


def _check_can_be_written_out(system: GalerkinSystem) -> None:
    if find_spec(f"{__package__}.shortcuts") is None:
        raise ValueError(f"method: got {system.method!r}, expected one of the paper's")


READERS.update(
    {
        "latex": _latex,
        "all latex": _all_latex,
        "notebook": _notebook,
        "text": _text,
        "unknowns": _unknowns,
        "expanded": _expanded,
    }
)
