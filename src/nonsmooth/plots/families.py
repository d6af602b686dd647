"""Families and branches of orbits along a parameter: stability, events, missing orbits."""

import math
from collections.abc import Iterator, Sequence
from itertools import cycle, groupby, pairwise
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.figure import Figure

from nonsmooth.solver.scenes.methods import about, shown

from .axes import (
    axes_or_new,
    check_quantity,
    described,
    frame,
    label_once,
    legend_above,
    mark_values,
    typeset,
)

if TYPE_CHECKING:
    from nonsmooth.solver.arrays import Vector
    from nonsmooth.solver.results.branch import Branch
    from nonsmooth.solver.results.family import Family, FamilyRow
    from nonsmooth.solver.results.strobe import Diagram
    from nonsmooth.solver.scenes.loaded import LoadedScene

#: The quantities that can be drawn, and their axis labels; `times` of one phase has another.
QUANTITIES = {
    "displacement": "ends of the displacement [m]",
    "velocity": "ends of the velocity [m/s]",
    "times": "durations, as parts of the period",
    "estimate": "estimated error of the times",
    "period": "period [s]",
    "amplitude": "amplitude of the displacement [m]",
    "multiplier": "largest |multiplier|",
    "strobe": "displacement once a period of the forcing [m]",
}

#: The line style of orbits that are stable, unstable, neither.
LINES = {True: "-", False: "--", None: ":"}

#: The shades of durations, and of those of unstable orbits.
DARK, PALE = "0.2", "0.65"

#: Parts of a curve of multipliers between two orbits.
PARTS = 16

#: The marker of each kind of event.
MARKS = {
    "fold": "o", "flip": "s", "torus": "D", "branch-point": "^",
    "grazing": "x", "sticking": "+", "vanishing": "v",
}  # fmt: skip


def draw(result: "Family", ax: Any = None, quantity: str = "displacement", **style: Any) -> Any:
    """Draw one quantity of a family or a branch and return the axes; see `Family.plot`.

    Stable orbits are drawn solid, unstable ones dashed.  Events are marked, and on the axis the
    values without an orbit.
    """
    check_quantity(quantity, QUANTITIES)
    axes = axes_or_new(ax)
    color = "0.1" if result.in_turn else about(result.method).look["color"]
    look = {"linewidth": 1.2, "color": color} | style
    if quantity == "times":
        _draw_times(axes, result, style)
    else:
        for column in _columns(result.rows, quantity):
            _lines(axes, result, column, look, pairs=quantity == "multiplier")
            _marks(axes, result, column)
        if quantity == "estimate":
            _scale_errors(axes)
        axes.set_ylabel(QUANTITIES[quantity])
    missing = [row.value for row in result.rows if row.status != "ok"]
    mark_values(axes, missing, "no orbit", "0.4")
    axes.set_xlabel(name_of(result.case.scene, result.parameter))
    if ax is None and quantity != "times":
        legend_above(axes.figure, axes, 4)
    return axes


def _columns(rows: "Sequence[FamilyRow]", quantity: str) -> "Iterator[Vector]":
    """Yield the columns of values that are drawn: two for the ends of an interval, else one."""
    ends = {"displacement": 2, "velocity": 2}.get(quantity, 1)
    for end in range(ends):
        yield np.array([_value(row, quantity, end) for row in rows], dtype=float)


def _value(row: "FamilyRow", quantity: str, end: int) -> float | None:
    if row.extremes is None:
        return None
    low, high = row.extremes["displacement"]
    numbers = {
        "multiplier": row.largest_multiplier,
        "estimate": None if row.estimate is None else row.estimate.times,
        "period": row.period,
        "strobe": None if row.strobe is None else row.strobe[0],
        "amplitude": (high - low) / 2,
    }
    return row.extremes[quantity][end] if quantity in row.extremes else numbers[quantity]


