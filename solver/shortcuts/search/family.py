"""A family of orbits: one parameter of the oscillator takes many values.

The dimensionless orbit depends on ``alpha`` alone, so each point is the orbit of its
``alpha``, scaled by its units of time and length; see `family_points`.
"""

from dataclasses import asdict, dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from ...arrays import Vector
from ...results.notebook import of_rows
from ...results.table import Table, Tabular
from ..accuracy.estimate import CONVERGED_ORDER
from ..names import SCENE
from ..orbit.methods import check_alpha, check_method, check_order, with_terms
from ..orbit.oscillator import PARAMETERS, StickSlip, check_type
from ..polynomials.batch import OK
from .family_points import COLUMNS, STATUS, points, with_value

#: Order at which the C1 series has converged to rounding, whatever alpha.
ORDER = CONVERGED_ORDER

#: Points computed at once, before the next look at the keyboard: a tenth of a second.
CHUNK = 16_384


@dataclass(frozen=True, eq=False, repr=False)
class Family(Tabular):
    """Orbits along one parameter.

    Parameters
    ----------
    belt : StickSlip
        The oscillator; the parameter that varies is as in the first point.
    parameter : str
        Its name, as in `StickSlip`.
    method, order, c1_terms : str, int, int
        How the orbits were computed.
    points : ndarray, shape (n,)
        With the fields ``status`` (0: ``ok``, 1: ``no-orbit``, 2: ``not-converged``),
        ``value`` of the parameter, ``alpha``, ``t1`` and ``period`` in s, ``amplitude`` in
        m, ``stick_fraction``, and ``estimate_period``, ``estimate_t1``: the relative
        errors as estimated.  Without an orbit they are NaN.
    """

    belt: StickSlip
    parameter: str
    method: str
    order: int
    c1_terms: int
    points: npt.NDArray[np.void]

    def __getitem__(self, name: str) -> npt.NDArray[Any]:
        """Return one field of the points."""
        return self.points[name]

    def __len__(self) -> int:
        return len(self.points)

    @property
    def _identity(self) -> tuple[object, ...]:
        how = (self.parameter, self.method, self.order, self.c1_terms)
        return self.belt, *how, self.points.tobytes()

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Family) and self._identity == other._identity

    def __hash__(self) -> int:
        return hash(self._identity)

    def plot(self, ax: Any = None, quantity: str = "period", **style: Any) -> Any:
        """Draw one quantity along the parameter and return the axes.

        Needs matplotlib, the extra ``plot``.

        Parameters
        ----------
        ax : matplotlib Axes, optional
            Where; new ones without it.
        quantity : {"period", "amplitude", "stick_fraction", "estimate_period"}
            The field of the points.
        **style
            Of the line, as `matplotlib.axes.Axes.plot` takes it.

        Raises
        ------
        ValueError
            If `quantity` is none of these.
        MissingExtra
            An `ImportError`: if matplotlib is not installed.
        """
        from ....plots.shortcuts.families import draw  # noqa: PLC0415  (an extra)

        return draw(self, ax, quantity, **style)

    def table(self) -> Table:
        """Return the points; the value has the name of the parameter, the status its word."""
        columns: dict[str, Any] = {self.parameter: self["value"]}
        columns["status"] = [STATUS[code] for code in self["status"]]
        columns |= {name: self[name] for name in COLUMNS if name != "value"}
        units = {n: unit for n, unit in COLUMNS.items() if unit != "1" and n in columns}
        units |= {n: unit for n, (unit, _) in PARAMETERS.items() if n in columns and unit}
        about: dict[str, Any] = {"scene": SCENE, "class": "C1", "parameter": self.parameter}
        about |= {"method": self.method, "order": self.order, "c1_terms": self.c1_terms}
        fixed = {n: value for n, value in asdict(self.belt).items() if n != self.parameter}
        return Table((self.parameter,), columns, units, about | fixed)

    def __repr__(self) -> str:
        values, found = self["value"], int(np.sum(self["status"] == OK))
        along = f"{self.parameter} = {values[0]:g} to {values[-1]:g}"
        method = f"{self.method}, N = {self.order}"
        return f"<{SCENE} along {along} by {method}: {len(self)} values, {found} orbits>"

    def _repr_html_(self) -> str:
        return of_rows(repr(self), str(self), self.plot)

    def __str__(self) -> str:
        head = f"{self.parameter:>15}  {'alpha':>10}  {'T [s]':>14}  {'amplitude [m]':>14}"
        lines = [f"{head}  {'stick/T':>9}  estimate"]
        for point in self.points:
            line = f"{point['value']:15.8g}  {point['alpha']:10.4g}  "
            if point["status"] != OK:
                lines.append(line + STATUS[point["status"]])
                continue
            lines.append(
                f"{line}{point['period']:14.9g}  {point['amplitude']:14.9g}  "
                f"{point['stick_fraction']:9.6f}  {point['estimate_period']:.1e}"
            )
        return "\n".join(lines)


