"""The 210 references: exact eigenvalues, Ritz values, bounds, nodes."""

from functools import cache

import mpmath as mp
import numpy as np
import pytest
from known import attached, drawn, exact_values, expansion, lower, of, references

from nonsmooth.solver.space.attached import Attached
from nonsmooth.solver.space.eigenvalues import bounds, secular
from nonsmooth.solver.space.eigenvalues.exact import ExactModes, exact_modes
from nonsmooth.solver.space.expansions.forced import ritz_forced
from nonsmooth.solver.space.expansions.pieces import piecewise
from nonsmooth.solver.space.modes import at_order

COUNT = 10

#: Seeds that are rare.
LONG = [pytest.param(seed, marks=pytest.mark.long) for seed in range(100, 400)]

#: Four units in the last of the 14 digits that the references of Ritz values have.
PRINTED = 6e-14


def test_there_are_210_of_them() -> None:
    assert len(references()) == 210
    assert len({of(each).structure.name for each in references()}) == 7


#: Some of them for each expansion: of all structures, places and strengths.
SOME = references()[::4]


@cache
def exact() -> list[ExactModes]:
    """Return the exact modes of each."""
    return [exact_modes(of(each), COUNT) for each in references()]


def test_exact_eigenvalues_have_all_their_digits() -> None:
    off = [
        np.abs(modes.eigenvalues / exact_values(each) - 1).max()
        for modes, each in zip(exact(), references(), strict=True)
    ]
    # at a = 1/100 the closed form of the receptance cancels by a factor of 1/a
    assert max(off) < 5e-15


def test_modes_with_a_node_at_the_attachment_are_recognised() -> None:
    for found, each in zip(exact(), references(), strict=True):
        nodes = [int(n) if u else None for n, u in zip(found.n, found.untouched, strict=True)]
        assert nodes == each["node"]


@pytest.mark.parametrize(
    ("key", "order", "forced"),
    [
        ("ritz, 0 forced, N = 8", 8, ()),
        ("ritz, 1 forced, N = 8", 8, (1,)),
        ("ritz, 2 forced, N = 4", 4, (1, 2)),
    ],
)
def test_ritz_values_are_those_of_the_matrices(
    key: str, order: int, forced: tuple[int, ...]
) -> None:
    compared = 0
    for each in SOME:
        wanted = each.get("galerkin", {}).get(key, [])
        one = of(each)
        roots = secular.eigenvalues(ritz_forced(one, order, forced), one, COUNT)
        coupled = roots.values[roots.untouched < 0]
        for found, value in zip(coupled, wanted, strict=False):
            if value is not None:
                compared += 1
                assert found == pytest.approx(float(value), rel=PRINTED, abs=0), each
    assert compared > 35


def test_values_of_the_piecewise_series_are_those_of_the_matrices() -> None:
    compared = 0
    for each in SOME:
        wanted = each.get("galerkin", {}).get("ck, N = 4", [])
        one = of(each)
        found = secular.eigenvalues(piecewise(one, 4), one, 3).values
        for value, other in zip(found, wanted, strict=False):
            compared += 1
            # of a crack a digit more is lost: the inner products with the function that jumps
            off = 2 * PRINTED if one.structure.kind == "compliance" else PRINTED
            assert value == pytest.approx(float(other), rel=off, abs=0), each
    assert compared > 45


def test_bounds_of_the_piecewise_series_hold_from_above() -> None:
    for each in SOME:
        one = of(each)
        roots = secular.eigenvalues(piecewise(one, 12), one, 4)
        assert (bounds.above(roots) >= exact_values(each)[:4]).all(), each


def test_two_forced_modes_and_32_sines_give_13_digits() -> None:
    """Of the modes whose truncation error is below that; N^-17 to N^-19, of strings N^-9."""
    reached = {"string-mass": 2, "string-spring": 1, "beam-crack": 5}
    for each in SOME:
        one = of(each)
        roots = secular.eigenvalues(ritz_forced(one, 32, (1, 2)), one, COUNT)
        off = roots.values / exact_values(each) - 1
        modes = reached.get(each["structure"], 7)
        assert np.abs(off[:modes]).max() < 1e-13, each
        assert off.min() > -1e-14  # Ritz values lie above