def _lines(
    axes: Any, result: "Family", values: "Vector", look: dict[str, Any], pairs: bool
) -> None:
    """Draw a column as lines by stability, or dots if a value of a family has several.

    With `pairs` the column is the largest multiplier; see `_with_kinks`.
    """
    along = result["value"]
    for stable, run in _runs(result):
        kind = _kind(result, run, LINES[stable], "." if stable else "1")
        name = {True: "stable", False: "unstable", None: "neither, to rounding"}[stable]
        x, y = along[run], values[run]
        if pairs and result.in_turn:
            x, y = _with_kinks(x, y, [result.rows[i].multipliers for i in run])
        axes.plot(x, y, **look | kind | label_once(axes, name))


def _kind(result: "Family", run: list[int], line: str, marker: str) -> dict[str, str]:
    """Return a line style; or a marker if a value of a family has several rows of a run."""
    several = len({result.rows[i].value for i in run}) < len(run) and not result.in_turn
    return {"linestyle": "", "marker": marker} if several else {"linestyle": line}


def _with_kinks(
    x: "Vector", y: "Vector", multipliers: "list[tuple[complex, ...] | None]"
) -> "tuple[Vector, Vector]":
    """Return a curve of largest multipliers with points between those where two are real.

    Where two real multipliers meet, the larger has a vertical tangent; their sum and product
    have none, and are interpolated.
    """
    xs, ys = [x[:1]], [y[:1]]
    parts = np.linspace(0, 1, PARTS + 1)[1:-1]
    for i, ends in enumerate(pairwise(multipliers)):
        pairs = [end for end in ends if end is not None and len(end) == 2]
        if len(pairs) == 2 and not all(pair[0].imag for pair in pairs):
            first, last = (np.array([sum(q).real, math.prod(q).real]) for q in pairs)
            sums, products = np.outer(first, 1 - parts) + np.outer(last, parts)
            root = np.sqrt(sums**2 / 4 - products + 0j)
            xs.append((1 - parts) * x[i] + parts * x[i + 1])
            ys.append(np.maximum(abs(sums / 2 + root), abs(sums / 2 - root)))
        xs.append(x[i + 1 : i + 2])
        ys.append(y[i + 1 : i + 2])
    return np.concatenate(xs), np.concatenate(ys)


def _runs(result: "Family") -> "Iterator[tuple[bool | None, list[int]]]":
    """Yield runs of equal stability; of a branch, each begins with the last row before it."""
    rows = result.rows
    indices = [i for i, row in enumerate(rows) if row.status == "ok"]
    if not result.in_turn:
        for stable in LINES:
            run = [i for i in indices if rows[i].stable is stable]
            if run:
                yield stable, run
        return
    verdicts = [rows[i].stable for i in indices]
    judged = {rows[i].motion for i in indices if rows[i].stable is not None}
    for i in range(1, len(verdicts)):  # unknown at an event: drawn as the orbit before
        if verdicts[i] is None and rows[indices[i]].motion in judged:
            verdicts[i] = verdicts[i - 1]
    if verdicts[:1] == [None] and rows[indices[0]].motion in judged:  # or as that behind it
        verdicts[0] = next(q for q in verdicts if q is not None)
    for stable, group in groupby(range(len(indices)), key=lambda i: verdicts[i]):
        run = list(group)
        yield stable, indices[max(run[0] - 1, 0) : run[-1] + 1]


def _marks(axes: Any, result: "Family", values: "Vector") -> None:
    """Mark the events of a branch."""
    along = result["value"]
    for event in getattr(result, "events", ()):
        hits = along == event.parameter  # two rows where the order of phases changes
        axes.plot(
            along[hits][:1], values[hits][:1], MARKS[event.kind], color="0.1", markersize=6,
            markerfacecolor="none", **label_once(axes, event.kind),
        )  # fmt: skip


