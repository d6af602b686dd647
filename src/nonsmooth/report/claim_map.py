"""The map of the claims: for which normal forces the verdict on each is which."""

from collections.abc import Sequence
from typing import Any

from matplotlib.figure import Figure

import nonsmooth as ns

from .claims import VERDICTS, Claim
from .intervals import FIRST, LAST, Intervals, force, segments

#: Shades of the verdicts, from all parts to none; as readable in grey.
SHADES = dict(zip(VERDICTS, ("#0072B2", "#A9CCE3", "none"), strict=True))

#: Inches: of the map, and the height of a row.
WIDTH, ROW = 4.8, 0.23


def claim_map(belt: ns.StickSlip, claims: Sequence[Claim], intervals: Intervals) -> Figure:
    """Return the map: a row a claim, the normal force from left to right."""
    made = Figure(figsize=(WIDTH, ROW * len(claims) + 1), layout="constrained")
    axes = made.subplots()
    for row, claim in enumerate(claims):
        for low, high, verdict in segments(claim, intervals):
            left, right = force(belt, low), force(belt, high)
            look: Any = {"height": 0.7, "color": SHADES[verdict], "linewidth": 0}
            axes.barh(row, right - left, left=left, **look)
    axes.axvline(belt.normal_force, color="black", linewidth=1.2, linestyle="--")
    labels = [f"{claim.title}  {n}" for n, claim in enumerate(claims, 1)]
    axes.set_yticks(range(len(claims)), labels, fontsize=8.5)
    axes.set(xscale="log", xlabel="normal force $F_N$ [N]", ylim=(len(claims) - 0.4, -0.6))
    axes.set_xlim(force(belt, FIRST), force(belt, LAST))
    axes.grid(axis="y", visible=False)
    return made
