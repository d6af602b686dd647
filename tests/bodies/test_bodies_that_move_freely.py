"""Bodies that nothing holds but their contacts: a ball in a slot, a pair of gears.

A particle between two walls has a closed form; a ball in a slot is moved on by matrix
exponentials in physical coordinates; a pair of gears moves as one mass of the reduced inertia.
"""

import numpy as np
import pytest
import sympy as sp
from exponentials import generator
from made_scenes import in_a_row, parameters, scene_of
from scipy.linalg import expm

import nonsmooth as ns
from nonsmooth.scene import Body, Event, Phase
from nonsmooth.solver import chart, in_order
from nonsmooth.solver import exact as solver_exact
from nonsmooth.solver.bodies.exact import evaluated
from nonsmooth.solver.charts import curves, lines
from nonsmooth.solver.kernels.account import Account
from nonsmooth.solver.scenes.ordered import of_all_phases
from nonsmooth.solver.simulation import settle
from nonsmooth.solver.simulation.settle import from_several_states

F, g, k, r, Omega = sp.symbols("F g k r Omega", positive=True)

#: A driven mass on a spring, and a ball in a slot of it.
MASSES, SPRING, DAMPER = np.array([1.0, 0.05]), np.diag([1.0, 0.0]), np.diag([0.02, 0.0])

#: Values of the parameters, as far as a test does not say others.
VALUES = {"force": 0.03, "gap": 0.5, "frequency": 1.0, "restitution": 0.7, "stiffness": 1.0}


def scene(name: str, M, K, at, contact, forcing=(1, 0), half=True, **more):
    """Return the scene of a body whose contact is between two walls, or two springs."""
    body = Body(M=M, K=K, forcing=[F * q for q in forcing], at={"ball": at}, **more)
    ball = body.at["ball"]
    inside = {"in the slot": g - sp.Abs(ball.x)}
    if contact == "walls":
        jump = {ball.v: -r * ball.v}
        phases = [Phase("right", ball.force, Event(ball.x - g, jump=jump), inside)]
        if not half:
            phases.append(Phase("left", ball.force, Event(ball.x + g, jump=jump), inside))
        own = {"restitution": (r, "")}
    else:
        pushed = {"beyond": ball.x - g}
        touch = Phase("touch", ball.force + k * (ball.x - g), Event(ball.x - g), pushed)
        phases = [touch, Phase("free", ball.force, Event(ball.x + g), inside)]
        own = {"stiffness": (k, "N/m")}
    known = {"force": (F, "N"), "gap": (g, "m"), "frequency": (Omega, "rad/s"), **own}
    numbers = parameters(**{q: (*each, VALUES[q]) for q, each in known.items()})
    return scene_of(name, numbers, *phases, half_period=half, body=body)


def ball_in_a_slot(half: bool = True, weak: float = 0.0):
    """Return a driven mass with a ball between two ends of a slot in it, on a weak spring."""
    M, K = np.diag(MASSES), SPRING + np.diag([0.0, weak])
    return scene("ball", M, K, [-1, 1], "walls", half=half, C=DAMPER)


def particle():
    """Return a driven mass between two walls, on no spring."""
    return scene("particle", sp.eye(1), [[0]], [1], "walls", forcing=(1,))


def reach(values) -> tuple[float, float]:
    """Return a and b of ``a cos(phi) - b sin(phi) = 2 g``, which says when a particle impacts.

    It moves by ``x = -(F/Omega^2) cos(Omega t + phi) + w t + c`` from one wall to the other
    in half a period; w is what an impact asks for.
    """
    speed = values["force"] / values["frequency"]
    rebound = (1 + values["restitution"]) / (1 - values["restitution"])
    return 2 * speed / values["frequency"], np.pi * speed / values["frequency"] * rebound


