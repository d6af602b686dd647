"""`plot` draws any result, or several on the same axes."""

from collections.abc import Sequence
from typing import Any


def plot(result: Any, ax: Any = None, **options: Any) -> Any:
    """Draw a result, or several on the same axes, and return the axes.

    Parameters
    ----------
    result : orbit, sweep, family, modes or simulation, or a sequence of these
        What to draw, by its own ``plot``.
    ax : matplotlib Axes, optional
        Axes to draw in; new ones by default.
    **options
        Passed on to ``result.plot``: ``quantity``, and the style of the lines.

    Raises
    ------
    TypeError
        If a result cannot be drawn.
    MissingExtra
        An `ImportError`: if matplotlib, the extra ``plot``, is not installed.

    Examples
    --------
    >>> import matplotlib; matplotlib.use("agg")
    >>> import nonsmooth as ns
    >>> case = ns.scene("impact")()
    >>> ax = ns.plot([ns.exact(case), ns.solve(case, "hb", 4)], quantity="velocity")
    >>> [line.get_label() for line in ax.lines], ax.get_ylabel()
    (['exact', 'hb, N = 4'], 'velocity [m/s]')
    """
    if hasattr(result, "plot"):
        return result.plot(ax, **options)
    several = isinstance(result, Sequence) and not isinstance(result, str) and len(result) > 0
    if not several or not all(hasattr(each, "plot") for each in result):
        expected = "an orbit, sweep, family, modes or simulation, or several in a sequence"
        raise TypeError(f"result: got {result!r:.80}, expected {expected}")
    from .axes import axes_or_new, legend_above  # noqa: PLC0415

    axes = axes_or_new(ax)
    for each in result:
        each.plot(axes, **options)
    if ax is None:
        legend_above(axes.figure, axes)
    return axes
