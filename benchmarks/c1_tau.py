"""The C1 series with the paper's tests and with Legendre's: the table of docs/tradeoff.md.

    python -m benchmarks.c1_tau [-o docs/c1_tau.svg]

The default oscillator.  Beside the errors of the times, a part of the period, the two factors
that bound them: what is left of the equation of motion in slip, and how far the response at the
end of slip to a push during slip is from all tests.  Both by Gauss's rule, relative, in L2.
"""

import argparse
from dataclasses import dataclass
from pathlib import Path

import numpy as np

import nonsmooth as ns
from nonsmooth.solver.case.registry import load
from nonsmooth.solver.shortcuts.orbit import exact
from nonsmooth.solver.shortcuts.orbit.methods import METHODS
from nonsmooth.solver.shortcuts.orbit.oscillator import DEFAULT
from nonsmooth.solver.solve import solve_case

ORDERS = range(3, 17)

#: Nodes of Gauss's rule over slip, for polynomials of degree 2 (N + 2) times a wave.
_x, _w = np.polynomial.legendre.leggauss(80)
NODES, WEIGHTS = (1 + _x) / 2, _w / 2


@dataclass(frozen=True)
class Row:
    """One series at one order: errors, and what bounds them."""

    order: int
    period: float
    times: float
    residual: float
    distance: float


NAMES = ("period", "times", "residual", "distance")


def norm(values: np.ndarray) -> float:
    """Return the norm over slip."""
    return float(np.sqrt(WEIGHTS @ values**2))


def distance(slip: float, tests: np.ndarray) -> float:
    """Return how far displacement and velocity at the end, by a push at u, are from the tests.

    The larger of both: of ``sin`` and ``cos`` of what is left of slip after the push.
    """
    weights = np.sqrt(WEIGHTS)
    basis, _ = np.linalg.qr((tests * weights).T)
    found = []
    for response in (np.sin(slip * (1 - NODES)), np.cos(slip * (1 - NODES))):
        rest = response * weights
        for _ in range(2):  # twice, or rounding would be left
            rest = rest - basis @ (basis.T @ rest)
        found.append(float(np.linalg.norm(rest)) / norm(response))
    return max(found)


def paper(N: int) -> Row:
    """Return the series of Section 3.3: tests ``u**2`` times polynomials of degree N."""
    orbit = ns.solve(DEFAULT, "c1", N, many=True)
    z, alpha = orbit.unknowns, DEFAULT.alpha
    t1, T = z[-2:]
    exact_t1, exact_T = exact.times(alpha)
    x, a = (METHODS["c1"].evaluate(z, N, t1 + (T - t1) * NODES, j, alpha) for j in (0, 2))
    legendre = np.polynomial.legendre.legvander(2 * NODES - 1, N).T
    return Row(
        N,
        abs(orbit.errors.period),
        max(abs(t1 - exact_t1), abs(T - t1 - (exact_T - exact_t1))) / exact_T,
        norm(a + x) / norm(a),
        distance(T - t1, NODES**2 * legendre),
    )


def tau(N: int) -> Row:
    """Return the series with the Legendre polynomials of degree N and below as tests."""
    orbit = solve_case(load("stick-slip")(), "ck-tau", N)
    slip = orbit.case.cell.phases[1]
    x, a = (orbit.part(1, NODES, j) for j in (0, 2))
    left = slip.m * a + slip.k * x - slip.f
    legendre = np.polynomial.legendre.legvander(2 * NODES - 1, N).T
    return Row(
        N,
        abs(orbit.errors.period),
        orbit.errors.times,
        norm(left) / norm(slip.m * a),
        distance(float(orbit.cell_durations[1]), legendre),
    )


def draw(series: dict[str, list[Row]], target: Path) -> None:
    """Draw errors, and their factors, against the order."""
    import matplotlib as mpl
    from matplotlib.figure import Figure

    from nonsmooth.style import SETTINGS, save

    looks = {"c1": ("#009E73", "o", (0, (1.5, 1))), "c1-tau": ("#CC79A7", "^", "-")}
    with mpl.rc_context(SETTINGS):
        figure = Figure(figsize=(8, 3.6), layout="constrained")
        panels = figure.subplots(1, 3, sharey=True)
        titles = {
            "times": "error of the times",
            "residual": "residual of slip, relative",
            "distance": "response, apart from the tests",
        }
        for axes, (name, title) in zip(panels, titles.items(), strict=True):
            for method, rows in series.items():
                colour, marker, style = looks[method]
                axes.semilogy(
                    [row.order for row in rows],
                    [max(getattr(row, name), 1e-16) for row in rows],
                    color=colour,
                    marker=marker,
                    markersize=4,
                    linestyle=style,
                    label=method,
                )
            axes.set(xlabel="order N", title=title)
            axes.xaxis.get_major_locator().set_params(integer=True)
        handles, labels = panels[0].get_legend_handles_labels()
        figure.legend(handles, labels, loc="outside upper center", ncols=2, frameon=False)
        save(figure, target)


def main() -> None:
    """Compute, print, draw."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("-o", "--output", type=Path)
    target = parser.parse_args().output
    series = {"c1": [paper(N) for N in ORDERS], "c1-tau": [tau(N) for N in ORDERS]}
    heads = [f"{method}{name}" for method in ("`c1` ", "`c1-tau` ") for name in NAMES]
    print(f"| N | {' | '.join(heads)} |")
    print("|---|" + "---|" * len(heads))
    for rows in zip(*series.values(), strict=True):
        cells = (getattr(row, n) for row in rows for n in NAMES)
        shown = " | ".join("rounding" if c < 1e-15 else f"{c:.1e}" for c in cells)
        print(f"| {rows[0].order} | {shown} |")
    if target is not None:
        draw(series, target)


if __name__ == "__main__":
    main()
