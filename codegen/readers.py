"""What a reader calls on a record, found here: its LaTeX, its text.

`system.READERS` is filled when `codegen` is imported; a printer is imported when it is asked.
"""

from collections.abc import Iterable

from .system import READERS, Equation


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


READERS.update(
    {
        "latex": _latex,
        "all latex": _all_latex,
        "notebook": _notebook,
        "text": _text,
    }
)
