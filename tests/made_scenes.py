"""Scenes and motions that are made for a test, without a file."""

from dataclasses import dataclass
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import sympy as sp

from nonsmooth.scene import Parameter, Phase, Scene, find
from nonsmooth.solver.orbit.motion import Motion
from nonsmooth.solver.scenes.case import Case
from nonsmooth.solver.scenes.loaded import LoadedScene

FREQUENCY = ("frequency", "Omega", "rad/s", 1.0, "angular frequency", "positive", None)
SCALE = ("scale", "a", "", 1.0, "a number", "", None)


def parameters(**values: tuple[sp.Symbol, str, float]) -> tuple[Parameter, ...]:
    """Return parameters by their names, from symbols, units and defaults."""
    return tuple(Parameter(name, *each, name) for name, each in values.items())


def scene_of(name: str, own: tuple[Parameter, ...], *phases: Phase, **fields) -> LoadedScene:
    """Return a scene as a user writes it; a parameter `frequency` is that of the forcing."""
    frequency = next((q.symbol for q in own if q.name == "frequency"), None)
    return find(Scene(name, name, own, phases, frequency=frequency, **fields))


def in_a_row(springs) -> np.ndarray:
    """Return the stiffness of a row of masses, of which a spring holds the first."""
    K = np.diag(springs) + np.diag([*springs[1:], 0])
    return K - np.diag(springs[1:], 1) - np.diag(springs[1:], -1)


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


def mirrored(x, v, cos, constant):
    """Return an event at a switch where the next cell is the mirror image."""
    return (-x, -v, -cos, constant)


#: A spring behind a gap.
CLEARANCE = made(
    [(1, 0.2, 5, 2, 1), (1, 0.2, 1, 0, 1)],
    [(1, 0, 0, -0.5), (1, 0, 0, -0.5)],
    omega=1.3,
    demands=[{"in contact": (1, 0, 0, -0.5)}, {"free": (-1, 0, 0, 0.5)}],
)

#: A dead zone, whose other half is the mirror image.
BACKLASH = made(
    [(1, 0.1, 1, 1, 0.8), (1, 0.1, 0, 0, 0.8)],
    [(1, 0, 0, -1), mirrored(1, 0, 0, -1)],
    omega=0.7,
    half=True,
    demands=[{"engaged": (1, 0, 0, -1)}, {"loose": (-1, 0, 0, 1), "loose too": (1, 0, 0, 1)}],
)


def dry(omega, kinetic, static):
    """Return dry friction with stops: slides down, then rests while the load allows."""
    return made(
        [(1, 0.1, 1, kinetic, 1), (1, 0, 0, 0, 0)],
        [(0, 1, 0, 0), mirrored(1, 0, -1, -static)],
        omega=omega,
        half=True,
        held=(None, 0.0),
        demands=[
            {"it slides down": (0, -1, 0, 0)},
            {"the load is held": (-1, 0, 1, static), "both ways": (1, 0, -1, static)},
        ],
    )


#: Impacts on both sides: the event of a phase is the stop that it flies to.
TWO_SIDED = made(
    [(1, 0.1, 1, 0, 1)],
    [mirrored(1, 0, 0, -0.8)],
    omega=1.2,
    half=True,
    jumps=((-0.6, 0),),
    demands=[{"above": (1, 0, 0, 0.8), "below": (-1, 0, 0, 0.8)}],
    k=0,
)


@dataclass(frozen=True, eq=False)
class Given(Motion):
    """A motion that is given: coefficients of a polynomial in u, the same on each phase."""

    case: Case
    durations_: tuple[float, ...]
    polynomial: np.polynomial.Polynomial
    angle_: float = 0.0

    memory_values = ()

    @property
    def times(self):
        return np.array([*self.durations_, *[self.angle_] * self.case.cell.forced])

    @property
    def cell_durations(self):
        return np.array(self.durations_)

    @property
    def angle(self):
        return self.angle_

    def part(self, p, u, derivative):
        s = self.durations_[p]
        return self.polynomial.deriv(derivative)(np.asarray(u)) / s**derivative
