"""Draw the first picture of README and site, ``docs/impact.png``.

It is to be read at 390 pixels as well: four panels, two beside each other, with large letters.
"""

from pathlib import Path

import matplotlib.pyplot as plt

import nonsmooth as ns

#: Of a legend: above its panel, over no curve.
ABOVE = {
    "loc": "lower left", "bbox_to_anchor": (-0.05, 1), "ncols": 4, "frameon": False,
    "fontsize": 10, "columnspacing": 0.7, "handlelength": 1.4, "handletextpad": 0.4,
}  # fmt: skip

if __name__ == "__main__":
    plt.switch_backend("Agg")
    plt.rcParams.update({"font.size": 12, "axes.grid": True, "grid.alpha": 0.3})
    stop = ns.scene("impact")()
    figure, ((plane, history), (errors, response)) = plt.subplots(
        2, 2, figsize=(7, 6.6), layout="constrained"
    )
    exact, few = ns.exact(stop), ns.solve(stop, method="hb", order=10)
    ns.plot([exact, few], plane)
    ns.plot([exact, few], history, quantity="velocity")
    plane.legend(["orbit", "10 harmonics"], **ABOVE)
    ns.sweep(stop, methods=["hb", "ck-tau"], orders=range(3, 25)).plot(errors)
    errors.set_ylabel("error of the times")
    errors.legend(["harmonics", "functions that jump"], **ABOVE)
    ns.branch(ns.scene("impact")(gap=0.5, damping=0.02), "frequency", 1.2, 2.6).plot(
        response, "amplitude"
    )
    response.set_ylabel("amplitude [m]")
    response.legend(**ABOVE | {"ncols": 2})
    figure.savefig(Path(__file__).with_name("impact.png"), dpi=130)
