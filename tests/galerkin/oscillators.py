"""Scenes of the references that do not come with the program: as a user would write them."""

from dataclasses import replace

import numpy as np
import sympy as sp
from made_scenes import parameters

from nonsmooth.codegen.scene import Event, Phase, Scene, a, forcing, v, x
from nonsmooth.codegen.scenes import (
    backlash,
    clearance,
    dry_friction,
    elastic_plastic,
    impact,
    impact_inelastic,
    impact_two_sided,
    stick_slip,
    stick_slip_damped,
)

m, k, F, Omega = sp.symbols("m k F Omega", positive=True)
c = sp.Symbol("c", nonnegative=True)

#: S3c: sliding and at rest the friction is the same, and so the motion is smoother.
LIMIT = sp.Symbol("f_d", nonnegative=True)
EQUAL_FRICTION = Scene(
    "equal-friction",
    "a driven mass with dry friction that stops twice a period",
    parameters(
        mass=(m, "kg", 1.0), damping=(c, "N s/m", 0.1), stiffness=(k, "N/m", 1.0),
        force=(F, "N", 1.0), frequency=(Omega, "rad/s", 0.4), friction=(LIMIT, "N", 0.5),
    ),
    (
        Phase("down", m * a + c * v + k * x - LIMIT - F * forcing, Event(v)),
        Phase("rest", a, Event(x * k - F * forcing + LIMIT), held=sp.Integer(0)),
    ),
    frequency=Omega,
    half_period=True,
)  # fmt: skip

#: S1b: an impulse at prescribed times, which are those at which the cosine is zero.
IMPULSE = sp.Symbol("I", positive=True)
KICKED = Scene(
    "kicked",
    "a mass on a spring that is kicked once a period",
    parameters(
        mass=(m, "kg", 1.0), damping=(c, "N s/m", 0.1), stiffness=(k, "N/m", 1.0),
        impulse=(IMPULSE, "N s", 1.0), frequency=(Omega, "rad/s", 2 * np.pi / 4.5),
    ),
    (Phase("swing", m * a + c * v + k * x, Event(forcing, jump={v: v + IMPULSE / m})),),
    frequency=Omega,
    scales={"length": IMPULSE / m / Omega},
)  # fmt: skip

#: S5c: the friction falls with the speed, and is continuous where the mass is at rest.
M, K, V, mu, F_N, w = sp.symbols("M K V mu F_N w", positive=True)
CONTINUOUS = Scene(
    "continuous-friction",
    "a mass on a belt, with friction that falls from its static value",
    parameters(
        mass=(M, "kg", 1.0), stiffness=(K, "N/m", 1.0), belt_speed=(V, "m/s", 1.0),
        mu=(mu, "", 2.0), normal_force=(F_N, "N", 1.0), damping=(c, "N s/m", 0.0),
        weakening=(w, "s/m", 0.4),
    ),
    (
        Phase("stick", a, Event(mu * F_N - K * x - c * V), held=V),
        Phase("slip", M * a + c * v + K * x - (mu - w * (V - v)) * F_N, Event(v - V)),
    ),
)  # fmt: skip

#: S0n: the paper's oscillator with all events imposed.
WITHOUT_START = replace(stick_slip.SCENE, name="without-start", start={})

#: By the name of the scene in the references, and "S0", the paper's oscillator as it is;
#: parameters in the order of the scene, where they are not its defaults.
SCENES = {
    "S0": (stick_slip.SCENE, (1.0, 1.0, 1.0, 1.0, 0.0, 1.0)),
    "S0n": (WITHOUT_START, (1.0, 1.0, 1.0, 1.0, 0.0, 1.0)),
    "S1": (impact.SCENE, None),
    "S1n2": (impact.SCENE, (1.0, 0.1, 1.0, 1.0, 3.6, 0.1, 0.6)),
    "S1b": (KICKED, None),
    "S2a": (backlash.SCENE, None),
    "S2b": (clearance.SCENE, None),
    "S3a": (dry_friction.SCENE.of_motion("sliding"), None),
    "S3b": (
        dry_friction.SCENE.of_motion("two-stops"),
        (1.0, 0.1, 1.0, 1.0, 0.6, 0.5, 1.0, 0.4),
    ),
    "S3c": (EQUAL_FRICTION, None),
    "S4a": (elastic_plastic.SCENE, None),
    "S4b": (elastic_plastic.SCENE, (1.0, 0.1, 1.0, 0.5, 0.0, 1.0, 0.8)),
    "S5a": (stick_slip_damped.SCENE, (1.0, 1.0, 1.0, 3.0, 1.0, 1.0, 0.1, 0.0)),
    "S5b": (stick_slip_damped.SCENE, (1.0, 1.0, 1.0, 2.0, 1.0, 1.0, 0.1, 0.2)),
    "S5c": (CONTINUOUS, None),
    "S6": (impact_two_sided.SCENE, None),
    "S7": (impact_inelastic.SCENE, None),
}

#: Periods of the forcing in the period, where there are several.
CYCLES = {"S1n2": 2}


def parameters_of(name: str) -> tuple[float, ...]:
    """Return the parameters of a scene of the references, which has units of 1."""
    scene, values = SCENES[name]
    return values or tuple(float(q.default) for q in scene.parameters)


def case_of(name: str) -> tuple[float, ...]:
    """Return what kernels call a case: the parameters and, where forced, the cycles."""
    forced = SCENES[name][0].frequency is not None
    return (*parameters_of(name), *((CYCLES.get(name, 1),) if forced else ()))
