"""What a document of equations consists of: headings, and the equations under each."""

from dataclasses import dataclass

from ..system import Equation


@dataclass(frozen=True)
class Section:
    """A heading, its equations, and a sentence between the two."""

    heading: str
    equations: tuple[Equation, ...]
    note: str = ""
