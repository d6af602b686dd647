"""The map of the claims: for which normal forces the verdict on each is which."""

from itertools import pairwise

from matplotlib.figure import Figure

from nonsmooth.solver.shortcuts.orbit.oscillator import StickSlip

from .finding import VERDICTS, Claim, Finding, verdict
from .intervals import FIRST, LAST, Intervals, force

#: Shades of the verdicts, from all parts to none; as readable in grey.
SHADES = dict(zip(VERDICTS, ("#0072B2", "#A9CCE3", "none"), strict=True))

#: Inches: of the map, and the height of a row.
WIDTH, ROW = 4.8, 0.23


def segments(claim: Claim, intervals: Intervals) -> list[tuple[float, float, str]]:
    """Return where which verdict holds: from alpha, to alpha, and the verdict."""
    ends = {FIRST, LAST}
    for part in claim.parts:
        ends |= {end for i in intervals[part] for end in (i.low, i.high) if end is not None}
    edges = sorted(ends)
    found: list[tuple[float, float, str]] = []
    for low, high in pairwise(edges):
        middle = (low * high) ** 0.5
        inside = (
            Finding(any(interval.contains(middle) for interval in intervals[part]), "")
            for part in claim.parts
        )
        here = verdict(claim, tuple(inside))
        start = found.pop()[0] if found and found[-1][2] == here else low
        found.append((start, high, here))
    return found


def claim_map(belt: StickSlip, claims: tuple[Claim, ...], intervals: Intervals) -> Figure:
    """Return the map: a row a claim, the normal force from left to right."""
    made = Figure(figsize=(WIDTH, ROW * len(claims) + 1), layout="constrained")
    axes = made.subplots()
    for row, claim in enumerate(claims):
        for low, high, found in segments(claim, intervals):
            left, right = force(belt, low), force(belt, high)
            axes.barh(
                row, right - left, left=left, height=0.7, color=SHADES[found], linewidth=0
            )
    axes.axvline(belt.normal_force, color="black", linewidth=1.2, linestyle="--")
    labels = [f"{claim.title}  {n}" for n, claim in enumerate(claims, 1)]
    axes.set_yticks(range(len(claims)), labels, fontsize=8.5)
    axes.set(xscale="log", xlabel="normal force $F_N$ [N]", ylim=(len(claims) - 0.4, -0.6))
    axes.set_xlim(force(belt, FIRST), force(belt, LAST))
    axes.grid(axis="y", visible=False)
    return made
