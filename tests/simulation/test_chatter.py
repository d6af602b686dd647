"""Impacts that accumulate, and the rest on a stop behind them."""

import math

import mpmath
import numpy as np
import pytest
import sympy as sp
from made_scenes import parameters, scene_of
from stops import DAMPING, GAP, OMEGA, between_two, resting

import nonsmooth as ns
from nonsmooth.scene import Event, Phase, a, forcing, v, x


def accumulation(t, v, restitution):
    """Return when impacts accumulate behind one at a time and a speed, to 30 digits."""
    with mpmath.workdps(40):
        roots = mpmath.polyroots([1, mpmath.mpf(DAMPING), 1])
        wave = 1 / (1 - mpmath.mpf(OMEGA) ** 2 + mpmath.mpc(0, OMEGA * DAMPING))
        t, v, omega = mpmath.mpf(t), mpmath.mpf(v), mpmath.mpf(OMEGA)
        while v > 1e-30:
            turned = wave * mpmath.expj(omega * t)
            a = mpmath.matrix([[1, 1], roots])
            rest = mpmath.matrix([GAP - turned.real, -v - (1j * omega * turned).real])
            one, two = mpmath.lu_solve(a, rest)

            def x(s, derivative=0, one=one, two=two, turned=turned):
                parts = zip((one, two, turned), (*roots, 1j * omega), strict=True)
                return sum(c * r**derivative * mpmath.exp(r * s) for c, r in parts).real

            near = 2 * v / x(0, 2)
            ends = (near / 2, 2 * near)  # before the landing, and behind it
            s = mpmath.findroot(lambda s: (x(s) - GAP) / s, ends, solver="illinois")
            t, v = t + s, restitution * x(s, 1)
        return float(t)


@pytest.mark.parametrize("restitution", [1e-9, 0.3, 0.8])
def test_the_rest_begins_where_the_impacts_accumulate(restitution) -> None:
    motion = ns.simulate(resting(restitution), cycles=3)
    assert motion.ended == ""
    index = next(i for i, q in enumerate(motion.phases) if q.name == "phase 1")
    rest, before = motion.phases[index], motion.phases[index - 1]
    hit = next(q for q in motion.phases[1:] if q.duration < 0.1)  # a short flight
    expected = accumulation(hit.start, -hit.velocity, mpmath.mpf(restitution))
    # each impact, of a speed v, is located to the rounding of the gap, 1e-17, over v
    assert rest.start == pytest.approx(expected, rel=0, abs=1e-11)
    assert before.start + before.duration == rest.start
    assert (rest.displacement, rest.velocity) == (GAP, 0.0)
    # until the force does not press any more, where flight begins at rest
    end = rest.start + rest.duration
    assert end == pytest.approx(math.acos(GAP) / OMEGA, rel=1e-15)
    leaves = motion.phases[index + 1]
    assert (leaves.name, leaves.displacement, leaves.velocity) == ("phase 0", GAP, 0.0)
    assert motion.displacement(np.linspace(0, motion.time, 2001)).max() <= GAP + 1e-15


def test_an_impact_without_rebound_leads_into_the_rest() -> None:
    motion = ns.simulate(resting(0.0), cycles=3)
    assert [q.name for q in motion.phases] == ["phase 0", "phase 1"] * 4
    for rest in motion.phases[1::2]:
        assert (rest.displacement, rest.velocity) == (GAP, 0.0)
    one, other = motion.phases[3], motion.phases[5]  # one period, whatever was before
    period = 2 * math.pi / OMEGA
    assert other.start - one.start == pytest.approx(period, rel=1e-14)
    assert other.forcing_phase == pytest.approx(one.forcing_phase, abs=1e-14)


def test_without_a_force_that_presses_it_leaves_again() -> None:
    # hits the stop while the force already pulls it away
    motion = ns.simulate(resting(0.0), (-0.5, 3.0), cycles=0.2, forcing_phase=2.0)
    first, second = motion.phases[:2]
    assert (first.name, second.name) == ("phase 0", "phase 0")
    assert (second.displacement, second.velocity) == (GAP, 0.0)
    after = motion.displacement(second.start + np.linspace(1e-3, 0.5, 50))
    assert (after < GAP).all()


@pytest.mark.parametrize(("angle", "name"), [(0.0, "phase 1"), (3.0, "phase 0")])
def test_a_start_at_rest_on_the_stop(angle, name) -> None:
    first = ns.simulate(resting(0.5), (GAP, 0), cycles=0.1, forcing_phase=angle).phases[0]
    assert (first.name, first.displacement, first.velocity) == (name, GAP, 0.0)


