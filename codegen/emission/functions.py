"""A function of a kernel as text: its frame, and the lines that name its unknowns."""

from collections.abc import Sequence

from ..galerkin import GalerkinConditions
from .loops import per_order, places


def function(name: str, summary: str, lines: Sequence[str]) -> str:
    """Return the text of a function."""
    text = "".join(f"    {line}\n" for line in lines)
    return f'def {name}:\n    """{summary}"""\n{text}'


def prologue(system: GalerkinConditions) -> list[str]:
    """Return the lines by which a function may know its unknowns and have its tables."""
    slope, rest = per_order(system)
    names = ", ".join(symbol.name for symbol in system.parameters)
    lines = [f"{names} = case" if len(system.parameters) > 1 else f"({names},) = case"]
    lines.append(f"N = len(z) - {rest}" if slope == 1 else f"N = (len(z) - {rest})//{slope}")
    lines += [*places(system), *(f"{time} = z[at_{time}]" for time in system.times.unknown)]
    for table in system.tables:
        lines += [line for line in table.prepare.splitlines() if line not in lines]
        lines.append(f"{table.base.label} = {table.fill}")
    return lines
