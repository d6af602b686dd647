"""The figures and numbers of a scene's page for notebooks, as in the gallery."""

from collections.abc import Callable
from typing import Any

import matplotlib as mpl
import matplotlib.pyplot as plt

from nonsmooth.plots.axes import SETTINGS
from nonsmooth.scene import find
from nonsmooth.solver.accuracy.rates import slope
from nonsmooth.solver.exact import exact_orbit
from nonsmooth.solver.scenes.case import Case
from nonsmooth.solver.scenes.methods import about

from .collected import Collected, collect, curve, rate_of_times, ways
from .scene_figures import FIGURES
from .scene_page import rates


def page_of(case: Case, done: Callable[[str], None] = lambda what: None) -> Collected:
    """Return the results on the page of a case, for the motion of its exact orbit."""
    exact = exact_orbit(case)
    return collect(exact.case, exact, done)


def show(results: Collected, *names: str) -> None:
    """Draw figures of a page side by side; `names` are keys of `FIGURES`."""
    with mpl.rc_context(SETTINGS):
        size = (4.6 * len(names), 3.4)
        figure = plt.figure(figsize=size, layout="constrained")
        axes = figure.subplots(1, len(names), squeeze=False)[0]
        for place, name in zip(axes, names, strict=True):
            draw, _ = FIGURES[name]
            draw(place, results)
        plt.show()


def table_of_rates(results: Collected) -> str:
    """Return a table of measured rates and those of theory, as text."""
    names = ("name", "times", "times_theory", "discontinuous", "discontinuous_theory")
    rows: list[tuple[str, ...]] = [("expansion", "times", "theory", "jump", "theory")]
    rows += [tuple(row[name] for name in names) for row in rates(results)]
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    return "\n".join(
        "  ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True)).rstrip()
        for row in rows
    )


def overshoots(results: Collected) -> str:
    """Return a table of the overshoots of the expansions, as text."""
    orders = {name: orbit.order for name, orbit in results.ringing.items()}
    return "\n".join(
        f"{name:16} N = {orders[name]:2}: {round(most, 2) + 0.0:6.2f} %"  # not -0.00
        for name, most in results.beyond.items()
    )


def thesis(names: list[str], orders: tuple[int, ...] = (8, 11, 16, 22, 32)) -> Any:
    """Return rates of the times by class and number of functions: the thesis of the paper.

    Parameters
    ----------
    names : list of str
        Names of scenes.
    orders : tuple of int
        The orders to which the rates are fitted.

    Returns
    -------
    list of tuple
        Scene, class, functions (0: a plain Fourier series), measured power of 1/N, theory.
    """
    rows = []
    for name in names:
        case = exact_orbit(find(name)()).case
        for way in ways(case):
            if not about(way.method).power:
                continue
            errors = [(N, each.times) for N, each in curve(case, way, orders).items()]
            measured = slope(errors, 0.0, power=True, fewest=2)
            expected = rate_of_times(case, way.functions or 0)
            rows.append((name, f"C{case.scene.k}", way.functions or 0, measured, expected))
    return rows