def family(
    belt: StickSlip,
    parameter: str,
    values: npt.ArrayLike,
    method: str = "c1",
    order: int = ORDER,
    *,
    c1_terms: int = 1,
) -> Family:
    """Return the orbits of `belt` as one of its parameters takes many values.

    Parameters
    ----------
    belt : StickSlip
        The oscillator.
    parameter : str
        ``"mass"``, ``"stiffness"``, ``"belt_speed"``, ``"mu_s"``, ``"mu_k"`` or
        ``"normal_force"``.
    values : array_like of float, shape (n,)
        What it becomes, in SI units.
    method : {"c1", "hb", "hb-c1"}
        Section 3.3, 3.1 or 3.2.  The first is by far the quickest, and uses all cores.
    order : int
        ``N``; at 24 Section 3.3 has converged to rounding.
    c1_terms : int
        C1 functions of ``"hb-c1"``.

    Raises
    ------
    TypeError
        If `belt` is not a `StickSlip`.
    ValueError
        If the parameter, the method or the order is not one that there is, or a value
        makes no oscillator (`ParameterError`).

    Examples
    --------
    >>> import nonsmooth as ns
    >>> belt = ns.StickSlip(mass=10, stiffness=1000, belt_speed=1,
    ...                     mu_s=0.5, mu_k=0.25, normal_force=400)
    >>> orbits = ns.family(belt, "belt_speed", [0.5, 1.0, 2.0])
    >>> orbits["period"].round(6)
    array([0.806889, 0.671239, 0.635589])
    >>> orbits["stick_fraction"].round(3)
    array([0.496, 0.298, 0.157])
    """
    check_type(belt)
    if not np.isrealobj(values):
        raise ValueError("values: got complex numbers, expected real ones")
    try:
        numbers = np.atleast_1d(np.asarray(values, dtype=float)).ravel()
    except (TypeError, ValueError):
        raise ValueError(f"values: got {values!r:.80}, expected numbers") from None
    check(belt, parameter, numbers)
    chosen = with_terms(check_method(method), c1_terms)
    number = check_order(order, chosen)
    chunks = [
        points(belt, parameter, numbers[i : i + CHUNK], chosen, number)
        for i in range(0, len(numbers), CHUNK)
    ]
    first = with_value(belt, parameter, float(numbers[0]))
    return Family(first, parameter, method, number, c1_terms, np.concatenate(chunks))


def check(belt: StickSlip, parameter: object, values: Vector) -> None:
    """Check that each value of the parameter makes an oscillator.

    What is asked of a parameter, and ``alpha``, are monotone in it: the ends are enough.

    Raises
    ------
    ValueError
        If there is no such parameter, or no value.
    ParameterError
        If one of the values is not that of an oscillator.
    """
    if parameter not in PARAMETERS:
        raise ValueError(
            f"parameter: got {parameter!r}, expected one of {', '.join(PARAMETERS)}"
        )
    if not len(values):
        raise ValueError("values: got none, expected at least one")
    not_numbers = values[~np.isfinite(values)]
    for value in (*not_numbers[:1], values.min(), values.max()):
        check_alpha(with_value(belt, str(parameter), float(value)).alpha)
