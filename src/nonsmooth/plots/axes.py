"""The style of plots: axes to draw on, legend and caption of a figure, and files of figures."""

from collections.abc import Callable, Collection, Mapping, Sequence
from pathlib import Path
from typing import IO, Any

import matplotlib as mpl
import numpy as np
from matplotlib.figure import Figure

#: The style of all plots, and the look of exact orbits.
SETTINGS: Any = {
    "font.size": 9,
    "axes.grid": True,
    "grid.alpha": 0.3,
    "axes.axisbelow": True,
    "agg.path.chunksize": 5000,  # a line of many points takes less than a second
    "svg.hashsalt": "nonsmooth",
    "svg.fonttype": "path",
}
EXACT: dict[str, Any] = {"color": "0.25", "linestyle": "-", "linewidth": 1.0}

#: Least error that is drawn: smaller ones are rounding, and log axes have no 0.
LEAST = float(np.finfo(float).eps) / 2

#: Names of Greek letters in symbols.
GREEK = frozenset(
    (
        *("alpha", "beta", "gamma", "delta", "epsilon", "zeta", "eta", "theta", "iota"),
        *("kappa", "lambda", "mu", "nu", "xi", "pi", "rho", "sigma", "tau", "phi", "chi"),
        *("psi", "omega", "Gamma", "Delta", "Theta", "Lambda", "Xi", "Pi", "Sigma", "Phi"),
        *("Psi", "Omega"),
    )
)


def axes_or_new(ax: Any) -> Any:
    """Return the given axes, or new ones in the style of all plots."""
    if ax is not None:
        return ax
    import matplotlib.pyplot as plt  # noqa: PLC0415  (it chooses a window system)

    with mpl.rc_context(SETTINGS):
        return plt.subplots(layout="constrained")[1]


def panel(draw: Callable[[Any], Any], size: tuple[float, float]) -> Figure:
    """Return a figure with one pair of axes on which `draw` has drawn; `size` is in inches."""
    figure = Figure(figsize=size, layout="constrained")
    draw(figure.subplots())
    return figure


def check_quantity(quantity: object, known: Collection[str]) -> None:
    """Raise a `ValueError` if `quantity` is not one of the known ones."""
    if quantity not in known:
        raise ValueError(f"quantity: got {quantity!r}, expected one of {', '.join(known)}")


def typeset(symbol: str) -> str:
    r"""Return a symbol in the TeX notation of matplotlib.

    Examples
    --------
    >>> typeset("Omega"), typeset("mu_s"), typeset("F_0"), typeset("left")
    ('$\\Omega$', '$\\mu_{s}$', '$F_{0}$', '$\\mathrm{left}$')
    """
    head, _, index = (_letters(part) for part in symbol.partition("_"))
    return f"${head}_{{{index}}}$" if index else f"${head}$"


def _letters(name: str) -> str:
    if name in GREEK:
        return f"\\{name}"
    return rf"\mathrm{{{name}}}" if len(name) > 1 else name


def described(case: Any, *but: str) -> str:
    """Return the scene and the parameters of a case, except those in `but`, as one line."""
    values = [
        f"{typeset(q.symbol)} = {case.values[q.name]:.4g} {q.unit}".rstrip()
        for q in case.scene.parameters
        if q.name not in but
    ]
    cycles = [f"{case.cycles} cycles of the forcing"] if case.cycles > 1 else []
    return f"{case.scene.name}: {', '.join([*values, *cycles])}"


def curve(look: Mapping[str, Any]) -> dict[str, Any]:
    """Return the look of a method, without its markers, for a curve."""
    return {"color": look["color"], "linestyle": look["linestyle"], "linewidth": 1.4}


def mark_values(axes: Any, values: Sequence[float], words: str, color: str) -> None:
    """Mark values of a parameter without a result on its axis; `words` is the label."""
    if values:
        axes.plot(
            values, np.zeros(len(values)), "|", color=color, clip_on=False,
            transform=axes.get_xaxis_transform(), **label_once(axes, words),
        )  # fmt: skip


def label_once(axes: Any, name: str) -> dict[str, str]:
    """Return the label of a line; none if another line has it already."""
    return {} if name in {line.get_label() for line in axes.lines} else {"label": name}


def draw_errors(axes: Any, orders: Any, errors: Any, **look: Any) -> None:
    """Draw errors against the order, with a log scale; those below `LEAST` at `LEAST`."""
    sizes = [np.nan if np.isnan(error) else max(abs(error), LEAST) for error in errors]
    axes.plot(orders, sizes, **{"markersize": 4, "linewidth": 0.9} | look)
    axes.set(yscale="log", xlabel="order $N$")
    axes.xaxis.get_major_locator().set_params(integer=True)


def frame(figure: Figure, axes: Any, words: str, columns: int = 3) -> None:
    """Put the legend of one pair of axes above a figure, and a caption below it."""
    legend_above(figure, axes, columns)
    say_below(figure, words)


def say_below(figure: Figure, words: str) -> None:
    """Put a caption below a figure."""
    figure.supxlabel(words, fontsize=7, wrap=True)


def legend_above(figure: Any, axes: Any, columns: int = 3) -> None:
    """Put the legend of one pair of axes above a figure, where it covers no curve.

    It has fewer columns where it would be wider than the figure.
    """
    handles, labels = axes.get_legend_handles_labels()
    place = {"loc": "outside upper center", "frameon": False}
    legend = figure.legend(handles, labels, ncols=columns, **place)
    while columns > 1 and legend.get_window_extent().width > figure.bbox.width:
        legend.remove()
        columns -= 1
        legend = figure.legend(handles, labels, ncols=columns, **place)


def write(figure: Callable[[], Figure], *targets: Path, look: Any = SETTINGS) -> None:
    """Write the figure that a function makes, to each target in the format of its suffix.

    It is written without a date, so that the same input gives the same bytes.
    """
    metadata = {".svg": {"Date": None}, ".pdf": {"CreationDate": None}}
    with mpl.rc_context(look):
        drawn = figure()
        for target in targets:
            drawn.savefig(target, dpi=150, metadata=metadata.get(target.suffix.lower()))


def on_axes(draw: Callable[[Any], Any], size: tuple[float, float], target: IO[str]) -> None:
    """Write a figure with one pair of axes, on which `draw` draws, as SVG."""
    with mpl.rc_context(SETTINGS):
        panel(draw, size).savefig(target, format="svg", metadata={"Date": None})
