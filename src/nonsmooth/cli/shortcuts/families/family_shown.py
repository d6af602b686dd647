"""What a sweep over a parameter says on the terminal."""

from collections import Counter
from collections.abc import Iterator
from dataclasses import asdict, replace
from typing import Any

import click
import numpy as np

from nonsmooth.solver.shortcuts.orbit.oscillator import DEFAULT, PARAMETERS
from nonsmooth.solver.shortcuts.search.family_points import STATUS

from ..parameters import CHOICE
from ..tables import family_points
from .family_job import Job, Points
from .family_store import Store
from .vary import SCALES, SYMBOLS

#: Points of the printed table, of each method.
TABLE = 25

#: Points that are looked at at once.
BLOCK = 65_536


def every(job: Job, store: Store) -> Iterator[Points]:
    """Yield all points, some at a time."""
    for chunk in job.chunks(BLOCK):
        yield store.read(chunk.place, chunk.place + len(chunk))


def spread(job: Job, store: Store, most: int) -> dict[str, Points]:
    """Return, for each method, at most so many of its points, evenly spread."""
    count = job.vary.count
    numbers = np.unique(np.linspace(0, count - 1, min(most, count)).round().astype(int))
    return {
        method: np.concatenate([store.read(n, n + 1) for n in (i * count + numbers).tolist()])
        for i, method in enumerate(job.methods)
    }


def show(job: Job, store: Store) -> None:
    """Print the oscillator, a table of some of the points, and what holds for all."""
    click.echo(_caption(job))
    parameter = job.vary.parameter
    unit = PARAMETERS[parameter][0]
    heading = SYMBOLS[parameter] + (f" [{unit}]" if unit else "")
    family_points(heading, job.order, spread(job, store, TABLE))
    if job.vary.count > TABLE:
        click.echo(f"{TABLE} of {job.vary.count} points; -o writes all of them")
    click.echo(_summary(job, store))


def _caption(job: Job) -> str:
    """Return the oscillator, what of it varies, and what of the orbit that changes."""
    vary, belt = job.vary, job.belt
    changed: dict[str, Any] = {vary.parameter: vary.last}
    last = replace(belt, **changed)
    parts = []
    for name, value in asdict(belt).items():
        number = f"{value:g}" if name != vary.parameter else f"{value:g} to {vary.last:g}"
        parts.append(f"{SYMBOLS[name]} = {number} {PARAMETERS[name][0]}".rstrip())
    scales = SCALES[vary.parameter]
    besides = f"nothing else but {scales}" if scales else "nothing else"
    moved = f"alpha runs from {belt.alpha:.6g} to {last.alpha:.6g}."
    lines = [
        f"{', '.join(parts[:3])},\n{', '.join(parts[3:])}",
        click.wrap_text(f"{moved} {SYMBOLS[vary.parameter]} changes {besides}.", width=80),
    ]
    if vary.parameter != "normal_force" and asdict(belt) | {
        vary.parameter: getattr(DEFAULT, vary.parameter)
    } == asdict(DEFAULT):
        lines.append(CHOICE)
    return "\n".join(lines) + "\n"


def _summary(job: Job, store: Store) -> str:
    found: Counter[int] = Counter()
    worst, where = 0.0, ""
    for points in every(job, store):
        found.update(points["status"].tolist())
        errors = np.nan_to_num(points["estimate_period"])
        i = int(np.argmax(errors))
        if errors[i] > worst:
            worst, where = float(errors[i]), f"{job.vary.flag} = {points['value'][i]:g}"
    counts = ", ".join(f"{found[i]} {STATUS[i]}" for i in sorted(found))
    text = f"{counts}; largest estimated error of T: {worst:.1e}, at {where}"
    return click.wrap_text(text, width=80)
