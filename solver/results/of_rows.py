"""What results of many rows have in common: what they are about, and how they show it."""

from collections.abc import Mapping
from typing import Any

from ..presentation.notebook import of_rows
from ..presentation.table import Tabular
from ..scenes.case import Case

NOTHING: Mapping[str, Any] = {}


class OfRows(Tabular):
    """A result of a row for each of many orbits of a case."""

    case: Case
    functions: int | None

    def plot(self, ax: Any = None) -> Any:
        """Draw it on axes, new ones without `ax`, and return these."""
        raise NotImplementedError

    def head(self, how: Mapping[str, Any] = NOTHING) -> dict[str, Any]:
        """Return the beginning of its document: the case, and how its orbits were computed."""
        scene = self.case.scene
        found: dict[str, Any] = {"scene": scene.name, "class": f"C{scene.k}"}
        found |= {"motion": scene.motion, "cycles": self.case.cycles, **how}
        return found | {"functions": self.functions, "parameters": dict(self.case.values)}

    def about(self, how: Mapping[str, Any] = NOTHING) -> dict[str, Any]:
        """Return what a table says of all rows: the same, without what there is none of."""
        found = self.head(how)
        del found["parameters"]
        return {name: value for name, value in found.items() if value is not None}

    def _repr_html_(self) -> str:
        return of_rows(repr(self), str(self), self.plot)