def off(orbit, sides, half: bool = False) -> float:
    """Return how far from closed an orbit of the ball is, or from its switches, in gaps.

    Its phases end on these sides of the slot.  The state is looked for that closes best at the
    times of the orbit.
    """
    n, w = 2, np.array([-1.0, 1.0])
    force = [orbit.case.values["force"], 0.0]
    A = generator(np.diag(MASSES), SPRING, DAMPER, force, VALUES["frequency"])
    jump = np.eye(len(A))
    given = (1 + VALUES["restitution"]) / (w @ (w / MASSES)) * w / MASSES
    jump[n : 2 * n, n : 2 * n] -= np.outer(given, w)
    through, rows = np.eye(len(A)), []
    for phase in orbit.phases[: len(sides)]:
        through = expm(A * phase.duration) @ through
        rows.append(w @ through[:n])
        through = jump @ through
    sign = -1.0 if half else 1.0
    closed = np.eye(2 * n) - sign * through[: 2 * n, : 2 * n]
    waves = np.array([np.cos(orbit.forcing_phase), np.sin(orbit.forcing_phase), 1.0])
    left = np.vstack([closed, np.array(rows)[:, : 2 * n]])
    known = np.array(rows)[:, 2 * n :] @ waves
    right = np.concatenate(
        [sign * through[: 2 * n, 2 * n :] @ waves, VALUES["gap"] * np.array(sides) - known]
    )
    state = np.linalg.lstsq(left, right)[0]
    return float(np.abs(left @ state - right).max() / VALUES["gap"])


def test_a_particle_between_walls_has_its_closed_form() -> None:
    case = particle()(gap=0.2, force=0.1)
    a, b = reach(case.values)
    size, turn = np.hypot(a, b), np.arctan2(b, a)
    phases = [np.arccos(2 * case.values["gap"] / size) * sign - turn for sign in (1, -1)]
    orbit = ns.exact(case)
    apart = [
        abs(np.remainder(orbit.forcing_phase - q + np.pi, 2 * np.pi) - np.pi) for q in phases
    ]
    assert min(apart) < 1e-14
    assert [q.duration for q in orbit.phases] == pytest.approx([np.pi, np.pi], rel=1e-14)


@pytest.mark.parametrize(
    ("method", "order", "error"), [("ck-tau", 8, 1e-13), ("hb-ck", 20, 1e-6)]
)
def test_expansions_of_a_particle_converge(method: str, order: int, error: float) -> None:
    assert ns.solve(particle()(gap=0.2, force=0.1), method, order).errors.times < error


def test_the_branch_of_a_particle_turns_where_it_just_reaches_the_walls() -> None:
    case = particle()(gap=0.2, force=0.1)
    branch = ns.branch(case, "gap", 0.1, 1.0)
    (fold,) = [q for q in branch.events if q.kind == "fold"]
    assert fold.parameter == pytest.approx(np.hypot(*reach(case.values)) / 2, rel=1e-12)


@pytest.mark.parametrize("half", [True, False])
def test_the_orbit_of_a_ball_closes(half: bool) -> None:
    """As half a period, and as a whole one, whose closure leaves the place of the ball open."""
    case = ball_in_a_slot(half)()
    exact = ns.exact(case)
    assert off(exact, [1] if half else [1, -1], half) < 1e-13
    for method, order, error in (("ck-tau", 8, 1e-12), ("hb", 20, 1e-3), ("hb-ck", 20, 1e-6)):
        orbit = ns.solve(case, method, order)
        assert orbit.errors.times < error
        assert orbit.exact.durations == pytest.approx(exact.durations, rel=1e-12)
    sprung = ns.exact(ball_in_a_slot(half, weak=1e-8)())
    assert exact.multipliers == pytest.approx(sprung.multipliers, rel=1e-5)


