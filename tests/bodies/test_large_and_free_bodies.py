"""Bodies of many degrees of freedom, that move nearly freely, or whose modes are resonant.

Modes against closed forms of rods and chains, orbits against matrix exponentials.
"""

import numpy as np
import pytest
import sympy as sp
from bodies.reference_bodies import cantilever
from exponentials import generator, repeating
from made_scenes import parameters, scene_of
from scipy import sparse
from scipy.linalg import expm

import nonsmooth as ns
from nonsmooth.scene import Body, Event, Memory, Parameter, Phase
from nonsmooth.solver.bodies import modal
from nonsmooth.solver.bodies import modes as natural
from nonsmooth.solver.bodies.force_series.layout import layout
from nonsmooth.solver.scenes.parameter_error import ParameterError

SPRING, GAP = 10.0, 0.5
k, g, Omega = sp.symbols("k g Omega", positive=True)


def case(M, K, frequency: float, pushed: int = 0, **body):
    """Return a body that is forced at one mass, with an elastic stop at its last."""
    n = M.shape[0]
    force, last = np.eye(n, 1, -pushed)[:, 0], np.eye(n, 1, 1 - n)[:, 0]
    own = Body(M=M, K=K, forcing=force, at={"tip": last}, **body)
    tip = own.at["tip"]
    touch = Phase("touch", tip.force + k * (tip.x - g), Event(tip.x - g), {"in": tip.x - g})
    free = Phase("free", tip.force, Event(tip.x - g), {"before the stop": g - tip.x})
    known = parameters(
        stop=(k, "N/m", SPRING), gap=(g, "m", GAP), frequency=(Omega, "rad/s", frequency)
    )
    return scene_of("one-stop", known, touch, free, body=own)()


def off_the_stop(orbit, M, C, K, frequency: float) -> float:
    """Return how far the tip is from the stop at the switches, by matrix exponentials."""
    n, w, flows = len(M), np.eye(len(M))[-1], []
    for phase, spring in zip(orbit.phases, (SPRING, 0.0), strict=True):
        stiff = K + spring * np.outer(w, w)
        A = generator(M, stiff, C, np.eye(n)[0], frequency, spring * GAP * w)
        flows.append(expm(A * phase.duration))
    X = repeating(flows[1] @ flows[0], orbit.forcing_phase)
    return max(abs(X[n - 1] - GAP), abs((flows[0] @ X)[n - 1] - GAP)) / GAP


def chain(n: int) -> tuple[sparse.csc_array, sparse.csc_array]:
    """Return unit masses in a row, the first held by a spring, all springs of stiffness 1."""
    middle = np.full(n, 2.0)
    middle[-1] = 1.0
    K = sparse.diags_array([middle, -np.ones(n - 1), -np.ones(n - 1)], offsets=[0, 1, -1])
    return sparse.eye_array(n).tocsc(), K.tocsc()


@pytest.mark.parametrize("jumps", [False, True])
@pytest.mark.parametrize("n", [2000, 20_000])
def test_modes_and_static_answers_of_long_chains(n: int, jumps: bool) -> None:
    M, K = chain(n)
    at, force = np.eye(n, 1, 1 - n), np.eye(n, 1)
    slowest = 2 * np.sin(np.pi / (4 * n + 2))
    given = {"M": M, "K": K, "at": sparse.csc_array(at), "forcing": sparse.csc_array(force)}
    found = modal.modal(given, 20, 9 * slowest**2, jumps)
    angles = (2 * np.arange(20) + 1) * np.pi / (2 * n + 1)
    squares = 4 * np.sin(angles / 2) ** 2
    assert found.squares[:20] == pytest.approx(squares, rel=1e-12 * n)
    shapes = np.sin(np.outer(angles, [1, n])) / np.sqrt((2 * n + 1) / 4)
    ends = shapes[:, 1] * np.sign(shapes[:, 0])
    seen, driven = found.at[:, 0], found.forcing
    assert seen[:20] * np.sign(driven[:20]) == pytest.approx(ends, rel=1e-7)
    assert found.mobility == pytest.approx(1.0)
    # the end of the chain gives way by n under a unit force, and by 1 under one at its begin
    assert len(seen) == 20 + jumps
    compliance = found.residual[0, 0] + seen @ (seen / found.squares)
    assert compliance == pytest.approx(n, rel=1e-12 * n)
    across = found.beyond[0].real + seen @ (driven / found.squares)
    assert across == pytest.approx(1.0, abs=1e-7 * n)


