"""The flow of a body in its eigenbasis, and linear algebra of many unknowns."""

import mpmath as mp
import numpy as np
import pytest
from bodies.reference_bodies import case

import nonsmooth as ns
from nonsmooth.solver.bodies.flow import graded
from nonsmooth.solver.bodies.part import parts_of
from nonsmooth.solver.branch.bodies import exponential, watched, ways
from nonsmooth.solver.branch.bodies.arrays import UNKNOWN, case_of, known_of
from nonsmooth.solver.branch.bodies.factors import factorise, solve_factorised
from nonsmooth.solver.scenes.bodies.cell import BodyCell
from nonsmooth.solver.stability.cell_map import lasting
from nonsmooth.solver.stability.monodromy import monodromy


def exact(generator: np.ndarray, t: float) -> np.ndarray:
    """Return ``exp(generator t) - 1`` in 40 digits."""
    with mp.workdps(40):
        found = mp.expm(mp.matrix(generator) * mp.mpf(t)) - mp.eye(len(generator))
        return np.array(found.tolist(), dtype=float)


def own_basis(generator: np.ndarray, n: int) -> tuple[np.ndarray, ...]:
    """Return poles, basis and inverse of a phase, as `arrays.Known` has them."""
    scales = np.append(np.diag(generator[: n // 2, n // 2 : n]), np.ones(n - n // 2))
    poles, vectors = np.linalg.eig(generator[:n, :n])
    kept, inverse = poles.imag >= 0, np.linalg.inv(vectors) * scales
    vectors = vectors[:, kept] * np.where(poles[kept].imag > 0, 2.0, 1.0) / scales[:, None]
    basis = np.hstack([vectors.real, -vectors.imag])
    found = np.vstack([inverse[kept].real, inverse[kept].imag])
    return poles[kept].astype(complex), basis, found


def two_modes(omega: float, damping: float) -> np.ndarray:
    """Return rates of two modes, the second of 30 rad/s; a memory and waves drive both."""
    n, rng = 4, np.random.default_rng(7)
    generator = np.zeros((n + 4, n + 4))
    generator[:2, 2:4] = np.diag([1.5, 30.0])
    generator[2:4, :2] = -np.diag([1.5, 30.0])
    generator[2:4, 2:4] = -damping * np.diag([1.0, 0.1])
    generator[2:4, n:] = rng.normal(size=(2, 4))
    generator[n + 1, n + 2], generator[n + 2, n + 1] = -omega, omega
    return generator


OMEGAS = pytest.mark.parametrize("omega", [0.0, 1.3, 30.0])
DAMPINGS = pytest.mark.parametrize("damping", [0.0, 0.2, 100.0])


@OMEGAS
@DAMPINGS
def test_states_grow_as_exact_exponentials(omega: float, damping: float) -> None:
    n, generator = 4, two_modes(omega, damping)
    for t in (1e-9, 0.1, 7.0):
        wanted = exact(generator, t)
        size = np.abs(wanted).max()
        known = tuple(q[None] for q in own_basis(generator, n))
        way = ways.way_of((None, generator[None], *[None] * 5, known), 0)
        found = way[4] @ ways.added(way, t, way[5])
        assert found == pytest.approx(wanted, abs=3e-14 * size)
        assert exponential.exp_less_one(generator, t) == pytest.approx(wanted, abs=3e-13 * size)
    short = 0.2 / np.abs(generator).sum(axis=1).max() * generator
    wanted = exact(short, 1.0) - short - short @ short / 2
    assert exponential.exp_less_three_terms(short, 1.0) == pytest.approx(wanted, abs=1e-15)


@OMEGAS
@DAMPINGS
def test_coordinates_of_a_phase_are_its_states(omega: float, damping: float) -> None:
    """By the eigenbasis and without; at equal times, by halves of a step, and their rates."""
    n, generator, s = 4, two_modes(omega, damping), 7.0
    known = tuple(q[None] for q in own_basis(generator, n))
    begin = np.array([0.3, -1.0, 0.5, 2.0, 0.7, np.cos(0.4), np.sin(0.4), 1.0])
    exponent = [begin + exact(generator, q * s / 8) @ begin for q in range(9)]
    size, form = np.abs(exponent).max(), np.arange(1.0, 9.0)
    rates = [form @ np.linalg.matrix_power(generator, j) @ begin for j in range(4)]
    for basis in (known, UNKNOWN):
        way = ways.way_of((None, generator[None], *[None] * 5, basis), 0)
        forth, grid = way[4], ways.along(way, s, begin)
        every = (grid.shape[1] - 1) / 8
        if every.is_integer():
            assert forth @ grid[:, :: int(every)] == pytest.approx(
                np.transpose(exponent), abs=3e-12 * size
            )
        assert forth @ grid[:, -1] == pytest.approx(exponent[-1], abs=3e-12 * size)
        finer, y = ways.halves(way, s), grid[:, 0]
        for j in range(3):
            found = forth @ ways.over(way, finer, j, s / 2 ** (j + 1), y)
            assert found == pytest.approx(exponent[4 >> j], abs=3e-12 * size)
        assert forth @ ways.ahead(way, s / 8, y) == pytest.approx(exponent[1], abs=3e-12 * size)
        found = [
            way_rate @ y * factor
            for way_rate, factor in zip(ways.expanded(way, form), (1, 1, 2, 6), strict=False)
        ]
        assert found == pytest.approx(rates, rel=1e-11)


def stiff(seed: int) -> tuple[tuple, np.ndarray, np.ndarray]:
    """Return the way of a forced beam of 40 modes, its state behind a blow, and a form."""
    rng, m, Omega = np.random.default_rng(seed), 40, 1.3
    omega, shapes = np.arange(1, m + 1) ** 2.0, rng.uniform(0.5, 1.5, m)
    generator = np.zeros((2 * m + 3, 2 * m + 3))
    generator[:m, m : 2 * m] = np.diag(omega)  # displacements times frequencies
    generator[m : 2 * m, :m] = -np.diag(omega)
    generator[m : 2 * m, m : 2 * m] = -np.diag(2 * rng.choice([0.0, 0.01]) * omega)
    generator[m : 2 * m, 2 * m :] = np.outer(shapes, rng.normal(size=3))
    generator[2 * m, 2 * m + 1], generator[2 * m + 1, 2 * m] = -Omega, Omega
    known = tuple(q[None] for q in own_basis(generator, 2 * m))
    blow = shapes * rng.uniform(0.02, 1.0, m)
    begin = np.array([*0.1 * rng.normal(size=m) / omega, *blow, np.cos(0.4), np.sin(0.4), 1.0])
    form = np.array([*shapes / omega, *np.zeros(m + 3)])
    form[-1] -= form @ begin
    return ways.way_of((None, generator[None], *[None] * 5, known), 0), begin, form


@pytest.mark.parametrize("seed", range(10))
def test_no_pole_moves_farther_than_its_bound(seed: int) -> None:
    way, begin, form = stiff(seed)
    row = ways.expanded(way, form)[0]
    for h in (1.0, 0.05, 1e-3):
        y = way[5] @ begin
        moves = ways.moves_of(way, h, y[:, None])
        change = ways.may_change(way, h, y, moves, row)[0]
        for t in np.linspace(0, h, 30):
            z = ways.ahead(way, t, y) - y
            m = len(moves)
            assert (np.hypot(z[:m], z[m : 2 * m]) <= moves[:, 0] + 1e-15).all()
            assert abs(row @ z) <= change + 1e-15


def test_what_follows_the_forcing_hardly_moves() -> None:
    """Poles that are faster than the forcing, on their steady answers."""
    (way, begin, _), turn, h = stiff(0), 1.3j, 0.05
    _, poles, drives, _, _, _ = way
    m = len(poles)
    driven = drives[:m] + 1j * drives[m:]
    wave = begin[-3] + 1j * begin[-2]  # cos = (wave + 1/wave)/2, sin = (wave - 1/wave)/2i
    up, down = (driven[:, 0] - 1j * driven[:, 1]) / 2, (driven[:, 0] + 1j * driven[:, 1]) / 2
    z = up * wave / (turn - poles) + down / wave / (-turn - poles) - driven[:, 2] / poles
    y = np.array([*z.real, *z.imag, *begin[-3:]])
    moves = ways.moves_of(way, h, y[:, None])[:, 0]
    fast = np.abs(poles) > 2 * 1.3
    assert fast.sum() == m - 1
    most = h * 1.3 * np.sum(np.abs(driven[:, :2]), axis=1) / (np.abs(poles) - 1.3)
    assert (moves <= 1.01 * most)[fast].all()


@pytest.mark.parametrize("seed", range(10))
def test_dips_of_fast_modes_behind_a_blow_are_seen(seed: int, monkeypatch) -> None:
    """Against 30,000 steps, none of which is left out; 128 do not show a fast wave."""
    (way, begin, form), s = stiff(seed), 3.0
    terms = ways.expanded(way, form)
    grid = ways.along(way, s, begin)
    finer = ways.halves(way, s / (grid.shape[1] - 1))
    least, when = watched.least_inside(way, grid, s, finer, terms, 1)
    monkeypatch.setattr(ways, "MOST_BY_BASIS", 30_000)
    monkeypatch.setattr(ways, "CLOSE", 6.0)
    many = ways.along(way, s, begin)
    heights, h = terms[0] @ many, s / (many.shape[1] - 1)
    inner = heights[1:-1]
    lows = 1 + np.flatnonzero((inner <= heights[:-2]) & (inner <= heights[2:]))
    lowest = lows[np.argmin(heights[lows])]
    assert when == pytest.approx(lowest * h, abs=h)
    assert least == pytest.approx(heights[lowest], abs=2e-4 * np.ptp(heights))
    assert least <= heights[lowest]


def test_a_basis_stands_for_all_values_where_no_rate_depends_on_them() -> None:
    own = case("two-stops-six-phases")
    index = [q.name for q in own.scene.parameters].index("frequency")

    def at(factor: float) -> BodyCell:
        numbers = list(own.numbers)
        numbers[index] *= factor
        found = own.scene.cell(tuple(numbers), own.cycles, own.units)
        assert isinstance(found, BodyCell)
        return found

    here, there = at(1.0), at(1.25)
    entries = np.concatenate([q.ravel() for q in case_of(there, [])[1:6]])
    _, known = known_of(here, [there], np.column_stack([entries, 0 * entries]))
    assert np.isfinite(known.poles).all()
    bare = case_of(there, [])
    basis = (*bare[:7], (known.poles, known.basis, known.inverse))
    for p in range(len(here.phases)):
        states = np.eye(bare[1].shape[1])
        wanted = exact(bare[1][p], 2.0)
        found = ways.gained(basis, p, 2.0, states)
        assert found == pytest.approx(wanted, abs=1e-13 * np.abs(wanted).max())
        assert ways.gained(bare, p, 2.0, states) == pytest.approx(
            wanted, abs=1e-12 * np.abs(wanted).max()
        )


def test_no_basis_is_known_where_a_rate_depends_on_the_parameter() -> None:
    beam = ns.scene("beam-clearance")(modes=3)
    softer = beam.with_value("contact_stiffness", 1.5e3)
    here, there = (q.scene.cell(q.numbers, 1, beam.units) for q in (beam, softer))
    entries = np.concatenate([q.ravel() for q in case_of(here, [])[1:6]])
    _, known = known_of(here, [there], np.column_stack([entries, 0 * entries]))
    names = [phase.name for phase in here.phases]
    assert [bool(np.isfinite(q).all()) for q in known.poles] == [q != "contact" for q in names]


def test_slow_poles_have_their_own_digits() -> None:
    """Of a free beam with 60 modes, its quickest 1e5 times as quick as its slowest."""
    cell = ns.scene("beam-clearance")(modes=60).cell
    part = next(
        q for q, own in zip(parts_of(cell), cell.phases, strict=True) if own.name == "separated"
    )
    ratio, w = 0.01, np.sqrt(np.sort(cell.body.squares))
    wanted = w * (-ratio + 1j * np.sqrt(1 - ratio**2))
    poles = part.flow.upper.poles
    found = poles[np.argsort(np.abs(poles))]
    assert w[-1] > 1e4 * w[0]
    assert np.abs(found / wanted - 1).max() < 1e-13


def test_multipliers_of_what_lasts_are_all() -> None:
    """Of the same beam, of whose 120 multipliers most are nothing."""
    orbit = ns.exact(ns.scene("beam-clearance")(modes=60))
    matrix = monodromy(orbit)[0]
    lasts = lasting(matrix)
    assert len(lasts) < 60
    every = np.linalg.eigvals(matrix)
    every = every[np.argsort(-np.abs(every))][:20]
    found = orbit.multipliers[:20]
    apart = np.abs(found[:, None] - every).min(axis=1)
    assert np.abs(every[-1]) < 1e-3
    assert apart == pytest.approx(np.zeros(20), abs=1e-13)
    assert len(orbit.multipliers) == 120


def test_poles_that_are_one_are_left_as_they_are() -> None:
    A = np.array([[0.0, 1.0], [-1.0, -2.0]])
    poles, vectors = np.linalg.eig(A)
    found, turned = graded(A, poles, vectors)
    assert (found == poles).all()
    assert (turned == vectors).all()


@pytest.mark.parametrize("off", [1e-11, 1e-9, 1e-7, 1e-4, -1e-11, -1e-9, -1e-7, -1e-4])
def test_damping_that_is_almost_critical_loses_the_digits_of_its_poles(off: float) -> None:
    """That is as many as these are nearer to each other than to zero, and a few more."""
    cell = ns.scene("beam-clearance")(modes=3, ratio=1 + off).cell
    for part in parts_of(cell):
        flow, A, t = part.flow, part.lawful.A, cell.duration / 50
        exact = np.array(mp.expm(mp.matrix(A) * t).tolist(), dtype=float)
        lost = 1e-14 / abs(off) ** 0.5 if off > 0 else 1e-14
        assert np.abs(flow.matrix(t) - exact).max() <= lost * np.abs(exact).max()


def test_parts_that_rounding_alone_couples_stay_apart() -> None:
    """LAPACK balances 1e-16 against 1: a mode that no contact sees then has 1e-9 of it."""
    A = np.zeros((4, 4))
    A[0, 2], A[1, 3] = 1.1914001805471777, 1.297684049397667
    A[2, 0], A[2, 2] = -0.3520516423081393, -0.04100199928128231
    A[3, 1], A[3, 3] = -(2.0**-53), -1.0
    _, vectors = graded(A, *np.linalg.eig(A))
    parts = np.abs([vectors[[0, 2]], vectors[[1, 3]]]).max(axis=1)
    assert parts.min(axis=0).max() < 1e-14


@pytest.mark.parametrize("n", [1, 2, 31, 32, 33, 100])
def test_factors_block_by_block(n: int) -> None:
    rng = np.random.default_rng(n)
    A, b = rng.normal(size=(n, n)), rng.normal(size=n)
    factors, rows, x = A.copy(), np.empty(n, dtype=np.int64), b.copy()
    assert factorise(factors, rows)
    solve_factorised(factors, rows, x)
    assert x == pytest.approx(np.linalg.solve(A, b), rel=1e-9, abs=1e-11)
    sign = np.prod(np.where(rows == np.arange(n), 1.0, -1.0))
    assert sign * np.diag(factors).prod() == pytest.approx(np.linalg.det(A), rel=1e-10)


def test_a_singular_matrix_has_no_factors() -> None:
    assert not factorise(np.ones((40, 40)), np.empty(40, dtype=np.int64))


def test_a_flip_of_a_beam_of_60_modes() -> None:
    """By the matrices in 60 digits: modes, exponentials, Newton's method, determinants."""
    branch = ns.branch(ns.scene("beam-clearance")(modes=60), "frequency", 73.2, 73.3)
    (flip,) = (event for event in branch.events if event.kind == "flip")
    assert flip.parameter == pytest.approx(73.25586171520776, rel=2e-14)
