"""Bodies of many degrees of freedom, that move nearly freely, or whose modes are resonant.

Modes against closed forms of rods and chains, orbits against matrix exponentials.
"""

import numpy as np
import pytest
import sympy as sp
from bodies.reference_bodies import cantilever
from scipy import sparse
from scipy.linalg import expm

import nonsmooth as ns
from nonsmooth.scene import Body, Event, Memory, Parameter, Phase, Scene
from nonsmooth.solver.bodies import modal
from nonsmooth.solver.bodies.layout import layout
from nonsmooth.solver.scenes.parameter_error import ParameterError

SPRING, GAP = 10.0, 0.5
k, g, Omega = sp.symbols("k g Omega", positive=True)


@pytest.fixture(autouse=True)
def _cache(tmp_path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))


def case(M, K, frequency: float, pushed: int = 0, **body):
    """Return a body that is forced at one mass, with an elastic stop at its last."""
    n = M.shape[0]
    force, last = np.eye(n, 1, -pushed)[:, 0], np.eye(n, 1, 1 - n)[:, 0]
    own = Body(M=M, K=K, forcing=force, at={"tip": last}, **body)
    tip = own.at["tip"]
    touch = Phase("touch", tip.force + k * (tip.x - g), Event(tip.x - g), {"in": tip.x - g})
    free = Phase("free", tip.force, Event(tip.x - g), {"before the stop": g - tip.x})
    return ns.scene(
        Scene(
            "one-stop", "a body with a stop", body=own, frequency=Omega, phases=(touch, free),
            parameters=(
                Parameter("stop", k, "N/m", SPRING, "spring"),
                Parameter("gap", g, "m", GAP, "gap"),
                Parameter("frequency", Omega, "rad/s", frequency, "frequency"),
            ),
        )
    )()  # fmt: skip


def off_the_stop(orbit, M, C, K, frequency: float) -> float:
    """Return how far the tip is from the stop at the switches, by matrix exponentials."""
    n, w, flows = len(M), np.eye(len(M))[-1], []
    for phase, pressed in zip(orbit.phases, (1.0, 0.0), strict=True):
        A = np.zeros((2 * n + 3, 2 * n + 3))
        A[:n, n : 2 * n] = np.eye(n)
        stiff = K + pressed * SPRING * np.outer(w, w)
        right = np.column_stack([-stiff, -C, np.eye(n)[0], 0 * w, pressed * SPRING * GAP * w])
        A[n : 2 * n] = np.linalg.solve(M, right)
        A[-3, -2], A[-2, -3] = -frequency, frequency
        flows.append(expm(A * phase.duration))
    period, own = flows[1] @ flows[0], slice(0, 2 * n)
    waves = np.array([np.cos(orbit.forcing_phase), np.sin(orbit.forcing_phase), 1.0])
    state = np.linalg.solve(np.eye(2 * n) - period[own, own], period[own, 2 * n :] @ waves)
    X = np.concatenate([state, waves])
    return max(abs(X[n - 1] - GAP), abs((flows[0] @ X)[n - 1] - GAP)) / GAP


def chain(n: int) -> tuple[sparse.csc_array, sparse.csc_array]:
    """Return unit masses in a row, the first held by a spring, all springs of stiffness 1."""
    middle = np.full(n, 2.0)
    middle[-1] = 1.0
    K = sparse.diags_array([middle, -np.ones(n - 1), -np.ones(n - 1)], offsets=[0, 1, -1])
    return sparse.eye_array(n).tocsc(), K.tocsc()


@pytest.mark.parametrize("n", [2000, 100_000])
def test_modes_and_static_answers_of_long_chains(n: int) -> None:
    M, K = chain(n)
    at, force = np.eye(n, 1, 1 - n), np.eye(n, 1)
    slowest = 2 * np.sin(np.pi / (4 * n + 2))
    given = {"M": M, "K": K, "at": sparse.csc_array(at), "forcing": sparse.csc_array(force)}
    found = modal.modal(given, 20, 9 * slowest**2)
    angles = (2 * np.arange(20) + 1) * np.pi / (2 * n + 1)
    squares = 4 * np.sin(angles / 2) ** 2
    assert found.squares == pytest.approx(squares, rel=1e-12 * n)
    shapes = np.sin(np.outer(angles, [1, n])) / np.sqrt((2 * n + 1) / 4)
    ends = shapes[:, 1] * np.sign(shapes[:, 0])
    assert found.at[:, 0] * np.sign(found.forcing) == pytest.approx(ends, rel=1e-7)
    assert found.mobility == pytest.approx(1.0)
    # the end of the chain gives way by n under a unit force, and by 1 under one at its begin
    assert found.residual[0, 0] == pytest.approx(n - ends @ (ends / squares), rel=1e-7)
    across = 1 - (shapes[:, 0] / squares) @ shapes[:, 1]
    assert found.beyond[0].real == pytest.approx(across, abs=1e-7 * n)