@pytest.mark.parametrize("damping", ["ratio", "C"])
def test_few_modes_are_those_of_full_matrices(damping: str, monkeypatch) -> None:
    M, K = chain(300)
    at, force = np.eye(300, 1, -299), np.eye(300, 1)
    given = {"M": M, "K": K, "at": sparse.csc_array(at), "forcing": sparse.csc_array(force)}
    ratio = 0.01 if damping == "ratio" else None
    if damping == "C":
        given["C"] = (0.01 * K + sparse.csc_array(0.02 * force @ force.T)).tocsc()
    few = modal.at_frequency(modal.damped(modal.modal(given, 12, 4e-4), ratio), given, 0.02)
    monkeypatch.setattr(natural, "MANY", 0.0)
    full = modal.at_frequency(modal.damped(modal.modal(given, 12, 4e-4), ratio), given, 0.02)
    turn = np.sign(few.forcing * full.forcing)
    assert few.squares == pytest.approx(full.squares, rel=1e-9)
    assert few.at == pytest.approx(full.at * turn[:, None], abs=1e-10)
    assert few.damping == pytest.approx(full.damping * np.outer(turn, turn), abs=1e-10)
    assert few.beyond == pytest.approx(full.beyond, rel=1e-8)


@pytest.mark.parametrize("jumps", [False, True])
def test_what_is_left_out_keeps_its_digits_at_the_resonance_of_a_mode(jumps: bool) -> None:
    """There the answers of the body and of its modes are large, and their difference small."""
    n = 30
    M, K = chain(n)
    at, force = np.eye(n, 1, -15), np.eye(n, 1, -4)
    given = {"M": M, "K": K, "at": sparse.csc_array(at), "forcing": sparse.csc_array(force)}
    given["C"] = (1e-4 * M + 1e-5 * K).tocsc()
    angles = (2 * np.arange(n) + 1) * np.pi / (2 * n + 1)
    squares = 4 * np.sin(angles / 2) ** 2
    shapes = np.sin(np.outer(np.arange(1, n + 1), angles)) / np.sqrt((2 * n + 1) / 4)
    omega = np.sqrt(squares[0]) * (1 + 1e-6)
    few = modal.at_frequency(modal.modal(given, 2, 0.01, jumps), given, omega)
    answers = shapes[15] * shapes[4]
    answers = answers / (squares - omega**2 + 1j * omega * (1e-4 + 1e-5 * squares))
    retained = np.zeros(2, complex)
    if jumps:
        rows = np.diag(few.squares - omega**2) + 1j * omega * few.damping
        retained = few.at[:, 0] * np.linalg.solve(rows, few.forcing.astype(complex))
    expected = answers[2:].sum() - retained[2:].sum()
    assert few.beyond[0] == pytest.approx(expected, rel=3e-14)


@pytest.mark.parametrize("jumps", [False, True])
@pytest.mark.parametrize("modes", [1, 3])
def test_what_is_left_out_answers_where_a_rotor_turns(modes: int, jumps: bool) -> None:
    """A gyroscopic C is not symmetric: the modes and the rest act on each other differently."""
    n, omega = 6, 0.4
    M, K = chain(n)
    at, force = np.eye(n, 1), np.eye(n, 1, 1 - n)
    turns = sparse.diags_array([0.6, -0.6], offsets=[1, -1], shape=(n, n))
    given = {"M": M, "K": K, "at": sparse.csc_array(at), "forcing": sparse.csc_array(force)}
    given["C"] = (0.05 * K + turns).tocsc()
    few = modal.at_frequency(modal.modal(given, modes, 0.01, jumps), given, omega)
    rows = np.diag(few.squares - omega**2) + 1j * omega * few.damping
    retained = few.at[:, 0] @ np.linalg.solve(rows, few.forcing.astype(complex))
    stiffness = (K - omega**2 * M + 1j * omega * given["C"]).toarray()
    expected = (at.T @ np.linalg.solve(stiffness, force))[0, 0]
    assert retained + few.beyond[0] == pytest.approx(expected, rel=1e-12)


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


def scene_with_jumps(name: str):
    """Return a law on a row of masses that leaves no room for a compliance without mass."""
    w, (f, c, modes) = sp.Symbol("w", real=True), sp.symbols("f c n_m", positive=True)
    M, K = (q.toarray() for q in chain(12))
    row = Body(
        M=M, K=K, ratio=0.05, modes=modes, forcing=np.eye(12)[5], at={"end": np.eye(12)[-1]}
    )
    end = row.at["end"]
    pull, stop = k * (end.x - w), end.force + k * (end.x - f) + c * end.v
    slips = Phase("slip", end.force + f, Event(end.v), {"it slips": end.v})
    holds = {"it holds": f - sp.Abs(pull)}
    free = Phase("free", end.force, Event(end.x - f), {"before": f - end.x})
    own = parameters(spring=(k, "N/m", 0.5), frequency=(Omega, "rad/s", 0.4))
    own += (Parameter("modes", modes, "", 12.0, "modes", most=12),)
    if name == "slider":
        hold = Phase("hold", end.force + pull, Event(pull + f), holds)
        own += parameters(friction=(f, "N", 0.3))
        memory = (Memory(w, "hold", end.x - f / k, "the slider"),)
        return scene_of(name, own, slips, hold, memory=memory, half_period=True, body=row)
    touch = Phase("touch", stop, Event(end.x - f), {"in": end.x - f})
    own += parameters(gap=(f, "m", 0.1), damping=(c, "N s/m", 0.3))
    return scene_of(name, own, touch, free, body=row)


