"""Results as tables: flat columns, their units, and the data that all rows share."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from . import frames
from .notebook import of_rows

if TYPE_CHECKING:
    from ..scenes.case import Case

#: The columns of a motion over time, and their units.
COURSE = {"t": "s", "displacement": "m", "velocity": "m/s", "acceleration": "m/s**2"}


@dataclass(frozen=True)
class Table:
    """Columns of equal length.

    Parameters
    ----------
    index : tuple of str
        The columns that are coordinates of the rows.
    columns : mapping of str to sequence
        Numbers, or words; None or NaN where there is no number.
    units : mapping of str to str
        The SI units of the columns that have one.
    about : mapping of str to (str or number)
        Data that all rows share: scene, method, parameters.
    """

    index: tuple[str, ...]
    columns: Mapping[str, Any]
    units: Mapping[str, str] = field(default_factory=dict)
    about: Mapping[str, Any] = field(default_factory=dict)

    def rows(self) -> list[dict[str, Any]]:
        """Return the rows as mappings, each with the data that all share."""
        every = zip(*self.columns.values(), strict=True)
        return [dict(zip(self.columns, row, strict=True)) | dict(self.about) for row in every]


class Tabular:
    """A result with a table, for pandas and xarray."""

    def table(self) -> Table:
        """Return the result as a table."""
        raise NotImplementedError

    def to_dataframe(self) -> Any:
        """Return the table as a `pandas.DataFrame`.

        ``attrs["units"]`` has the SI units of the columns; the rest of ``attrs`` the data that
        all rows share: scene, method, order and parameters.  Needs the extra ``pandas``.

        Raises
        ------
        MissingExtra
            An `ImportError`: if pandas is not installed.
        """
        return frames.dataframe(self.table())

    def to_xarray(self) -> Any:
        """Return the table as an `xarray.Dataset`: variables over named coordinates.

        Each variable has its SI unit in ``attrs["units"]``; ``attrs`` of the dataset has the
        data that all rows share.  Needs the extra ``xarray``.

        Raises
        ------
        MissingExtra
            An `ImportError`: if xarray is not installed.
        """
        return frames.dataset(self.table())


class OfRows(Tabular):
    """A result with a row for each of many orbits of a case."""

    case: "Case"
    functions: int | None

    def plot(self, ax: Any = None) -> Any:
        """Draw the result on `ax`, by default on new axes, and return the axes."""
        raise NotImplementedError

    def head(self, **how: Any) -> dict[str, Any]:
        """Return the first keys of its document: the case, `how` its orbits were computed."""
        scene = self.case.scene
        head: dict[str, Any] = {"scene": scene.name, "class": f"C{scene.k}"}
        head |= {"motion": scene.motion, "cycles": self.case.cycles, **how}
        return head | {"functions": self.functions, "parameters": dict(self.case.values)}

    def about(self, **how: Any) -> dict[str, Any]:
        """Return the data that all rows of the table share: `head` without empty entries.

        The parameters are left out as well.
        """
        head = self.head(**how)
        del head["parameters"]
        return {name: value for name, value in head.items() if value is not None}

    def _repr_html_(self) -> str:
        return of_rows(repr(self), str(self), self.plot)


def flat(rows: Sequence[Mapping[str, Any]]) -> dict[str, list[Any]]:
    """Return rows of nested numbers as flat columns, whose names tell the nesting.

    A mapping ``errors`` becomes columns ``error_...``; a pair in a mapping, two columns
    ``least_...`` and ``largest_...``; a sequence, columns numbered from 1; None stays None.

    Examples
    --------
    >>> flat([{"N": 3, "errors": {"T": 0.1}, "ends": {"x": (0, 1)}}, {"ends": {"x": None}}])
    {'N': [3, None], 'error_T': [0.1, None], 'least_x': [0, None], 'largest_x': [1, None]}
    """
    flattened = [dict(_leaves(row)) for row in rows]
    names = dict.fromkeys(name for row in flattened for name in row)
    empty = {n for n in names if all(row.get(n) is None for row in flattened)}
    whole = {n for n in empty if any(other.startswith(f"{n.rstrip('s')}_") for other in names)}
    whole |= {n for n in empty if f"least_{n.partition('_')[2]}" in names}  # no pair there
    return {n: [row.get(n) for row in flattened] for n in names if n not in whole}


def _leaves(row: Mapping[str, Any]) -> "list[tuple[str, Any]]":
    leaves: list[tuple[str, Any]] = []
    for name, value in row.items():
        head = name.removesuffix("s")
        if isinstance(value, Mapping):
            for key, part in value.items():
                if isinstance(part, tuple | list) and len(part) == 2:
                    ends = zip(("least", "largest"), part, strict=True)
                    leaves += [(f"{end}_{key}", number) for end, number in ends]
                else:
                    leaves.append((f"{head}_{key}", part))
        elif isinstance(value, tuple | list):
            leaves += [(f"{head}_{i}", part) for i, part in enumerate(value, 1)]
        else:
            leaves.append((name, value))
    return leaves
