"""A scene that is right, and how to make one mistake in it."""

from dataclasses import replace

import pytest
import sympy as sp
from made_scenes import parameters

from nonsmooth.codegen.scene import Event, Parameter, Phase, Scene, SceneError, a, forcing, v, x

m, k, F, Omega, r, V, mu = sp.symbols("m k F Omega r V mu", positive=True)
c = sp.Symbol("c", nonnegative=True)
g = sp.Symbol("g", real=True)

KNOWN = parameters(
    mass=(m, "kg", 1.0), damping=(c, "N s/m", 0.1), stiffness=(k, "N/m", 1.0),
    force=(F, "N", 1.0), frequency=(Omega, "rad/s", 1.8), gap=(g, "m", 0.1),
)  # fmt: skip
PARAMETERS = (*KNOWN, Parameter("restitution", r, "", 0.6, "restitution", most=1))
FLIGHT = Phase(
    "flight",
    m * a + c * v + k * x - F * forcing,
    Event(x - g, jump={v: -r * v}),
    demands={"before the stop": g - x},
)


def scene(*, phase=None, ends=None, **changes):
    """Return the scene of a mass that hits a stop, with changed fields."""
    flight = replace(FLIGHT, **(phase or {}))
    if ends is not None:
        flight = replace(flight, ends=replace(flight.ends, **ends))
    fields = {
        "name": "small",
        "title": "a small scene",
        "parameters": PARAMETERS,
        "phases": (flight,),
        "frequency": Omega,
    }
    return Scene(**(fields | changes))


def with_parameter(index, **changes):
    """Return the scene with a parameter that has changed fields."""
    changed = replace(PARAMETERS[index], **changes)
    return scene(parameters=(*PARAMETERS[:index], changed, *PARAMETERS[index + 1 :]))


#: The same where the mass stays at the stop until the force pulls it off.
STAYS = Phase("rest", a, Event(F * forcing - k * x), held=sp.Integer(0))


def stop(*, flight=None, rest=None, **changes):
    """Return the scene of a mass that rests on a stop, with changed fields."""
    ends = {"ends": Event(x - g, jump={v: 0})}
    phases = (replace(FLIGHT, **(ends | (flight or {}))), replace(STAYS, **(rest or {})))
    return scene(**({"phases": phases, "parameters": PARAMETERS[:-1]} | changes))


BELT = parameters(
    mass=(m, "kg", 1.0), stiffness=(k, "N/m", 1.0), speed=(V, "m/s", 1.0), limit=(F, "N", 1.0)
)
REST = Phase("rest", a, Event(F - k * x), held=V)
RUN = Phase("run", m * a + k * x, Event(v - V))


def belt(*, rest=None, run=None, parameters=BELT, **changes):
    """Return the scene of a mass on a belt, with changed fields."""
    phases = (replace(REST, **(rest or {})), replace(RUN, **(run or {})))
    return Scene(
        **({"name": "belt", "title": "a belt", "phases": phases} | changes),
        parameters=parameters,
    )


def refused(make, *words):
    """Check that a scene is refused in one line that begins with the field; return it."""
    with pytest.raises(SceneError) as caught:
        make()
    message = str(caught.value)
    assert "\n" not in message
    field, *others = words
    assert message.startswith(field), message
    for word in others:
        assert word in message, message
    return message