@pytest.mark.parametrize("name", ["slider", "damped-stop"])
def test_modes_left_out_have_a_mass_where_a_force_may_jump(name: str) -> None:
    """Of one mode left out that is the mode itself; of several the force does not leap."""
    scene = scene_with_jumps(name)
    whole, but_one, few = (ns.solve(scene(modes=count), order=20) for count in (12, 11, 6))
    assert not few.case.cell.body.residual.any()
    assert len(few.case.cell.body.squares) == 7
    durations = [[q.duration for q in orbit.phases] for orbit in (whole, but_one, few)]
    assert durations[1] == pytest.approx(durations[0], rel=1e-11)
    assert durations[2] == pytest.approx(durations[0], rel=0.02)
    sizes = [sorted(np.abs(orbit.multipliers))[-4:] for orbit in (whole, but_one)]
    assert sizes[1] == pytest.approx(sizes[0], rel=1e-8)


def test_static_shapes_give_way_as_the_whole_body_does() -> None:
    """At two contacts; a third that is their sum adds no shape."""
    M, K = chain(40)
    at = np.zeros((40, 3))
    at[39, 0] = at[20, 1] = 1.0
    at[:, 2] = at[:, 0] + at[:, 1]
    given = {"M": M, "K": K, "at": sparse.csc_array(at)}
    found = modal.modal(given, 8, 0.01, jumps=True)
    assert found.at.shape == (10, 3)
    compliance = at.T @ np.linalg.solve(K.toarray(), at)
    assert found.at.T @ (found.at / found.squares[:, None]) == pytest.approx(compliance)
    assert not found.residual.any()
    assert found.squares[8:].min() > found.squares[:8].max()


@pytest.mark.parametrize(("width", "admitted"), [(2.0, True), (0.1, False)])
def test_a_demand_may_have_the_modulus_of_any_contact(width: float, admitted: bool) -> None:
    """A mass in the middle of a row must stay within a width, which the end does not know."""
    d = sp.Symbol("d", positive=True)
    M, K = (q.toarray() for q in chain(3))
    own = Body(
        M=M, K=K, C=K / 10, forcing=np.eye(3)[0] / 2, at={"end": [0, 0, 1], "middle": [0, 1, 0]}
    )
    end, middle = own.at.values()
    within = {"the middle stays within": d - sp.Abs(middle.x)}
    laws = (end.force + k * (end.x - g), middle.force), (end.force, middle.force)
    touch = Phase("touch", laws[0], Event(end.x - g), {"in": end.x - g} | within)
    free = Phase("free", laws[1], Event(end.x - g), {"before": g - end.x} | within)
    numbers = parameters(
        stop=(k, "N/m", 5.0), gap=(g, "m", 0.3), width=(d, "m", width),
        frequency=(Omega, "rad/s", 0.9),
    )  # fmt: skip
    row = scene_of("row", numbers, touch, free, body=own)()
    if admitted:
        assert ns.solve(row, order=10).stable
    else:
        with pytest.raises(ns.NoOrbit, match="not true that the middle stays within"):
            ns.solve(row, order=10)


def test_a_light_mass_that_rings_on_a_damped_stop_leaves_it() -> None:
    """The ringing is over in a thousandth of a contact in which nothing else moves it off."""
    K, C = ([[p + q, -q], [-q, q]] for p, q in ((3.130147777, 1.583422211), (4.1173363, 0.031)))
    body = Body(M=np.diag([1.0, 0.011537795]), K=K, C=C, forcing=[1, 0], at={"end": [0, 1]})
    end, stop = body.at["end"], sp.Symbol("c_s", positive=True)
    on_it = end.force + k * (end.x - g) + stop * end.v
    touch = Phase("touch", on_it, Event(end.x - g), {"it presses": end.x - g})
    free = Phase("free", end.force, Event(end.x - g), {"before the stop": g - end.x})
    own = parameters(
        stiffness=(k, "N/m", 36843911.7), damping=(stop, "N s/m", 43.987),
        gap=(g, "m", 0.314376219), frequency=(Omega, "rad/s", 0.120390585),
    )  # fmt: skip
    ringing = scene_of("ringing", own, touch, free, body=body)()
    with pytest.raises(
        ns.NoOrbit, match=r"touch 1\.97\d* s, in touch, not true that it presses"
    ):
        ns.exact(ringing)
