"""Orders of phases that a motion shows: beyond an event that brings several changes at once."""

import numpy as np
import pytest
import sympy as sp
from made_scenes import parameters, scene_of

import nonsmooth as ns
from nonsmooth.scene import Event, Phase, a, forcing, v, x
from nonsmooth.solver.exact import exact_orbit
from nonsmooth.solver.no_orbit import NoOrbit

m, c, k, F, Omega = sp.symbols("m c k F Omega", positive=True)
f, g, s, P = sp.symbols("f g s P", positive=True)

#: What symbols of parameters are called, and their units.
KNOWN = {
    "mass": (m, "kg"), "damping": (c, "N s/m"), "stiffness": (k, "N/m"), "force": (F, "N"),
    "frequency": (Omega, "rad/s"), "friction": (f, "N"), "gap": (g, "m"), "stop": (s, "N/m"),
    "load": (P, "N"),
}  # fmt: skip


def of_unit(**values: float):
    """Return the parameters of unit mass and stiffness with values of the others."""
    given = {"mass": 1.0, "stiffness": 1.0, **values}
    return parameters(**{q: (*KNOWN[q], value) for q, value in given.items()})


def rubbing(pull: sp.Expr, beyond: dict[str, sp.Expr], name: str = "", *more: Event):
    """Return the phases of a mass under a pull with dry friction, with further conditions."""
    load, leaves = pull.subs(v, 0), list(more)
    ends = {q: Event(v) for q in ("forth", "back")}
    for which, event in zip(ends, leaves, strict=False):
        ends[which] = ends[which] | event if event else ends[which]
    return (
        Phase(f"forth{name}", m * a - pull + f, ends["forth"], {"it moves": v, **beyond}),
        Phase(f"back{name}", m * a - pull - f, ends["back"], {"it moves": -v, **beyond}),
        Phase(
            f"stick{name}", a, Event(load - f) | Event(load + f),
            {"it sticks": f - sp.Abs(load), **beyond}, held=0,
        ),
    )  # fmt: skip


def before_a_spring(**values: float):
    """Return a mass with dry friction that reaches a spring on one side."""
    phases = ()
    for on in (0, 1):
        pull = F * forcing - c * v - k * x - on * s * (x - g)
        side = {"its side": x - g if on else g - x}
        meets = (None, Event(x - g)) if on else (Event(x - g), None)
        phases += rubbing(pull, side, str(on), *meets)
    return scene_of("rough-spring", of_unit(**values), *phases)


def test_both_reversals_begin_to_stick_at_once_though_no_symmetry_is_declared() -> None:
    """A load moves the middle: half a period is no order of the scene."""
    pull = F * forcing - P - c * v - k * x
    values = {"damping": 0.03775, "force": 0.356632, "frequency": 1.039876, "load": 0.374415}
    scene = scene_of("loaded", of_unit(friction=0.192196, **values), *rubbing(pull, {}))
    found = ns.branch(scene(), "friction", 0.19, 0.34)
    assert [event.kind for event in found.events] == ["sticking"]
    assert found.why_it_ended == ("the end of the range",) * 2
    assert {len(row.durations) for row in found.rows} == {2, 4}
    exact = exact_orbit(scene(friction=0.34))
    assert sorted(found.rows[-1].durations) == pytest.approx(sorted(exact.durations), rel=1e-9)


def test_a_branch_ends_where_impacts_accumulate_and_does_not_come_back() -> None:
    """From four impacts in half a period to 19, each event once."""
    case = ns.scene("impact-two-sided")(
        frequency=0.72, gap=0.4099, restitution=0.404, damping=0.2556
    )
    found = ns.branch(case, "frequency", 0.65, 0.72)
    first, last = found.why_it_ended
    assert first == "grazing, beyond which the switches accumulate"
    assert last == "the end of the range"
    events = sorted(event.parameter for event in found.events)
    assert np.diff(events).min() > 1e-9
    assert events[0] == pytest.approx(0.7093248976887, rel=1e-11)


@pytest.mark.parametrize("force", [0.65, 0.8])
def test_a_mass_that_sticks_comes_to_its_spring(force: float) -> None:
    """Two contacts begin, and it sticks there: three phases more, from either side."""
    values = {"damping": 0.22, "frequency": 0.92, "friction": 0.51, "gap": 0.37, "stop": 4.1}
    case = before_a_spring(force=force, **values)()
    found = ns.branch(case, "force", 0.6, 0.9)
    kinds = {event.kind for event in found.events}
    assert kinds <= {"grazing", "sticking", "vanishing"}
    meets, slips = sorted(event.parameter for event in found.events)
    assert meets == pytest.approx(0.704314401456, rel=1e-11)
    assert slips == pytest.approx(0.716971138906, rel=1e-11)
    assert found.why_it_ended == ("the end of the range",) * 2
    assert {len(row.durations) for row in found.rows} == {4, 5, 6}


@pytest.mark.parametrize(
    "values",
    [
        {"damping": 0.05, "frequency": 1.7, "friction": 0.07, "gap": 0.16, "stop": 5.5},
        {"damping": 0.158, "frequency": 0.57, "friction": 0.564, "gap": 0.533, "stop": 5.155},
    ],
)
def test_orbits_last_until_friction_holds_the_force(values) -> None:
    """A contact ends where the branch is steep; no step along it changes the force."""
    found = ns.branch(before_a_spring(force=1.0, **values)(), "force", 0.02, 1.2)
    assert found.rows[0].value == pytest.approx(values["friction"], rel=1e-4)
    assert found.why_it_ended[0].startswith("sticking, beyond which the motion stays in stick")
    assert found.rows[-1].value == 1.2


def test_a_mass_that_is_always_held_is_no_order() -> None:
    """Its simulations rest: where it is then is not determined."""
    pull, rests = P + F * forcing - c * v - k * x, P + F * forcing - k * g + f
    before = {"before the stop": g - x}
    phases = rubbing(pull, before, "", Event(x - g, jump={v: 0}))
    rest = Phase("rest", a, Event(rests), {"it presses": rests}, held=0)
    values = {"damping": 0.05, "load": 0.4, "force": 0.91, "frequency": 0.55, "gap": 0.5}
    scene = scene_of("lands", of_unit(friction=0.38, **values), *phases, rest)
    assert len(ns.exact(scene()).phases) == 4
    with pytest.raises(NoOrbit) as caught:
        ns.exact(scene(force=0.01, load=0.1))
    assert caught.value.tried
    with pytest.raises(ValueError, match="phases: in all of them the mass is held"):
        ns.solve(scene(), phases="stick,rest")


def test_phases_that_shrink_to_nothing_together_are_no_orbit() -> None:
    """Impacts lose energy: on the belt the motion ends at the stop, a solution of no period."""
    V, r = sp.symbols("V r", positive=True)
    stop, before = Event(x - g, jump={v: -r * v}), {"before the stop": g - x}
    slower = m * a + c * v + k * x - f
    holds = f - k * x - c * V
    slip = Phase("slower", slower, Event(v - V) | stop, {"slower": V - v, **before})
    stick = Phase("stick", a, Event(holds) | stop, {"it sticks": holds, **before}, held=V)
    own = of_unit(damping=0.15, friction=0.3, gap=0.13)
    own += parameters(belt=(V, "m/s", 1.0), r=(r, "", 0.67))
    with pytest.raises(NoOrbit, match="chatter"):
        ns.exact(scene_of("belt-stop", own, stick, slip)())