def test_a_ball_settles_on_an_orbit_that_is_not_its_own_mirror_image() -> None:
    """Two impacts on each side, at times that differ."""
    case = ball_in_a_slot()(force=0.1)
    found = ns.solve(case, order=12, phases="right,right,-right,-right")
    assert found.stable
    assert off(found.exact, [1, 1, -1, -1]) < 1e-13
    said = next(q.words for q in from_several_states(of_all_phases(case)) if q.other)
    order = said.split("phases: ")[1].split(", in each")[0]
    assert ns.solve(case, order=12, phases=order).exact.stable
    last = [q.duration for q in ns.simulate(case, cycles=400).phases[-6:-2]]
    own = [q.duration for q in found.exact.phases]
    assert min(np.abs(np.roll(own, i) - last).max() for i in range(4)) < 1e-8


@pytest.mark.parametrize("bearing", [0.0, 0.3])
def test_gears_move_as_one_of_the_reduced_inertia(bearing: float) -> None:
    """Nothing sees how far both have turned; bearings brake that all the same."""
    inertias = np.array([2.0, 0.5])
    reduced = 1 / (1 / inertias).sum()
    C = 0.05 * np.array([[1, -1], [-1, 1]]) + bearing * np.diag(inertias)
    pair = scene(
        "gears", sp.diag(*inertias.tolist()), np.zeros((2, 2)), [1, -1], "springs", C=C
    )
    one = scene(
        "reduced", [[reduced]], [[0.0]], [1], "springs", forcing=(reduced / inertias[0],),
        C=[[0.05 + bearing * reduced]],
    )  # fmt: skip
    given = {"gap": 0.05, "force": 0.4}
    found, expected = ns.exact(pair(**given)), ns.exact(one(**given))
    assert found.durations == pytest.approx(expected.durations, rel=1e-12)
    assert found.forcing_phase == pytest.approx(expected.forcing_phase, rel=1e-12)
    beside = ns.solve(pair(**given), order=10)
    assert beside.errors.times < 1e-11
    seen = sorted(abs(expected.multipliers))
    assert sorted(abs(found.multipliers)) == pytest.approx(seen, abs=1e-11)
    assert {row.stable for row in ns.branch(pair(**given), "frequency", 0.98, 1.02)} == {True}


def test_nothing_pushes_back_from_one_stop() -> None:
    """The mean of the contact force would have to be zero."""
    M, K = np.eye(2), np.array([[1.0, -1.0], [-1.0, 1.0]])
    body = Body(M=M, K=K, C=0.1 * K, forcing=[F, 0], at={"end": [0, 1]})
    end = body.at["end"]
    touch = Phase("touch", end.force + k * (end.x - g), Event(end.x - g), {"in": end.x - g})
    free = Phase("free", end.force, Event(end.x - g), {"before the stop": g - end.x})
    own = parameters(
        force=(F, "N", 0.5), gap=(g, "m", 0.5), frequency=(Omega, "rad/s", 0.5),
        stiffness=(k, "N/m", 0.5),
    )  # fmt: skip
    one = scene_of("stop", own, touch, free, body=body)
    with pytest.raises(ns.NoOrbit, match="no admissible orbit was found"):
        ns.solve(one())


def test_that_nothing_holds_a_body_at_one_place_is_said() -> None:
    """A slider rubs wherever it is."""
    K = np.array([[1.0, -1.0], [-1.0, 1.0]])
    body = Body(M=np.eye(2), K=K, C=0.1 * K, forcing=[F, 0], at={"end": [0, 1]})
    end = body.at["end"]
    ahead = Phase("ahead", end.force + k, Event(end.v), {"ahead": end.v})
    back = Phase("back", end.force - k, Event(end.v), {"back": -end.v})
    own = parameters(
        force=(F, "N", 1.0), friction=(k, "N", 0.2), frequency=(Omega, "rad/s", 0.7)
    )
    one = scene_of("slider", own, ahead, back, body=body)
    with pytest.raises(ns.NoOrbit, match="nothing holds the body at one place"):
        ns.solve(one())


