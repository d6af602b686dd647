"""How pictures look: axes to draw on, the frame of a figure, and how figures are written."""

from collections.abc import Callable, Collection, Mapping, Sequence
from pathlib import Path
from typing import IO, Any

import matplotlib as mpl
import numpy as np
from matplotlib.figure import Figure

#: The look of every picture, and that of an exact orbit in it.
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

#: Least error that is drawn: below it is rounding, and for 0 there is no place on the axis.
LEAST = float(np.finfo(float).eps) / 2

#: Names of Greek letters that symbols have.
GREEK = frozenset(
    (
        *("alpha", "beta", "gamma", "delta", "epsilon", "zeta", "eta", "theta", "iota"),
        *("kappa", "lambda", "mu", "nu", "xi", "pi", "rho", "sigma", "tau", "phi", "chi"),
        *("psi", "omega", "Gamma", "Delta", "Theta", "Lambda", "Xi", "Pi", "Sigma", "Phi"),
        *("Psi", "Omega"),
    )
)


def axes_or_new(ax: Any) -> Any:
    """Return axes to draw on: those given, or new ones in the style of all pictures."""
    if ax is not None:
        return ax
    import matplotlib.pyplot as plt  # noqa: PLC0415  (it chooses a window system)

    with mpl.rc_context(SETTINGS):
        return plt.subplots(layout="constrained")[1]


def panel(draw: Callable[[Any], Any], size: tuple[float, float]) -> Figure:
    """Return a figure of so many inches with one pair of axes, drawn on by a function."""
    figure = Figure(figsize=size, layout="constrained")
    draw(figure.subplots())
    return figure


def check_quantity(quantity: object, known: Collection[str]) -> None:
    """Check that what is to be drawn is one of those that can be.

    A `ValueError` is raised if it is not.
    """
    if quantity not in known:
        raise ValueError(f"quantity: got {quantity!r}, expected one of {', '.join(known)}")


def typeset(symbol: str) -> str:
    r"""Return a symbol as matplotlib typesets it.

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
    """Return the scene and the parameters of a case in a line, `but` for some of them."""
    values = [
        f"{typeset(q.symbol)} = {case.values[q.name]:.4g} {q.unit}".rstrip()
        for q in case.scene.parameters
        if q.name not in but
    ]
    cycles = [f"{case.cycles} cycles of the forcing"] if case.cycles > 1 else []
    return f"{case.scene.name}: {', '.join([*values, *cycles])}"


def curve(look: Mapping[str, Any]) -> dict[str, Any]:
    """Return the look of a curve without markers, of a method with this look."""
    return {"color": look["color"], "linestyle": look["linestyle"], "linewidth": 1.4}


def mark_values(axes: Any, values: Sequence[float], words: str, color: str) -> None:
    """Mark the values of a parameter, on its axis, at which there is nothing to draw."""
    if values:
        axes.plot(
            values, np.zeros(len(values)), "|", color=color, clip_on=False,
            transform=axes.get_xaxis_transform(), label=words,
        )  # fmt: skip


def draw_errors(axes: Any, orders: Any, errors: Any, **look: Any) -> None:
    """Draw errors against the order on logarithmic axes; those below `LEAST` at `LEAST`."""
    sizes = [np.nan if np.isnan(error) else max(abs(error), LEAST) for error in errors]
    axes.plot(orders, sizes, **{"markersize": 4, "linewidth": 0.9} | look)
    axes.set(yscale="log", xlabel="order $N$")
    axes.xaxis.get_major_locator().set_params(integer=True)


def frame(figure: Figure, axes: Any, words: str, columns: int = 3) -> None:
    """Put the legend of one pair of axes above a figure, and words below it."""
    legend_above(figure, axes, columns)
    say_below(figure, words)


def say_below(figure: Figure, words: str) -> None:
    """Put words below a figure: what it is of."""
    figure.supxlabel(words, fontsize=7, wrap=True)


def legend_above(figure: Any, axes: Any, columns: int = 3) -> None:
    """Put the legend of one pair of axes above a figure, beside no curve."""
    handles, labels = axes.get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside upper center", ncols=columns, frameon=False)


def write(figure: Callable[[], Figure], *targets: Path, look: Any = SETTINGS) -> None:
    """Write what a function draws as a picture, in the formats that the endings name."""
    with mpl.rc_context(look):
        drawn = figure()
        for target in targets:
            save(drawn, target)


def save(figure: Figure, target: Path) -> None:
    """Write the figure without a date: the same input gives the same bytes.

    With `SETTINGS` in force.
    """
    metadata = {".svg": {"Date": None}, ".pdf": {"CreationDate": None}}
    figure.savefig(target, dpi=150, metadata=metadata.get(target.suffix.lower()))


def on_axes(draw: Callable[[Any], Any], size: tuple[float, float], target: IO[str]) -> None:
    """Write what a function draws on one pair of axes as SVG."""
    with mpl.rc_context(SETTINGS):
        panel(draw, size).savefig(target, format="svg", metadata={"Date": None})
