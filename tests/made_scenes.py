"""Scenes and motions that are made for a test, without a file."""

from dataclasses import dataclass
from pathlib import Path
from types import SimpleNamespace

import numpy as np

from nonsmooth.solver.orbit.motion import Motion
from nonsmooth.solver.scenes.case import Case
from nonsmooth.solver.scenes.loaded import LoadedScene

FREQUENCY = ("frequency", "Omega", "rad/s", 1.0, "angular frequency", "positive", None)
SCALE = ("scale", "a", "", 1.0, "a number", "", None)


def made(
    equations,
    events,
    *,
    omega=None,
    half=False,
    jumps=None,
    held=None,
    demands=None,
    k=1,
    guess=(),
    folder=Path("nowhere"),
):
    """Return a scene whose coefficients are these numbers, in units of 1."""
    count = len(equations)
    jumps = jumps or ((1, 0),) * count
    held = held or (None,) * count
    demands = demands or ({},) * count
    frequency = (*FREQUENCY[:3], omega, *FREQUENCY[4:])
    module = SimpleNamespace(
        BODY=repr((equations, events, omega, half, jumps, held, demands)),
        NAME="made",
        TITLE="made for a test",
        CLASS=k,
        HALF_PERIOD=half,
        FREQUENCY="frequency" if omega else None,
        MOTIONS=(),
        MOTION=None,
        MEMORY=(),
        PARAMETERS=(frequency,) if omega else (SCALE,),
        POWERS=((0, 0, 0),),  # the numbers above know no units, so none are changed
        PHASES=tuple((f"phase {p}", held[p] is not None) for p in range(count)),
        SWITCHES=((k, "?"),) * count,
        CLASSES_OF_DEFAULTS=(k,) * count,
        DEMANDS=tuple(tuple(each) for each in demands),
        SWITCH_DEMANDS=((),) * count,
        REQUIRES=(),
        scales=lambda _: (1, 1, 1),
        coefficients=lambda _: equations,
        held=lambda _: tuple(speed or 0 for speed in held),
        events=lambda _: events,
        jumps=lambda _: jumps,
        demands=lambda _: tuple(tuple(each.values()) for each in demands),
        switch_demands=lambda _: ((),) * count,
        memory=lambda _: (),
        requires=lambda _: (),
        guess=lambda _: guess,
    )
    return LoadedScene(module, folder)


@dataclass(frozen=True, eq=False)
class Given(Motion):
    """A motion that is given: coefficients of a polynomial in u, the same on each phase."""

    case: Case
    durations_: tuple[float, ...]
    polynomial: np.polynomial.Polynomial
    angle_: float = 0.0

    @property
    def cell_durations(self):
        return np.array(self.durations_)

    @property
    def angle(self):
        return self.angle_

    def part(self, p, u, derivative):
        s = self.durations_[p]
        return self.polynomial.deriv(derivative)(np.asarray(u)) / s**derivative