def test_a_map_has_the_fold_of_its_closed_form(monkeypatch) -> None:
    for module in (solver_exact, in_order):  # where there is no orbit it is soon said
        monkeypatch.setattr(module, "PHASES", 20)
    monkeypatch.setattr(in_order, "FEW", 20)
    monkeypatch.setattr(settle, "FEW", 5)
    monkeypatch.setattr(chart, "LINES", 2)
    monkeypatch.setattr(lines, "VALUES", 2)
    monkeypatch.setattr(curves, "MOST_SEEN", 0.3)
    monkeypatch.setattr(Account, "pays", lambda account: False)
    case = particle()(force=0.1)
    found = ns.chart(case, {"gap": (0.6, 0.65, 2), "restitution": (0.6, 0.62, 2)})
    values = dict(case.values)

    def largest(restitution: float) -> float:
        return float(np.hypot(*reach(values | {"restitution": restitution})) / 2)

    for i, restitution in enumerate((0.6, 0.62)):
        there = [motion is not None for motion in found.motion[i]]
        assert there == [gap < largest(restitution) for gap in (0.6, 0.65)]
    (curve,) = found.curves
    assert curve.kind == "fold"
    for gap, restitution in curve.points:
        assert gap == pytest.approx(largest(restitution), rel=1e-12)


def row():
    """Return some modes of masses in a row, which only its end holds."""
    n, K = 6, in_a_row([0, 4.0, 4.0, 4.0, 4.0, 4.0])
    own = scene(
        "row", np.eye(n) / n, K, np.eye(n)[-1].tolist(), "springs", forcing=[1, *[0] * (n - 1)],
        C=0.02 * K + 0.05 * np.eye(n) / n, modes=3,
    )  # fmt: skip
    return own(force=0.4, gap=0.1, stiffness=2.0)


@pytest.mark.parametrize("method", ["ck-tau", "hb-ck"])
def test_few_modes_of_a_row_that_only_its_end_holds(method: str) -> None:
    """What the modes left out answer to the forcing, and to the contact, is not held."""
    order, error = (20, 1e-11) if method == "ck-tau" else (30, 1e-5)
    assert ns.solve(row(), method, order).errors.times < error


def mass_before_a_stop(**values):
    """Return an undamped mass on a spring before a stop, as a body, and as one mass."""
    body = Body(M=sp.eye(1), K=sp.eye(1), forcing=[1], at={"mass": [1]})
    x, v, force = body.at["mass"].x, body.at["mass"].v, body.at["mass"].force
    flight = Phase("flight", force, Event(x - g, jump={v: -r * v}), {"before": g - x})
    known = {"gap": (g, "m"), "frequency": (Omega, "rad/s"), "restitution": (r, "")}
    own = parameters(**{q: (*each, values[q]) for q, each in known.items()})
    return scene_of("stop", own, flight, body=body)(), ns.scene("impact")(damping=0, **values)


@pytest.mark.parametrize("restitution", [0.5, 1.0])
def test_a_mode_that_repeats_itself_with_the_forcing(restitution: float) -> None:
    """Where it is, closing the cell does not say: the event does."""
    body, mass = mass_before_a_stop(gap=0.3, frequency=1.0, restitution=restitution)
    found, expected = ns.exact(body), ns.exact(mass)
    assert np.sin(found.forcing_phase) == pytest.approx(0, abs=1e-14)
    assert np.cos(found.forcing_phase) == pytest.approx(np.cos(expected.forcing_phase))
    assert found.extremes["displacement"] == pytest.approx(expected.extremes["displacement"])
    assert found.extremes["velocity"] == pytest.approx(expected.extremes["velocity"])


def test_rounding_over_rounding_is_no_orbit() -> None:
    """No velocity closes the cell, or any phase of the forcing solves it."""
    for case in mass_before_a_stop(gap=0.3, frequency=2.0, restitution=1.0):
        with pytest.raises(ns.NoOrbit, match="no real solution"):
            ns.exact(case)
    body, mass = mass_before_a_stop(gap=0.3, frequency=0.5, restitution=1.0)
    with pytest.raises(ns.NoOrbit, match="was found"):
        ns.exact(body)
    of_three = ns.exact(mass)
    assert of_three.case.scene.motion == "flight,flight,flight"
    _repeats(of_three)


