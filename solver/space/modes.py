"""The modes of a structure with an attachment, by one of three expansions."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any, overload

import numpy as np

from ..presentation.notebook import of_rows
from ..presentation.table import Table, Tabular, flat
from ..scenes.parameter_error import is_number, whole
from .attached import POSITION, Attached, attach
from .eigenvalues import bounds, secular
from .eigenvalues.exact import ExactModes, exact_modes, of_frequency
from .expansions.bare import BareModes
from .expansions.methods import (
    HIGHEST,
    bare_modes,
    check_forced,
    check_order,
    generic_method,
    shown,
)
from .expansions.shapes import jump_mismatch, shape_of
from .mode import Mode, Shapes
from .structure import Structure, load

#: Default method, order and number of modes.
METHOD, ORDER, COUNT = "ritz-ck", 8, 6

#: Most places of a table of shapes.
MOST_POINTS = 1_000_000

#: Orders that are tried for a tolerance, in this sequence, up to the highest of the method.
TRIED = (*range(1, 17), 20, 24, 28, 32, 40, 48, 64, 80, 96, 128, 192, 256, 384, 512, 1024, 4096)


class ToleranceNotMet(ValueError):  # noqa: N818  (named like the other errors of the package)
    """No order of a method brings all modes within the tolerance."""


@dataclass(frozen=True, eq=False, repr=False)
class Modes(Tabular, Sequence[Mode]):
    """The lowest modes of a structure, by one expansion.

    Parameters
    ----------
    forced : int
        Number of forced modes added to the sines.
    unknowns : int
        Number of unknown coefficients.
    found : tuple of Mode
        The modes.
    exact : ExactModes
        The exact modes of these numbers.
    """

    attached: Attached
    method: str
    order: int
    forced: int
    unknowns: int
    found: tuple[Mode, ...] = field(repr=False)
    exact: ExactModes = field(repr=False)

    @overload
    def __getitem__(self, index: int) -> Mode: ...

    @overload
    def __getitem__(self, index: slice) -> tuple[Mode, ...]: ...

    def __getitem__(self, index: int | slice) -> Mode | tuple[Mode, ...]:
        return self.found[index]

    def __len__(self) -> int:
        return len(self.found)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Modes) and self.as_dict() == other.as_dict()

    def __hash__(self) -> int:
        return hash((self.structure.name, self.method, self.order, len(self)))

    def __repr__(self) -> str:
        head = f"{len(self)} modes of {self.structure.name} by {self.shown}, N = {self.order}"
        return f"<{head}: {self[0].frequency:.10g} to {self[-1].frequency:.10g} Hz>"

    def __str__(self) -> str:
        lines = [f"{'mode':>4}  {'f [Hz]':>13}  {'omega [rad/s]':>13}  {'f/f_ex-1':>9}  proved"]
        for mode in self:
            within = mode.proved_within
            proved = "" if within is None else f"{within:.1e}"
            numbers = f"{mode.frequency:13.9g}  {mode.omega:13.9g}  {mode.error:9.1e}"
            lines.append(f"{mode.number:4d}  {numbers}  {proved}".rstrip())
        return "\n".join(lines)

    def _repr_html_(self) -> str:
        return of_rows(repr(self), str(self), self.plot)

    def plot(
        self, ax: Any = None, quantity: str = "shape", *, number: int = 1, **style: Any
    ) -> Any:
        """Draw one mode above the exact one and return the axes.

        Needs matplotlib, the extra ``plot``.

        Parameters
        ----------
        ax : matplotlib Axes, optional
            Axes to draw in; by default new ones with a legend.
        quantity : {"shape", "discontinuous"}
            The displacement, or the first derivative that jumps: slope, moment or shear force.
        number : int
            Number of the mode, from 1.
        **style
            Style of the line, as for `matplotlib.axes.Axes.plot`.

        Raises
        ------
        ValueError
            If there is no such quantity or mode.
        MissingExtra
            An `ImportError`: if matplotlib is not installed.
        """
        from ...plots.modes import draw  # noqa: PLC0415  (an extra)

        return draw(self, ax, quantity, number=number, **style)

    def table(self) -> Table:
        """Return a row for each mode; `low` and `high` are bounds of the exact eigenvalue."""
        rows = []
        for mode in self:
            row = mode.as_dict()
            row["exact_beta"], row["exact_frequency"] = row.pop("exact").values()
            row["low"], row["high"] = row.pop("bounds")
            rows.append(row)
        about = self.attached.about | self._how | dict(self.attached.values)
        units = {"frequency": "Hz", "exact_frequency": "Hz", "omega": "rad/s"}
        return Table(("number",), flat(rows), units | {"modal_mass": "kg"}, about)

    def shapes(self, points: int = 101) -> Shapes:
        """Return the shapes of all modes at evenly spaced places, with a modal mass of 1 kg.

        Parameters
        ----------
        points : int
            From 2 to 1,000,000, else a ValueError; the ends are two of them.
        """
        points = whole("points", points, 2, MOST_POINTS)
        return Shapes(self.attached, self._how, self.found, points)

    @property
    def _how(self) -> dict[str, Any]:
        """Method, order, forced modes and unknowns, for documents."""
        head = {"method": self.method, "order": self.order, "forced": self.forced}
        return head | {"unknowns": self.unknowns}

    @property
    def structure(self) -> Structure:
        """The structure without its numbers."""
        return self.attached.structure

    @property
    def shown(self) -> str:
        """The method with the class in its name: ``ritz-c1``, with two forced modes (2)."""
        return shown(self.structure, self.method, self.forced)

    def as_dict(self) -> dict[str, Any]:
        """Return structure, method and modes as plain numbers."""
        modes = {"modes": [mode.as_dict() for mode in self]}
        return self.attached.as_dict() | self._how | modes


def modes(
    structure: str | Attached,
    method: str = METHOD,
    order: int | None = None,
    forced: int | None = None,
    count: int | None = None,
    tol: float | None = None,
    position: object = POSITION,
    **parameters: float,
) -> Modes:
    """Return the lowest modes of a beam or a string with one attachment.

    Parameters
    ----------
    structure : str or Attached
        One of ``nonsmooth.structures()``, or ``attached`` of an earlier result.
    method : {"ritz-ck", "ritz", "ck"}
        Sines and forced modes, sines alone, or functions of class C^k only; names with the
        class, such as ``"ritz-c1"``, are allowed.
    order : int, optional
        N: the number of sines, or the degree on each side of the attachment; 8 by default.
    forced : int, optional
        With ``"ritz-ck"``, the number of forced modes, 1 to 3; 1 by default.
    count : int, optional
        The number of modes; by default 6, or all if there are fewer.
    tol : float, optional
        Relative tolerance of frequencies, in place of an order: the lowest order with all of
        them within it is taken.  Errors are bounded by the proved bounds; with ``"ck"``, and
        where none is proved, they are against the exact modes.
    position : str, float or Fraction
        Position of the attachment, relative to the length: ``"3/10"`` or 0.3.
    **parameters : float
        In SI units: ``length``, ``bending_stiffness`` (of a beam) or ``tension`` (of a string),
        ``mass_per_length``, and that of the attachment: ``stiffness``, ``mass``, ``inertia`` or
        ``compliance``.

    Returns
    -------
    Modes
        A sequence of `Mode`.

    Raises
    ------
    ValueError
        If an argument is not allowed.
    ToleranceNotMet
        If no order is within the tolerance.

    Examples
    --------
    >>> import nonsmooth as ns
    >>> found = ns.modes("beam-rotational-spring", position="3/10", stiffness=10)
    >>> round(found[0].beta, 8), f"{found[0].error:.0e}"
    (3.44973697, '6e-11')
    >>> [mode.number for mode in found if mode.node_at_attachment]
    [5]
    """
    attached = structure if isinstance(structure, Attached) else None
    if attached is None:
        attached = attach(load(structure), position, **parameters)  # type: ignore[arg-type]
    elif parameters or position != POSITION:
        raise ValueError("structure: got one with numbers, and parameters beside it")
    method = generic_method(attached.structure, method)
    K = check_forced(attached.structure, method, forced)
    if tol is None:
        return at_order(attached, method, ORDER if order is None else order, K, count)
    if order is not None:
        raise ValueError(f"tol: got {tol!r} with order {order!r}, expected one of them")
    if not is_number(tol) or not 0 < tol < 1:
        raise ValueError(f"tol: got {tol!r}, expected a number above 0 and below 1")
    number = whole("count", COUNT if count is None else count)
    return _within(attached, method, K, number, float(tol))


def _within(attached: Attached, method: str, K: int, count: int, tol: float) -> Modes:
    """Return the modes at the lowest order of `TRIED` with all of them within a tolerance.

    Raises
    ------
    ToleranceNotMet
        If none is.
    """
    highest, reached = HIGHEST[method], math.inf
    for order in (*(q for q in TRIED if q < highest), highest):
        try:
            found = at_order(attached, method, order, K, count)
        except ValueError:
            if order < min(max(count, 2), highest):
                continue  # fewer modes than wanted
            raise
        reached = max(_off(mode) for mode in found)
        if reached <= tol:
            return found
    raise ToleranceNotMet(
        f"tol: got {tol:g}, no order of {shown(attached.structure, method)} is within it; "
        f"order {highest} reaches {reached:.1e}"
    )


def at_order(attached: Attached, method: str, order: int, K: int, count: int | None) -> Modes:
    """Return the modes at an order, by a method and K forced modes that were checked.

    Raises
    ------
    ValueError
        If the order is out of range, or there are fewer modes than wanted.
    """
    bare = bare_modes(attached, method, check_order(method, order), K)
    number = min(COUNT, bare.count) if count is None else whole("count", count)
    if number > bare.count:
        raise ValueError(
            f"count: got {count}, {method} at order {order} has {bare.count} modes; "
            "expected fewer, or a higher order"
        )
    roots = secular.eigenvalues(bare, attached, number)
    exact = exact_modes(attached, number)
    low = np.full(number, np.nan)
    if method != "ck":
        low = bounds.below(attached, order, K, number)
    high = bounds.above(roots)
    modes_ = tuple(
        _mode(attached, bare, roots, exact, i, float(low[i]), float(high[i]))
        for i in range(number)
    )
    return Modes(attached, method, order, K, bare.unknowns, modes_, exact)


def _mode(
    attached: Attached, bare: BareModes, roots: secular.Roots, exact: ExactModes, i: int,
    low: float, high: float,
) -> Mode:  # fmt: skip
    """Return mode `i` with its errors and bounds."""
    shape, eigenvalue = shape_of(attached, bare, roots, i), float(roots.values[i])
    mismatch = None if exact.untouched[i] else jump_mismatch(attached, shape, eigenvalue)
    return Mode(
        number=i + 1,
        eigenvalue=eigenvalue,
        exact_beta=float(exact.beta[i]),
        error=of_frequency(exact.error(roots, i)),
        bounds=(low if math.isfinite(low) else None, high),
        node=int(exact.n[i]) if exact.untouched[i] else None,
        jump_mismatch=mismatch,
        _attached=attached,
        _shape=shape,
    )


def _off(mode: Mode) -> float:
    """Return the proved relative error of a frequency or, without one, the error."""
    return abs(mode.error) if mode.proved_within is None else mode.proved_within