@pytest.mark.parametrize("damping", ["ratio", "C"])
def test_few_modes_are_those_of_full_matrices(damping: str, monkeypatch) -> None:
    M, K = chain(300)
    at, force = np.eye(300, 1, -299), np.eye(300, 1)
    given = {"M": M, "K": K, "at": sparse.csc_array(at), "forcing": sparse.csc_array(force)}
    ratio = 0.01 if damping == "ratio" else None
    if damping == "C":
        given["C"] = (0.01 * K + sparse.csc_array(0.02 * force @ force.T)).tocsc()
    few = modal.at_frequency(modal.damped(modal.modal(given, 12, 4e-4), ratio), given, 0.02)
    monkeypatch.setattr(modal, "MANY", 0.0)
    full = modal.at_frequency(modal.damped(modal.modal(given, 12, 4e-4), ratio), given, 0.02)
    turn = np.sign(few.forcing * full.forcing)
    assert few.squares == pytest.approx(full.squares, rel=1e-9)
    assert few.at == pytest.approx(full.at * turn[:, None], abs=1e-10)
    assert few.damping == pytest.approx(full.damping * np.outer(turn, turn), abs=1e-10)
    assert few.residual == pytest.approx(full.residual, rel=1e-9)
    assert few.beyond == pytest.approx(full.beyond, rel=1e-8)


