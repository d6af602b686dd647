"""Modes of structures: shapes, discontinuous derivatives, convergence, families."""

import math
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.figure import Figure

from nonsmooth.solver.scenes.methods import about

from .axes import (
    EXACT,
    LEAST,
    axes_or_new,
    check_quantity,
    curve,
    frame,
    legend_above,
    say_below,
)

if TYPE_CHECKING:
    from collections.abc import Sequence

    from nonsmooth.solver.space.convergence import Convergence
    from nonsmooth.solver.space.modes import Modes

#: The look of each expansion: that of the corresponding method.
LOOKS: dict[str, dict[str, Any]] = {
    "ritz": about("hb").look,
    "ritz-ck": about("hb-ck").look,
    "ck": about("ck").look,
}

#: Markers for one, two and three forced modes.
MARKERS = ("s", "^", "v")

#: Most modes that are drawn at once, modes in one column before there are more, and points of
#: each.
MOST, BELOW, POINTS = 100, 6, 2001

#: The quantities of a mode that can be drawn.
QUANTITIES = ("shape", "discontinuous")

#: The errors of a study, and their axis labels.
ERRORS = {"eigenvalue_error": r"error of $\lambda$", "discontinuous": "error of ${broken}$"}

UNITS = {"slope": "1/m", "moment": "N", "shear force": "N/m"}


def draw(
    modes: "Modes", ax: Any = None, quantity: str = "shape", *, number: int = 1, **style: Any
) -> Any:
    """Draw one mode over the exact one and return the axes; see `Modes.plot`.

    The exact one is scaled to the other.  Curves are interrupted at the attachment if they
    jump there.
    """
    check_quantity(quantity, QUANTITIES)
    _check_number(modes, number)
    axes = axes_or_new(ax)
    draw_exact(modes, axes, quantity, number)
    _draw_mode(modes, axes, quantity, number, style)
    if ax is None:
        axes.set_xlabel("$x$ [m]")
        legend_above(axes.figure, axes)
    return axes


def _check_number(modes: "Modes", number: object) -> None:
    whole = isinstance(number, int) and not isinstance(number, bool)
    if not (whole and 1 <= number <= len(modes)):  # type: ignore[operator]
        raise ValueError(f"number: got {number!r}, expected that of a mode, 1 to {len(modes)}")


def _draw_mode(
    modes: "Modes", axes: Any, quantity: str, number: int, style: dict[str, Any]
) -> None:
    mode, x, attached = modes[number - 1], _places(modes.attached), modes.attached
    label = f"{modes.shown}, N = {modes.order}"
    look = {"label": label} | curve(LOOKS[modes.method]) | style
    if quantity == "shape":
        axes.plot(x, mode.shape(x), **look)
        axes.set_ylabel(f"mode {number}")
    else:
        axes.plot(x, _apart(attached, x, mode.discontinuous(x)), **look)
        axes.set_ylabel(f"{mode.quantity} [{UNITS[mode.quantity]}]")
    axes.axvline(float(attached.a) * attached.length, color="0.7", linewidth=0.8)


def modes_figure(expansions: "Sequence[Modes]") -> Figure:
    """Draw mode shapes, and beside each the first discontinuous derivative.

    The exact ones are drawn as wide lines behind them.  The modes are in one pair of columns,
    or, if there are many, in several.  A `ValueError` is raised if there are more than `MOST`.
    """
    count = max(map(len, expansions))
    if count > MOST:
        raise ValueError(f"count: got {count}, expected at most {MOST} in a picture")
    pairs = math.ceil(math.sqrt(count / BELOW))
    rows = math.ceil(count / pairs)
    figure = Figure(figsize=(8 * pairs, 1.2 + 1.9 * rows), layout="constrained")
    axes = figure.subplots(rows, 2 * pairs, squeeze=False, sharex=True)
    panels = axes.reshape(rows, pairs, 2).swapaxes(0, 1).reshape(-1, 2)  # down each column
    titles = ("shape", f"{expansions[0][0].quantity}, the first that jumps")
    for number, pair in enumerate(panels[:count], 1):
        _draw_pair(expansions, pair, number)
        for panel, title in zip(pair, titles, strict=True):
            if (number - 1) % rows == 0:
                panel.set(title=title)
            if number % rows == 0 or number == count:
                panel.set(xlabel="$x$ [m]")
                panel.tick_params(labelbottom=True)
    for panel in panels[count:].flat:
        panel.remove()
    figure.align_ylabels()
    words = f"{expansions[0].structure.name}: {expansions[0].attached.described()}"
    frame(figure, axes[0, 0], words, 4)
    return figure


def _draw_pair(expansions: "Sequence[Modes]", pair: Any, number: int) -> None:
    """Draw one mode, and its discontinuous derivative, of each expansion that has this mode."""
    with_mode = [expansion for expansion in expansions if number <= len(expansion)]
    for panel, quantity in zip(pair, QUANTITIES, strict=True):
        draw_exact(with_mode[0], panel, quantity, number)
        for expansion in with_mode:
            _draw_mode(expansion, panel, quantity, number, {})


