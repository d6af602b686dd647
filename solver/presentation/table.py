"""A result as a table: flat columns of numbers, their units, and what it is about."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from .notebook import of_rows

if TYPE_CHECKING:
    from ..scenes.case import Case

#: What is told of a motion over time, and its units.
COURSE = {"t": "s", "displacement": "m", "velocity": "m/s", "acceleration": "m/s**2"}


@dataclass(frozen=True)
class Table:
    """Columns of equal length.

    Parameters
    ----------
    index : tuple of str
        The columns by which a row is found: its coordinates.
    columns : mapping of str to sequence
        Numbers, or words; None or NaN where there is no number.
    units : mapping of str to str
        Of the columns that have one, in SI.
    about : mapping of str to (str or number)
        What is the same for all rows: scene, method, parameters.
    """

    index: tuple[str, ...]
    columns: Mapping[str, Any]
    units: Mapping[str, str] = field(default_factory=dict)
    about: Mapping[str, Any] = field(default_factory=dict)

    def rows(self) -> list[dict[str, Any]]:
        """Return the rows, each with its columns and with what is the same for all."""
        every = zip(*self.columns.values(), strict=True)
        return [dict(zip(self.columns, row, strict=True)) | dict(self.about) for row in every]


class Tabular:
    """A result that is a table, for pandas and xarray."""

    def table(self) -> Table:
        """Return the columns, with their units."""
        raise NotImplementedError

    def to_dataframe(self) -> Any:
        """Return a `pandas.DataFrame`: a row each, a column a number.

        ``attrs["units"]`` has the units of the columns, in SI; the rest of ``attrs`` what is
        the same for all rows: scene, method, order and parameters.  Needs the extra
        ``pandas``.

        Raises
        ------
        MissingExtra
            An `ImportError`: if pandas is not installed.
        """
        from .frames import dataframe  # noqa: PLC0415  (an extra)

        return dataframe(self.table())

    def to_xarray(self) -> Any:
        """Return an `xarray.Dataset`: variables over named coordinates.

        Each variable has its unit, in SI, in ``attrs["units"]``; ``attrs`` of the whole has
        what `to_dataframe` has.  Needs the extra ``xarray``.

        Raises
        ------
        MissingExtra
            An `ImportError`: if xarray is not installed.
        """
        from .frames import dataset  # noqa: PLC0415  (an extra)

        return dataset(self.table())


class OfRows(Tabular):
    """A result of a row for each of many orbits of a case."""

    case: "Case"
    functions: int | None

    def plot(self, ax: Any = None) -> Any:
        """Draw it on axes, new ones without `ax`, and return these."""
        raise NotImplementedError

    def head(self, **how: Any) -> dict[str, Any]:
        """Return the beginning of its document: the case, and how its orbits were computed."""
        scene = self.case.scene
        found: dict[str, Any] = {"scene": scene.name, "class": f"C{scene.k}"}
        found |= {"motion": scene.motion, "cycles": self.case.cycles, **how}
        return found | {"functions": self.functions, "parameters": dict(self.case.values)}

    def about(self, **how: Any) -> dict[str, Any]:
        """Return what a table says of all rows: the same, without what there is none of."""
        found = self.head(**how)
        del found["parameters"]
        return {name: value for name, value in found.items() if value is not None}

    def _repr_html_(self) -> str:
        return of_rows(repr(self), str(self), self.plot)


def flat(rows: Sequence[Mapping[str, Any]]) -> dict[str, list[Any]]:
    """Return rows of nested numbers as columns, with the names of what holds them in front.

    A mapping under ``errors`` becomes columns ``error_...``; a pair, two columns ``least_...``
    and ``largest_...``; a longer sequence, columns numbered from 1; None stays None.

    Examples
    --------
    >>> flat([{"N": 3, "errors": {"T": 0.1}, "ends": {"x": (0, 1)}}, {"N": 4}])
    {'N': [3, 4], 'error_T': [0.1, None], 'least_x': [0, None], 'largest_x': [1, None]}
    """
    flattened = [dict(_leaves(row)) for row in rows]
    names = dict.fromkeys(name for row in flattened for name in row)
    empty = {n for n in names if all(row.get(n) is None for row in flattened)}
    whole = {n for n in empty if any(other.startswith(f"{n.rstrip('s')}_") for other in names)}
    return {n: [row.get(n) for row in flattened] for n in names if n not in whole}


def _leaves(row: Mapping[str, Any]) -> "list[tuple[str, Any]]":
    found: list[tuple[str, Any]] = []
    for name, value in row.items():
        head = name.removesuffix("s")
        if isinstance(value, Mapping):
            for key, part in value.items():
                if isinstance(part, tuple | list) and len(part) == 2:
                    ends = zip(("least", "largest"), part, strict=True)
                    found += [(f"{end}_{key}", number) for end, number in ends]
                else:
                    found.append((f"{head}_{key}", part))
        elif isinstance(value, tuple | list):
            found += [(f"{head}_{i}", part) for i, part in enumerate(value, 1)]
        else:
            found.append((name, value))
    return found