def test_the_orbit_of_a_large_body_is_that_of_a_small_one() -> None:
    """A rod of one length, mass and stiffness as masses, whose end moves by half of one."""
    times = []
    for n, modes in ((150, None), (150, 20), (2000, 20)):
        M, K = chain(n)
        rod = case(M / n, n * K, 1.8, n // 2 - 1, ratio=0.02, modes=modes)
        times.append([q.duration for q in ns.solve(rod, order=12).phases])
    assert times[1] == pytest.approx(times[0], rel=1e-4)
    assert times[2] == pytest.approx(times[1], rel=1e-2)


def test_a_mesh_too_fine_for_its_digits_is_refused() -> None:
    beam = cantilever({"ne": 1500, "tip": 0.0, "alpha": 0.0, "beta": 0.0})
    with pytest.raises(ParameterError, match="K: rounding of its entries may change"):
        ns.exact(case(beam["M"], beam["K"], 1.0, ratio=0.02, modes=5))


FREE = np.array([[1.0, -1.0, 0.0], [-1.0, 2.0, -1.0], [0.0, -1.0, 1.0]])


@pytest.mark.parametrize("weak", [1e-6, 1e-8])
def test_a_body_that_moves_almost_freely(weak: float) -> None:
    """On a weak spring to the ground."""
    K, C = FREE + np.diag([weak, 0.0, 0.0]), 0.1 * np.eye(3)
    found = case(np.eye(3), K, 0.6, C=C)
    orbit = ns.solve(found, order=12)
    assert orbit.errors.times < 1e-11
    assert off_the_stop(orbit.exact, np.eye(3), C, K, 0.6) < 1e-11


TWO = np.array([[2.0, -1.0], [-1.0, 1.0]])


FIRST = float(np.sqrt((3 - np.sqrt(5)) / 2))


def test_an_undamped_mode_in_resonance() -> None:
    """The stop limits it."""
    orbit = ns.solve(case(np.eye(2), TWO, FIRST), order=14)
    assert orbit.errors.times < 1e-11
    assert off_the_stop(orbit.exact, np.eye(2), np.zeros((2, 2)), TWO, FIRST) < 1e-12


def test_an_undamped_mode_at_a_multiple_of_the_forcing() -> None:
    held = layout(case(np.eye(2), TWO, FIRST / 2).cell, 5).poles.held
    assert held is not None


def test_a_resonance_that_no_contact_sees_is_refused() -> None:
    K = np.block([[TWO, np.zeros((2, 1))], [np.zeros((1, 2)), np.eye(1)]])
    order = [2, 0, 1]  # the forcing is at the first mass, the stop at the last
    with pytest.raises(modal.BodyError, match="no contact sees it"):
        layout(case(np.eye(3), K[np.ix_(order, order)], 0.5).cell, 5)


def test_next_to_a_resonance_the_orbit_is_right() -> None:
    frequency = FIRST * (1 + 1e-5)
    orbit = ns.solve(case(np.eye(2), TWO, frequency), order=12)
    assert orbit.errors.times < 1e-10
    assert off_the_stop(orbit.exact, np.eye(2), np.zeros((2, 2)), TWO, frequency) < 1e-9


def test_critical_damping_is_refused() -> None:
    with pytest.raises(ParameterError, match="body: two of its poles are one"):
        ns.solve(case(np.eye(2), TWO, 0.9, ratio=1.0))


def test_equal_frequencies_are_all_found() -> None:
    """Two rows side by side, which nothing couples: each frequency twice."""
    M, K = (sparse.block_diag([q, q]).tocsc() for q in chain(1000))
    at = sparse.csc_array(np.eye(2000, 1, -1999))
    found = modal.modal({"M": M, "K": K, "at": at}, 12, 2.5e-5)
    angles = np.repeat(2 * np.arange(6) + 1, 2) * np.pi / 2001
    assert found.squares == pytest.approx(4 * np.sin(angles / 2) ** 2, rel=1e-8)


def slider(spring: float, **body):
    """Return a body with a contact on a spring and a slider in series."""
    w, friction = sp.Symbol("w", real=True), sp.Symbol("f", positive=True)
    own = Body(at={"tip": body.pop("at")}, **body)
    tip = own.at["tip"]
    pull = k * (tip.x - w)
    slip = Phase("slip", tip.force + friction, Event(tip.v), {"it slips": tip.v})
    hold = Phase(
        "hold", tip.force + pull, Event(pull + friction), {"it holds": friction - sp.Abs(pull)}
    )
    return ns.scene(
        Scene(
            "slider", "a body with a slider", body=own, frequency=Omega, phases=(slip, hold),
            half_period=True, memory=(Memory(w, "hold", tip.x - friction / k, "the slider"),),
            parameters=(
                Parameter("spring", k, "N/m", spring, "spring"),
                Parameter("friction", friction, "N", 0.3, "friction"),
                Parameter("frequency", Omega, "rad/s", 1.0, "frequency"),
            ),
        )
    )()  # fmt: skip


@pytest.fixture(scope="module")
def shortened(tmp_path_factory):
    """Return a body on a slider of which modes are left out, and the same without them.

    What modes left out add to a contact is a spring in series with that of its law.
    """
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("XDG_CACHE_HOME", str(tmp_path_factory.mktemp("cache")))
        damped = {"ratio": 0.3}
        M, K = (q.toarray() for q in chain(12))
        slowest = np.linalg.eigh(K)[1][:, 0]  # no other mode is forced
        few = slider(10.0, M=M, K=K, at=np.eye(12)[-1], forcing=3 * slowest, **damped, modes=3)
        own = few.cell.body.in_units(*(1 / unit for unit in vars(few.units).values()))
        series = 1 / (1 / 10.0 + own.residual[0, 0])
        rest = {"at": own.at[:, 0], "forcing": own.forcing, **damped}
        yield few, slider(series, M=np.eye(3), K=np.diag(own.squares), **rest)


@pytest.mark.parametrize("method", ["ck-tau", "hb-ck"])
def test_a_slider_has_the_spring_of_modes_that_are_left_out(shortened, method: str) -> None:
    """What it remembers is where the contact is under its force, which does not jump."""
    few, whole = (ns.solve(case, method, order=16) for case in shortened)
    assert few.case.cell.body.residual[0, 0] > 1e-3
    durations = [[q.duration for q in orbit.phases] for orbit in (few, whole)]
    assert durations[0] == pytest.approx(durations[1], rel=1e-12)
    assert few.forcing_phase == pytest.approx(whole.forcing_phase, abs=1e-12)
    sizes = [sorted(np.abs(orbit.multipliers)) for orbit in (few, whole)]
    assert sizes[0] == pytest.approx(sizes[1], rel=1e-9, abs=1e-12)


def test_a_simulated_slider_has_the_spring_of_modes_that_are_left_out(shortened) -> None:
    few, whole = (ns.simulate(case, cycles=100) for case in shortened)
    for one, other in zip(few.segments[-6:-1], whole.segments[-6:-1], strict=True):
        assert one.phase.name == other.phase.name
        assert one.s == pytest.approx(other.s, rel=1e-9)


def test_a_branch_of_a_slider_has_the_spring_of_modes_that_are_left_out(shortened) -> None:
    few, whole = (ns.branch(case, "frequency", 1.0, 1.3) for case in shortened)
    assert [q.kind for q in few.events] == [q.kind for q in whole.events]
    ends = [branch.rows[-1].durations for branch in (few, whole)]
    assert ends[0] == pytest.approx(ends[1], rel=1e-11)