def _places(attached: Any) -> Any:
    """Return places along the structure, refined near the attachment."""
    a, length = float(attached.a), attached.length
    even = np.linspace(0, 1, POINTS)
    near = a + np.concatenate([-np.geomspace(1e-9, 0.05, 300), np.geomspace(1e-9, 0.05, 300)])
    places = np.concatenate([even[even != a], near[(near > 0) & (near < 1)]])
    return np.clip(np.sort(places) * length, 0, length)


def _apart(attached: Any, x: Any, values: Any) -> Any:
    """Return values with a NaN at the attachment, which interrupts the curve."""
    interrupted = np.array(values)
    place = int(np.searchsorted(x, float(attached.a) * attached.length))
    interrupted[min(place, len(interrupted) - 1)] = np.nan
    return interrupted


def draw_exact(modes: "Modes", axes: Any, quantity: str, number: int) -> None:
    """Draw the exact mode behind all curves, with scale and sign of the expansion's mode.

    A curve that is on the axes already is not drawn again; only the first is in the legend.
    """
    attached, x = modes.attached, _places(modes.attached)
    length, broken = attached.length, modes.structure.broken
    middle = (np.arange(2000) + 0.5) / 2000
    u = modes.exact.shape(number, middle, 0)
    sign = np.sign(u @ modes[number - 1].shape(middle * length)) or 1.0
    scale = sign / np.sqrt(np.mean(u**2))
    if quantity == "shape":
        values = scale * modes.exact.shape(number, x / length, 0)
    else:
        jumps = scale * modes.exact.shape(number, x / length, broken) / length**broken
        factor = attached.restoring if broken > 1 else 1.0
        values = _apart(attached, x, factor * jumps)
    before = [line for line in axes.lines if line.get_gid() == "exact"]
    if any(_is_same(line, x, values) for line in before):
        return
    style = EXACT | {"color": "0.7", "linewidth": 3.0, "zorder": 1.9, "gid": "exact"}
    axes.plot(x, values, label="_exact" if before else "exact", **style)


def _is_same(line: Any, x: Any, values: Any) -> bool:
    """Return whether a line has these points, to rounding."""
    return np.array_equal(line.get_xdata(), x) and np.allclose(
        line.get_ydata(), values, rtol=1e-9, atol=0, equal_nan=True
    )


def draw_convergence(
    study: "Convergence", ax: Any = None, quantity: str = "eigenvalue_error", **style: Any
) -> Any:
    """Draw one of `ERRORS` of a study against the number of unknowns, a line per expansion.

    Return the axes; new ones have a legend.
    """
    check_quantity(quantity, ERRORS)
    axes = axes_or_new(ax)
    for line in study.lines:
        rows = study.of(line)
        look = LOOKS[line.method] | {"markersize": 4, "linewidth": 0.9}
        if line.forced:
            look |= {"marker": MARKERS[line.forced - 1]}
        axes.loglog(
            [row.unknowns for row in rows],
            [max(abs(getattr(row, quantity)), LEAST) for row in rows],
            **look | {"label": line.name(study.attached)} | style,
        )
    broken = "u" + "'" * study.attached.structure.broken
    axes.set(xlabel="unknowns", ylabel=ERRORS[quantity].replace("{broken}", broken))
    if ax is None:
        legend_above(axes.figure, axes)
    return axes


def convergence_figure(study: "Convergence") -> Figure:
    """Draw the errors of eigenvalue and discontinuous derivative against the unknowns."""
    figure = Figure(figsize=(8, 4.2), layout="constrained")
    panels = figure.subplots(1, 2)
    for axes, quantity in zip(panels, ERRORS, strict=True):
        draw_convergence(study, axes, quantity)
        axes.set_title(f"{axes.get_ylabel()}, mode {study.number}")
    words = f"{study.attached.structure.name}: {study.attached.described()}"
    frame(figure, panels[0], words, 5)
    return figure


def family_figure(
    name: str, values: "Sequence[float]", expansions: "Sequence[Modes]", log: bool = False
) -> Figure:
    """Draw the angular frequencies against a parameter."""
    figure = Figure(figsize=(8, 4.2), layout="constrained")
    axes = figure.subplots()
    for i in range(min(map(len, expansions))):
        omega = [expansion[i].omega for expansion in expansions]
        axes.plot(values, omega, marker=".", linewidth=1.0, label=f"mode {i + 1}")
    if log:
        axes.set_xscale("log")
    axes.set(xlabel=name, ylabel=r"$\omega$ [rad/s]", yscale="log")
    figure.legend(loc="outside right center", frameon=False)
    expansion = expansions[0]
    words = f"{expansion.structure.name} by {expansion.shown}, N = {expansion.order}"
    parameters = expansion.attached.described(name.replace("-", "_"))
    say_below(figure, f"{words}: {parameters}")
    return figure
