"""Tables as objects of pandas and xarray, where these are installed."""

from typing import TYPE_CHECKING, Any

import numpy as np

from ...extras import require

if TYPE_CHECKING:
    from .table import Table


def dataframe(table: "Table") -> Any:
    """Return a table as a `pandas.DataFrame`; see `Tabular.to_dataframe`."""
    require("pandas", "pandas", "to_dataframe")
    import pandas as pd  # noqa: PLC0415

    frame = pd.DataFrame({name: column(values) for name, values in table.columns.items()})
    frame.attrs = {"units": dict(table.units), **table.about}
    return frame


def dataset(table: "Table") -> Any:
    """Return a table as an `xarray.Dataset`; see `Tabular.to_xarray`."""
    require("xarray", "xarray", "to_xarray")
    import xarray as xr  # noqa: PLC0415

    variables = {
        name: (dimensions, values, {"units": table.units[name]} if name in table.units else {})
        for name, (dimensions, values) in arrays(table).items()
    }
    coordinates = {name: variables.pop(name) for name in table.index}
    return xr.Dataset(variables, coordinates, dict(table.about))


def arrays(table: "Table") -> dict[str, tuple[tuple[str, ...], Any]]:
    """Return the columns of a table as arrays over its index, with their dimensions.

    With one coordinate an array is the column itself.  With several it is a grid, with NaN, 0
    or "" where the table has no row.
    """
    import pandas as pd  # noqa: PLC0415  (xarray needs it)

    columns = {name: column(values) for name, values in table.columns.items()}
    cells: Any = slice(None)  # of each row in the grid
    labels: Any = [columns[name] for name in table.index]
    if len(labels) > 1:
        cells, labels = zip(*map(pd.factorize, labels), strict=True)
    arrays_: dict[str, tuple[tuple[str, ...], Any]]
    arrays_ = {name: ((name,), labels[i]) for i, name in enumerate(table.index)}
    for name, values in columns.items():
        if name not in table.index:
            grid = np.zeros(tuple(map(len, labels)), dtype=values.dtype)
            if values.dtype.kind == "f":
                grid[...] = np.nan
            grid[cells] = values
            arrays_[name] = (table.index, grid)
    return arrays_


def column(values: Any) -> Any:
    """Return a column as an array of strings, integers or floats; None becomes "" or NaN."""
    if isinstance(values, np.ndarray):
        return values
    present = [value for value in values if value is not None]
    if present and all(isinstance(value, str) for value in present):
        return np.array(["" if value is None else value for value in values])
    if present and len(present) == len(values) and all(isinstance(v, int) for v in present):
        return np.array(values)
    return np.array([np.nan if value is None else value for value in values], dtype=float)