def _repeats(orbit) -> None:
    """Check that a motion in the state of an orbit repeats it for 40 periods."""
    first, count = orbit.phases[0], len(orbit.phases)
    case, start = orbit.case.scene.base(**orbit.case.values), orbit.forcing_phase
    state = first.displacement, first.velocity
    motion = ns.simulate(case, state, 40 * orbit.case.cycles, forcing_phase=start)
    last = [q.duration for q in motion.phases[39 * count : 40 * count - 1]]
    assert last == pytest.approx(orbit.durations[:-1], rel=1e-11)


@pytest.mark.parametrize("frequency", [0.7, 1.6, 2.0])
def test_nothing_is_said_of_times_at_which_closing_is_singular(frequency: float) -> None:
    """Between two walls without loss, at equal durations: what is solved for is rounding."""
    walls = scene("walls", sp.eye(1), sp.eye(1), [1], "walls", forcing=(1,), half=False)
    cell = walls(force=1.0, frequency=frequency, restitution=1.0).cell
    found = evaluated(cell, np.array([cell.duration / 2, cell.duration / 2, 0.4]))
    assert np.isnan(found.residual[:2]).all()
    assert np.isnan(found.starts).all()


@pytest.mark.parametrize("frequency", [1.2, 1.5, 1.8])
def test_a_motion_without_loss_is_that_of_one_mass(frequency: float) -> None:
    """Its period alone says nothing of its size: closing is singular at any frequency."""
    body, mass = mass_before_a_stop(gap=0.3, frequency=frequency, restitution=1.0)
    found, expected = ns.exact(body), ns.exact(mass)
    assert np.exp(1j * found.forcing_phase) == pytest.approx(
        np.exp(1j * expected.forcing_phase), abs=1e-13
    )
    assert found.phases[0].velocity == pytest.approx(expected.phases[0].velocity, rel=1e-12)
    errors = ns.solve(body, "ck-tau", 16).errors
    assert max(errors.times, errors.switches) < 1e-13
    with pytest.raises(ns.NoOrbit, match="hb cannot compute one: nothing damps or holds"):
        ns.solve(body, "hb", 16)  # its forces would have to be constant


def test_without_loss_what_is_refused_is_told() -> None:
    for case in mass_before_a_stop(gap=0.3, frequency=2.5, restitution=1.0):
        with pytest.raises(ns.NoOrbit, match="these 2 solutions only"):
            ns.exact(case)


def test_where_a_motion_without_loss_almost_returns_there_is_an_orbit() -> None:
    """Nothing settles; of one impact a period there is none."""
    body, mass = (
        ns.exact(case) for case in mass_before_a_stop(gap=0.3, frequency=0.8, restitution=1.0)
    )
    assert body.case.scene.motion == mass.case.scene.motion == "flight,flight"
    assert body.durations == pytest.approx(mass.durations, rel=1e-12)
    _repeats(mass)


@pytest.mark.parametrize("half", [True, False])
def test_two_modes_that_repeat_themselves_with_the_forcing_grow(half: bool) -> None:
    """One event does not hold both: without a law that does, nothing closes."""
    turn, squares = np.array([[0.8, -0.6], [0.6, 0.8]]), [1.0, 9.0 if half else 4.0]
    body = Body(
        M=np.eye(2), K=turn @ np.diag(squares) @ turn.T, forcing=[0.3, 0.8], at={"end": [0, 1]}
    )
    x, v, force = body.at["end"].x, body.at["end"].v, body.at["end"].force
    flight = Phase("flight", force, Event(x - g, jump={v: -r * v}), {"before": g - x})
    own = parameters(
        gap=(g, "m", 0.3), frequency=(Omega, "rad/s", 1.0), restitution=(r, "", 0.7)
    )
    with pytest.raises(ns.NoOrbit, match="was found"):
        ns.exact(scene_of("two", own, flight, body=body, half_period=half)())
