"""Orbits beside a flip, and beside a loss of symmetry, of a mass on a slider that hits stops.

The slider holds by a spring until that pulls with its friction; where it is, is remembered.
"""

import numpy as np
import pytest
import sympy as sp
from made_scenes import parameters, scene_of

import nonsmooth as ns
from nonsmooth.scene import Body, Event, Memory, Phase, a, forcing, v, x
from nonsmooth.solver.branch.branch import BothWays, go, start_of
from nonsmooth.solver.branch.orders.change import doubled
from nonsmooth.solver.exact import exact_orbit
from nonsmooth.solver.scenes.case import index_of

m, k, c, F, k_t, f, g, r, Omega = sp.symbols("m k c F k_t f g r Omega", positive=True)
w, b = sp.symbols("w b_s", real=True)

FRICTION, GAP = 0.005, 0.3
OF_SLIDER = parameters(
    tangential=(k_t, "N/m", 0.2), friction=(f, "N", FRICTION), gap=(g, "m", GAP),
    restitution=(r, "", 0.95), frequency=(Omega, "rad/s", 1.5),
)  # fmt: skip
OF_MASS = parameters(
    mass=(m, "kg", 1.0), stiffness=(k, "N/m", 1.0), damping=(c, "N s/m", 0.01),
    force=(F, "N", 1.0),
)  # fmt: skip

#: A range of the frequency, and where an orbit and that beside it have flips.
ENDS, FLIPS = (2.0725, 2.0745), [2.07316492483177, 2.07423172384041]

#: The same as a body.
ONE = Body(M=np.eye(1), K=np.eye(1), C=0.01 * np.eye(1), forcing=np.ones(1), at={"tip": [1.0]})


def scene(*, body: bool = False, half: bool = False):
    """Return a stop on one side, of a mass or of a body of one; on both, of a mass."""
    tip = ONE.at["tip"]
    place, speed = (tip.x, tip.v) if body else (x, v)
    rest = tip.force if body else m * a + c * v + k * x - F * forcing
    ahead, behind = k_t * (place - w), k_t * (place - b)
    before = {"it is before the stop": g - place}
    forward = Phase(
        "forward", rest + f, Event(place - g, {speed: -r * speed}),
        {"it moves forward": speed} | before,
    )  # fmt: skip
    held = Phase(
        "held", rest + ahead, Event(ahead + f), {"the slider holds": f - sp.Abs(ahead)} | before
    )
    back = Phase("back", rest - f, Event(speed), {"it moves backward": -speed})
    caught = Phase(
        "caught", rest + behind, Event(behind - f),
        {"the slider holds": f - sp.Abs(behind)} | before,
    )  # fmt: skip
    memory = (Memory(w, "held", place - f / k_t, "where the slider is"),)
    if not half:
        memory += (Memory(b, "caught", place + f / k_t, "where it is then"),)
    return scene_of(
        f"slider{'-body' * body}{'-between' * half}",
        OF_SLIDER if body else OF_SLIDER + OF_MASS,
        *((forward, held) if half else (forward, held, back, caught)),
        half_period=half, memory=memory, body=ONE if body else None,
    )  # fmt: skip


def test_at_a_flip_there_is_an_orbit_of_twice_the_period() -> None:
    case = scene()()
    single, double = ns.branches(case, "frequency", *ENDS)
    (flip,) = single.events
    meeting, second = double.events
    assert [event.kind for event in (flip, meeting, second)] == ["flip", "branch-point", "flip"]
    assert [flip.parameter, second.parameter] == pytest.approx(FLIPS, rel=1e-13)
    assert meeting.parameter == pytest.approx(flip.parameter, rel=1e-13)
    assert double.case.cycles == 2
    row = min(double, key=lambda q: abs(q.value - 2.0736))
    assert row.stable
    beside = double.case.with_value("frequency", row.value)
    orbit = exact_orbit(beside, row.durations, row.forcing_phase)
    assert orbit.durations == pytest.approx(row.durations, rel=1e-9)
    middle = orbit.durations[0] / 2
    state = float(orbit.displacement(middle)), float(orbit.velocity(middle))
    angle = orbit.forcing_phase + row.value * middle
    there = case.with_value("frequency", row.value)
    motion = ns.simulate(there, state, 200, forcing_phase=angle)
    last = [q.duration for q in motion.phases[-9:-1]]
    assert sorted(last) == pytest.approx(sorted(row.durations), rel=1e-8)


def test_the_same_as_a_body_has_the_same_flips() -> None:
    """By other equations; at the beginnings of phases its velocity is rounding."""
    mass, body = (scene(body=q)(frequency=2.073) for q in (False, True))
    orbit = ns.exact(mass)
    start = exact_orbit(body, orbit.durations, orbit.forcing_phase)
    single = BothWays(index_of(body, "frequency"))
    go(single, start_of(start, single.index, ENDS))
    (flip,) = single.events()
    begin = doubled(flip)
    assert begin is not None
    double = BothWays(single.index, begin[0].course)
    go(double, begin)
    (second,) = [event for event in double.events() if event.kind == "flip"]
    assert [flip.value, second.value] == pytest.approx(FLIPS, rel=1e-13)


@pytest.mark.parametrize(("friction", "ends"), [(FRICTION, (1.9, 2.12)), (0.05, (1.1, 1.12))])
def test_where_symmetry_is_lost_there_is_an_orbit_without_it(friction, ends) -> None:
    """At the second the parameter hardly changes along it: it is found further aside.

    A simulation may settle on the first: it is a branch once.
    """
    case = scene(half=True)(restitution=0.8, friction=friction)
    found = ns.branches(case, "frequency", *ends)
    lost = [
        event.parameter for q in found for event in q.events if event.kind == "branch-point"
    ]
    assert len(lost) == 2
    assert lost[0] == pytest.approx(lost[1], rel=1e-13)
