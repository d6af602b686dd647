"""Pictures of modes: shapes, what jumps at the attachment, convergence, families."""

from pathlib import Path
from typing import TYPE_CHECKING, Any

import matplotlib as mpl
import numpy as np
from matplotlib.figure import Figure

from nonsmooth.solver.case.methods import about
from nonsmooth.style import EXACT, SETTINGS, save

if TYPE_CHECKING:
    from collections.abc import Sequence

    from nonsmooth.solver.space.convergence import Convergence
    from nonsmooth.solver.space.modes import Modes

    from .vary import Vary

#: The look of each expansion: that of its like in the paper.
LOOKS: dict[str, dict[str, Any]] = {
    "ritz": about("hb").look,
    "ritz-ck": about("hb-ck").look,
    "ck": about("ck").look,
}

#: Markers of one, two, three forced modes.
MARKERS = ("s", "^", "v")

#: Modes whose shapes are drawn, and points of each.
DRAWN, POINTS = 3, 2001

#: Least error that is drawn.
LEAST = 1e-17

UNITS = {"slope": "1/m", "moment": "N", "shear force": "N/m"}


def modes_picture(found: "Sequence[Modes]", target: Path) -> None:
    """Write the figure of some modes as a picture."""
    with mpl.rc_context(SETTINGS):
        save(modes_figure(found), target)


def modes_figure(found: "Sequence[Modes]") -> Figure:
    """Draw mode shapes, and beside each the first discontinuous derivative.

    The exact ones are drawn below them; what is left and right of the attachment is not
    joined.
    """
    attached = found[0].attached
    rows = min(DRAWN, max(map(len, found)))
    figure = Figure(figsize=(8, 1.2 + 2.1 * rows), layout="constrained")
    axes = figure.subplots(rows, 2, squeeze=False, sharex=True)
    x = _places(attached)
    quantity = found[0][0].quantity
    for i in range(rows):
        _draw_exact(axes[i], found, x, i)
        for expansion in found:
            if i >= len(expansion):
                continue
            mode, look = expansion[i], _line(expansion.method)
            label = f"{expansion.shown}, N = {expansion.order}"
            axes[i, 0].plot(x, mode.shape(x), label=label, **look)
            axes[i, 1].plot(x, _apart(attached, x, mode.discontinuous(x)), **look)
        axes[i, 0].set(ylabel=f"mode {i + 1}")
        axes[i, 1].set(ylabel=f"{quantity} [{UNITS[quantity]}]")
        for each in axes[i]:
            each.axvline(float(attached.a) * attached.length, color="0.7", linewidth=0.8)
    axes[0, 0].set(title="shape")
    axes[0, 1].set(title=f"{quantity}, the first that jumps")
    for each in axes[-1]:
        each.set(xlabel="x [m]")
    _label(figure, axes[0, 0], found[0])
    return figure


def _places(attached: Any) -> Any:
    """Return places along the structure, dense beside the attachment."""
    a, length = float(attached.a), attached.length
    even = np.linspace(0, 1, POINTS)
    near = a + np.concatenate([-np.geomspace(1e-9, 0.05, 300), np.geomspace(1e-9, 0.05, 300)])
    found = np.concatenate([even[even != a], near[(near > 0) & (near < 1)]])
    return np.clip(np.sort(found) * length, 0, length)


def _apart(attached: Any, x: Any, values: Any) -> Any:
    """Return values with a gap at the attachment."""
    found = np.array(values)
    place = int(np.searchsorted(x, float(attached.a) * attached.length))
    found[min(place, len(found) - 1)] = np.nan
    return found