def test_it_rests_on_the_stop_alone() -> None:
    # the same force, and at rest, but not there
    assert ns.simulate(resting(0.5), (0.05, 0), cycles=0.1).phases[0].name == "phase 0"
    # and not before its impacts have died away
    assert ns.simulate(resting(0.5), (GAP, -1e-10), cycles=0.1).phases[0].name == "phase 0"


def test_a_rest_that_refuses_is_not_entered() -> None:
    """It demands twice the force that there is: the impacts accumulate, and it ends."""
    motion = ns.simulate(resting(0.5, presses=(0, 0, 1, -2)), cycles=3)
    assert motion.ended.startswith("chatter: phase 0 ends ever sooner")
    assert {q.name for q in motion.phases} == {"phase 0"}


@pytest.mark.parametrize("restitution", [0.0, 0.4])
def test_between_two_stops_it_rests_on_either(restitution) -> None:
    case = between_two(restitution)
    one = ns.simulate(case, (0.02, 0.3), cycles=3, forcing_phase=0.4)
    other = ns.simulate(case, (-0.02, -0.3), cycles=3, forcing_phase=0.4 + math.pi)
    rests = [(q.mirrored, q.displacement) for q in one.phases if q.name == "phase 1"]
    assert set(rests) == {(False, GAP), (True, -GAP)}
    assert [q.name for q in one.phases] == [q.name for q in other.phases]
    for up, down in zip(one.phases, other.phases, strict=True):
        for found, expected in (
            (up.start, down.start), (up.displacement, -down.displacement),
            (up.velocity, -down.velocity),
        ):  # fmt: skip
            assert found == pytest.approx(expected, rel=0, abs=1e-11)  # as they are located


def test_without_a_rest_it_ends_with_a_word() -> None:
    # pressed against the stop by a force that changes slowly: r**n of the time that is left
    case = ns.scene("impact")(restitution=0.3, frequency=0.3, damping=0.3)
    motion = ns.simulate(case, cycles=10)
    assert motion.ended.startswith("chatter: flight ends ever sooner, the switches accumulate")
    t = float(motion.ended.partition("at t = ")[2].split()[0])
    rest = ns.simulate(resting(0.3), cycles=1)
    expected = next(q.start for q in rest.phases if q.name == "phase 1")
    assert t == pytest.approx(expected, rel=1e-8)  # as it is printed
    assert "ended: chatter" in repr(motion)


def test_phases_that_stay_as_short_are_not_chatter() -> None:
    """Between stops that are near each other a lossless mass goes to and fro for ever."""
    case = ns.scene("impact-two-sided")(gap=1e-9, restitution=1, damping=0, force=1e-3)
    motion = ns.simulate(case, (0, 0.02), time=5e-6)
    assert motion.ended == ""
    assert len(motion.phases) == pytest.approx(5e-6 * 0.02 / 2e-9, abs=1)


def test_impacts_that_accumulate_with_stops_by_friction_between_are_chatter() -> None:
    """Each jump off the stop ends by friction, then the force drives the mass back."""
    f, g, r, F, Omega = sp.symbols("f g r F Omega", positive=True)
    m, c, k = sp.symbols("m c k", positive=True)
    pull = k * x - F * forcing
    jump = Event(x - g, jump={v: -r * v}, to="-slip")
    ahead = {"ahead": v, "before the stop": g - x}
    slip = Phase("slip", m * a + c * v + pull + f, Event(v) | jump, ahead)
    ends = Event(pull - f, to="-slip") | Event(pull + f, to="slip")
    stick = Phase("stick", a, ends, {"it holds": f - sp.Abs(pull)}, held=0)
    own = parameters(
        m=(m, "kg", 1.0), c=(c, "N s/m", 0.151), k=(k, "N/m", 1.0), F=(F, "N", 1.0),
        frequency=(Omega, "rad/s", 0.9228), g=(g, "m", 0.2218), f=(f, "N", 0.1225),
        r=(r, "", 0.2019),
    )  # fmt: skip
    rub = scene_of("rub", own, slip, stick, half_period=True)()
    motion = ns.simulate(rub, (0.0, 0.0), cycles=10)
    assert motion.ended.startswith("chatter: slip ends ever sooner, the switches accumulate at")
    impact, stop, *_ = (q.duration for q in motion.phases[-4:])
    assert min(impact, stop) < 1e-6
