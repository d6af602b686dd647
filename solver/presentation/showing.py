"""What every periodic motion shows of itself: a line, a table of its course, a picture."""

from collections.abc import Mapping
from dataclasses import fields
from typing import Any

import numpy as np

from .notebook import of_motion
from .table import Table, Tabular

#: Times over one period at which the course of a motion is given.
SAMPLES = 1000

UNITS = {"t": "s", "displacement": "m", "velocity": "m/s", "acceleration": "m/s**2"}


class Shown(Tabular):
    """A periodic motion with a period, durations and derivatives at any time.

    A subclass says what it is called, how its curves look, and its facts.
    """

    @property
    def label(self) -> str:
        """What a legend calls it: method and order, or ``"exact"``."""
        raise NotImplementedError

    @property
    def look(self) -> dict[str, Any] | None:
        """Of its curves in pictures: colour, line, marker; None of an exact orbit."""
        raise NotImplementedError

    @property
    def facts(self) -> Mapping[str, str]:
        """What a notebook shows, in words, by what it is."""
        raise NotImplementedError

    @property
    def about(self) -> dict[str, Any]:
        """Scene, method, order and parameters, for tables and files."""
        raise NotImplementedError

    @property
    def _identity(self) -> tuple[object, ...]:
        """What makes two motions the same."""
        raise NotImplementedError

    def __eq__(self, other: object) -> bool:
        return type(self) is type(other) and self._identity == other._identity

    def __hash__(self) -> int:
        return hash(self._identity)

    def __getstate__(self) -> dict[str, Any]:
        """Return what it was made of, for pickle: what was computed from that is left out."""
        return {field.name: getattr(self, field.name) for field in fields(self)}  # type: ignore[arg-type]

    def plot(self, ax: Any = None, quantity: str = "plane", **style: Any) -> Any:
        """Draw the motion and return the axes; needs matplotlib, the extra ``plot``.

        Parameters
        ----------
        ax : matplotlib Axes, optional
            Where; new ones without it.
        quantity : {"plane", "displacement", "velocity", "acceleration"}
            The phase plane, or one of the three against time in periods.
        **style
            Of the line, as `matplotlib.axes.Axes.plot` takes it.

        Raises
        ------
        ValueError
            If `quantity` is none of these.
        MissingExtra
            An `ImportError`: if matplotlib is not installed.
        """
        from ...plots.orbits import draw  # noqa: PLC0415  (an extra)

        return draw(self, ax, quantity, **style)

    def table(self, samples: int = SAMPLES) -> Table:
        """Return the motion over one period, at equal steps of time.

        `t` in s, `displacement`, `velocity` and `acceleration` in SI units, and the number of
        the `phase`, from 0; their names are in `about`.

        Parameters
        ----------
        samples : int
            How many times.
        """
        motion: Any = self
        t = motion.period * np.arange(samples) / samples
        switches = np.cumsum(motion.durations)[:-1]
        columns = {"t": t} | {name: getattr(motion, name)(t) for name in list(UNITS)[1:]}
        columns["phase"] = np.searchsorted(switches, t, side="right")
        return Table(("t",), columns, UNITS, self.about)

    def _repr_html_(self) -> str:
        return of_motion(self)
