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
    """Return a table as an `xarray.Dataset`; see `Tabular.to_xarray`.

    With one coordinate a variable is the column itself.  With several it is a grid, with NaN, 0
    or "" where the table has no row.
    """
    require("xarray", "xarray", "to_xarray")
    import pandas as pd  # noqa: PLC0415  (xarray needs it)
    import xarray as xr  # noqa: PLC0415

    columns = {name: column(values) for name, values in table.columns.items()}
    cells: Any = slice(None)  # of each row in the grid
    labels: Any = [columns[name] for name in table.index]
    if len(labels) > 1:
        cells, labels = zip(*map(pd.factorize, labels), strict=True)
    units = {name: {"units": unit} for name, unit in table.units.items()}
    coordinates = {
        name: (name, values, units.get(name))
        for name, values in zip(table.index, labels, strict=True)
    }
    variables = {}
    for name, values in columns.items():
        if name not in table.index:
            grid = np.zeros(tuple(map(len, labels)), dtype=values.dtype)
            if values.dtype.kind == "f":
                grid[...] = np.nan
            grid[cells] = values
            variables[name] = (table.index, grid, units.get(name))
    return xr.Dataset(variables, coordinates, dict(table.about))


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
