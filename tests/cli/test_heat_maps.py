"""The heat maps of `nonsmooth digits`, read back: cells, words, ticks, titles."""

from collections.abc import Iterator

import numpy as np
import pytest

pytest.importorskip("matplotlib")

from matplotlib.collections import QuadMesh

from nonsmooth.cli.shortcuts.heat_maps import heat_maps
from nonsmooth.shortcuts.digits import Cell, Form

NONE = Form("no-orbit", None, None, 3)
LOST = Form("not-converged", None, 1e9, 40)


def kept(digits: float, status: str = "ok") -> Form:
    return Form(status, 10.0**-digits, 1e3, 5)


#: The digits of each form, by method, alpha and order; some cells are not measured.
CELLS = [
    Cell("hb", 0.1, 10, kept(15.1), kept(11.2)),
    Cell("hb", 0.1, 20, kept(14.2), kept(7.3, "helped")),
    Cell("hb", 3.0, 10, kept(13.4), LOST),
    Cell("c1", 1e-6, 5, kept(15.6), kept(9.4)),
    Cell("c1", 1.0, 5, NONE, NONE),
    Cell("c1", 1.0, 7, LOST, kept(2.7)),
]

#: Titles, alphas, orders, and what the cells say: rows are alphas, columns orders.
EXPECTED = [
    ("hb: Fourier series (3.1)", "stable", ["0.1", "3"], ["10", "20"], "15 14 / 13 —"),
    ("hb: Fourier series (3.1)", "printed", ["0.1", "3"], ["10", "20"], "11 7 / × —"),
    ("c1: $C^1$ functions (3.3)", "stable", ["1e-06", "1"], ["5", "7"], "16 — / — ×"),
    ("c1: $C^1$ functions (3.3)", "printed", ["1e-06", "1"], ["5", "7"], "9 — / — 3"),
]

TITLES = {"stable": "stable forms (the kernels)", "printed": "as printed, SI units"}


@pytest.fixture(scope="module")
def figure():
    return heat_maps(CELLS)


def maps(figure) -> Iterator[tuple]:
    found = [axes for axes in figure.axes if axes.get_title()]
    return zip(found, EXPECTED, strict=True)


def test_each_map_has_the_digits_of_its_method_and_form(figure) -> None:
    for axes, (method, form, alphas, orders, words) in maps(figure):
        assert axes.get_title() == f"{method}\n{TITLES[form]}"
        assert (axes.get_xlabel(), axes.get_ylabel()) == ("order N", r"$\alpha$")
        assert [tick.get_text() for tick in axes.get_yticklabels()] == alphas
        assert [tick.get_text() for tick in axes.get_xticklabels()] == orders
        assert axes.get_xticks().tolist() == axes.get_yticks().tolist() == [0.5, 1.5]
        grid = np.full((2, 2), "", dtype=object)
        for text in axes.texts:
            x, y = text.get_position()
            grid[int(y), int(x)] = text.get_text()
        assert " / ".join(" ".join(row) for row in grid) == words


def test_the_colour_of_a_cell_is_that_of_its_digits(figure) -> None:
    for axes, (method, form, alphas, orders, _) in maps(figure):
        (mesh,) = (c for c in axes.collections if isinstance(c, QuadMesh))
        assert (mesh.norm.vmin, mesh.norm.vmax) == (0, 16)
        drawn = np.ma.filled(mesh.get_array().astype(float), np.nan)
        expected = np.full((2, 2), np.nan)
        for cell in CELLS:
            if not method.startswith(cell.method + ":"):
                continue
            result = getattr(cell, form)
            if result.status != "no-orbit":
                place = alphas.index(f"{cell.alpha:g}"), orders.index(str(cell.order))
                expected[place] = 0 if result.digits is None else result.digits
        np.testing.assert_allclose(drawn, expected)


def test_the_scale_and_the_signs_are_explained(figure) -> None:
    (bar,) = (axes for axes in figure.axes if not axes.get_title())
    assert bar.get_ylabel() == "digits of t1 and T, relative to T"
    assert figure.get_supxlabel() == (
        "—: no orbit at this order, slip not resolved, or not measured;  ×: no convergence"
    )


def test_words_can_be_read_on_their_colour(figure) -> None:
    for axes, _ in maps(figure):
        (mesh,) = (c for c in axes.collections if isinstance(c, QuadMesh))
        colours = mesh.cmap(mesh.norm(mesh.get_array())).reshape(2, 2, 4)
        for text in axes.texts:
            x, y = text.get_position()
            if text.get_text() == "—":
                continue
            light = float(colours[int(y), int(x), :3] @ (0.299, 0.587, 0.114))
            assert abs(light - float(text.get_color())) > 0.4