@pytest.mark.parametrize(
    ("order", "forced"),
    [(8, 1), (16, 3), *(pytest.param(*q, marks=pytest.mark.long) for q in ((8, 0), (64, 2)))],
)
def test_bounds_hold_on_both_sides(order: int, forced: int) -> None:
    proved = 0
    for each in SOME:
        one = of(each)
        bare = ritz_forced(one, order, tuple(range(1, forced + 1)))
        roots = secular.eigenvalues(bare, one, 6)
        exact = exact_values(each)[: len(roots.values)]
        if one.structure.kind == "compliance" and forced == 0:
            assert np.isnan(bounds.below(one, order, forced, len(exact))).all()
            continue
        low = bounds.below(one, order, forced, len(exact))
        assert (bounds.above(roots) >= exact).all(), each
        known = ~np.isnan(low)
        assert (low[known] <= exact[known]).all(), each
        proved += int(known.sum())
    assert proved > 150


def assert_enclosed(one: Attached, method: str, order: int, forced: int) -> None:
    """Hold bounds and exact eigenvalues against the number of those below, in 50 digits."""
    for mode in at_order(one, method, order, forced, None):
        low, high = mode.bounds
        about = one.structure.name, str(one.a), one.s, method, order, forced, mode.number
        assert lower(one, high) >= mode.number, about
        assert low is None or lower(one, low) < mode.number, about
        exact = mp.mpf(mode.exact_beta) ** (2 * one.structure.m)
        off = 3e-13 if one.s < 0 else 2e-15  # a negative stiffness takes digits
        assert lower(one, exact * (1 - off)) < mode.number <= lower(one, exact * (1 + off)), (
            about
        )


@pytest.mark.parametrize("seed", [*range(40), *LONG])
def test_bounds_enclose_the_exact_eigenvalues_of_any_structure(seed: int) -> None:
    assert_enclosed(drawn(seed), *expansion(seed))


@pytest.mark.parametrize("seed", [*range(24), *LONG])
def test_bounds_enclose_those_of_a_negative_stiffness(seed: int) -> None:
    assert_enclosed(drawn(seed, negative=True), *expansion(seed))


@pytest.mark.parametrize("position", ["0.99972", "0.00028"])
def test_bounds_of_a_heavy_mass_beside_either_end(position: str) -> None:
    assert_enclosed(attached("beam-mass", position, 1e6), "ritz-ck", 64, 2)


@pytest.mark.parametrize("position", ["0.00026", "0.0018", "0.0105", "0.9995"])
@pytest.mark.parametrize("order", [12, 60, 100])
def test_the_series_keeps_its_digits_with_a_crack_beside_an_end(
    position: str, order: int
) -> None:
    one = attached("beam-crack", position, 1e5)
    assert_enclosed(one, "ck", order, 0)
    assert max(abs(mode.error) for mode in at_order(one, "ck", order, 0, 3)) < 1e-12


def test_the_allowance_for_rounding_is_no_more_than_that() -> None:
    for each in SOME[::2]:
        one = of(each)
        roots = secular.eigenvalues(ritz_forced(one, 16, (1, 2)), one, 6)
        assert (roots.rounding < 2e-13 * roots.values).all(), each


def test_bounds_of_the_table_of_the_rotational_spring() -> None:
    one = attached("beam-rotational-spring")
    exact = exact_modes(one, 3).eigenvalues
    roots = secular.eigenvalues(ritz_forced(one, 8, (1,)), one, 3)
    assert roots.values / exact - 1 == pytest.approx([1.2e-10, 1.6e-9, 2.5e-7], rel=0.05)
    low = bounds.below(one, 8, 1, 3) / exact - 1
    assert low[1:] == pytest.approx([-1.1e-12, -9.5e-10], rel=0.05)
    assert -2e-14 < low[0] < -5e-15  # -7.0e-15 and rounding