def _scale_errors(axes: Any) -> None:
    """Scale errors by their logarithm; of less than a decade more is shown: it is rounding."""
    axes.set_yscale("log")
    low, high = axes.get_ylim()
    if high < 10 * low:
        axes.set_ylim(low / 10, 10 * high)


def name_of(scene: "LoadedScene", name: str) -> str:
    """Return the axis label of a parameter of a scene."""
    parameter = next(q for q in scene.parameters if q.name == name)
    unit = f" [{parameter.unit}]" if parameter.unit else ""
    words = "" if parameter.name == parameter.symbol else f"{parameter.name.replace('_', ' ')} "
    return f"{words}{typeset(parameter.symbol)}{unit}"


def _draw_times(axes: Any, result: "Family", style: dict[str, Any]) -> None:
    """Draw the durations of phases relative to the period; of one, the phase of the forcing.

    Those of unstable orbits are pale.
    """
    names, along = result.case.scene.phases, result["value"]
    kinds = zip(names, cycle(("-", "--", "-.", ":")), strict=False)
    columns = [("", "-", result["forcing_phase"])]
    if len(names) > 1:
        columns = [(name, line, _parts_of_periods(result, name)) for name, line in kinds]
    for name, line, _ in columns:
        if name:
            axes.plot([], [], **{"color": DARK, "linestyle": line, "label": name} | style)
    for stable, run in _runs(result):
        shade = PALE if stable is False else DARK
        for _, line, values in columns:
            look = {"color": shade, "linewidth": 1.2} | _kind(result, run, line, ".") | style
            axes.plot(along[run], values[run], **look)
        if stable is False:
            axes.plot([], [], color=PALE, **label_once(axes, "unstable"))
    axes.set_ylabel(QUANTITIES["times"] if len(names) > 1 else "phase of the forcing [rad]")
    if axes.get_legend_handles_labels()[1]:
        place = {"loc": "lower left", "bbox_to_anchor": (0, 1), "frameon": False}
        axes.legend(**place, ncols=4, fontsize=8)


def _parts_of_periods(result: "Family", name: str) -> "Vector":
    """Return the durations of a phase, as parts of the periods."""
    parts = (
        result.durations_of(q).get(name, np.nan) / (q.period or np.nan) for q in result.rows
    )
    return np.array([*parts])


def family_figure(result: "Family", log: bool = False) -> Figure:
    """Draw the extremes of displacement and velocity, the times, and the estimated error."""
    scene = result.case.scene
    figure = Figure(figsize=(8, 6), layout="constrained")
    panels = figure.subplots(2, 2, sharex=True).ravel()
    for axes, quantity in zip(panels, QUANTITIES, strict=False):
        draw(result, axes, quantity)
    for axes in panels[:2]:
        axes.set_xlabel("")
    if log:
        panels[0].set_xscale("log")
    method = f"{shown(scene, result.method)}, N = {result.order}"
    frame(figure, panels[0], f"{described(result.case, result.parameter)}; {method}")
    return figure


def branch_figure(results: "Sequence[Branch]", diagrams: "Sequence[Diagram]" = ()) -> Figure:
    """Draw the amplitude and the largest multiplier of branches along a parameter.

    With diagrams, the displacement once a period of the forcing replaces the amplitude.
    """
    figure = Figure(figsize=(6, 6), layout="constrained")
    upper, lower = figure.subplots(2, 1, sharex=True, height_ratios=(2, 1))
    for diagram in diagrams:
        look = label_once(upper, "simulated")
        diagram.plot(upper, markersize=3, color="0.6", **look)
    for result in results:
        draw(result, upper, "strobe" if diagrams else "amplitude")
        draw(result, lower, "multiplier")
    lower.axhline(1.0, color="0.7", linewidth=0.8, zorder=0)
    lower.set_ylim(-0.05, 2.0)
    upper.set_xlabel("")
    frame(figure, upper, described(results[0].case, results[0].parameter), columns=5)
    return figure