def _draw_exact(axes: Any, found: "Sequence[Modes]", x: Any, i: int) -> None:
    """Draw the exact mode with the scale and the sign of the first expansion's."""
    expansion = next(each for each in found if i < len(each))
    attached, structure = expansion.attached, expansion.structure
    length, broken = attached.length, structure.broken
    middle = (np.arange(2000) + 0.5) / 2000
    u = expansion.exact.shape(i + 1, middle, 0)
    sign = np.sign(u @ expansion[i].shape(middle * length)) or 1.0
    scale = sign / np.sqrt(np.mean(u**2))
    shape = scale * expansion.exact.shape(i + 1, x / length, 0)
    jumps = scale * expansion.exact.shape(i + 1, x / length, broken) / length**broken
    factor = attached.restoring if broken > 1 else 1.0
    style = EXACT | {"color": "0.7", "linewidth": 3.0}
    axes[0].plot(x, shape, label="exact", **style)
    axes[1].plot(x, _apart(attached, x, factor * jumps), **style)


def _line(method: str) -> dict[str, Any]:
    look = LOOKS[method]
    return {"color": look["color"], "linestyle": look["linestyle"], "linewidth": 1.4}


def _label(figure: Figure, axes: Any, expansion: Any) -> None:
    handles, labels = axes.get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside upper center", ncols=4, frameon=False)
    words = f"{expansion.structure.name}: {expansion.attached.description}"
    figure.supxlabel(words, fontsize=7, wrap=True)


def convergence_picture(study: "Convergence", target: Path) -> None:
    """Write the figure of a study as a picture."""
    with mpl.rc_context(SETTINGS):
        save(convergence_figure(study), target)


def convergence_figure(study: "Convergence") -> Figure:
    """Draw the errors of eigenvalue and discontinuous derivative against the unknowns."""
    figure = Figure(figsize=(8, 4.2), layout="constrained")
    both = figure.subplots(1, 2)
    broken = "u" + "'" * study.attached.structure.broken
    titles = {
        "eigenvalue_error": r"error of $\lambda$",
        "discontinuous": f"error of ${broken}$",
    }
    for axes, (name, title) in zip(both, titles.items(), strict=True):
        for line in study.lines:
            rows = study.of(line)
            look = LOOKS[line.method] | {"markersize": 4, "linewidth": 0.9}
            if line.forced:
                look |= {"marker": MARKERS[line.forced - 1]}
            axes.loglog(
                [row.unknowns for row in rows],
                [max(abs(getattr(row, name)), LEAST) for row in rows],
                label=line.name(study.attached), **look,
            )  # fmt: skip
        axes.set(xlabel="unknowns", ylabel=title, title=f"{title}, mode {study.number}")
    handles, labels = both[0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside upper center", ncols=5, frameon=False)
    structure = study.attached.structure
    words = f"{structure.name}: {study.attached.description}"
    figure.supxlabel(words, fontsize=7, wrap=True)
    return figure


def family_picture(over: "Vary", found: "Sequence[Modes]", target: Path) -> None:
    """Write the figure of modes over a parameter as a picture."""
    with mpl.rc_context(SETTINGS):
        save(family_figure(over, found), target)


def family_figure(over: "Vary", found: "Sequence[Modes]") -> Figure:
    """Draw the wave numbers over a parameter, in units of pi: integers without attachment."""
    figure = Figure(figsize=(8, 4.2), layout="constrained")
    axes = figure.subplots()
    for i in range(min(map(len, found))):
        beta = [expansion[i].beta / np.pi for expansion in found]
        axes.plot(over.values, beta, marker=".", linewidth=1.0, label=f"mode {i + 1}")
    if over.log:
        axes.set_xscale("log")
    axes.set(xlabel=over.name, ylabel=r"$\beta/\pi$")
    axes.set_yticks(range(int(axes.get_ylim()[1]) + 1))
    figure.legend(loc="outside right center", frameon=False)
    expansion = found[0]
    words = f"{expansion.structure.name} by {expansion.shown}, N = {expansion.order}"
    said = expansion.attached.described(over.name.replace("-", "_"))
    figure.supxlabel(f"{words}: {said}", fontsize=7, wrap=True)
    return figure
