"""Every shortcut finds the orbits of the whole system in whose place it is solved."""

from collections.abc import Iterator

import numpy as np
import pytest

import nonsmooth as ns
from nonsmooth.solver.case import registry
from nonsmooth.solver.case.case import Case
from nonsmooth.solver.shortcut import Shortcut, entrance_of, entrances, table
from nonsmooth.solver.shortcuts.orbit.methods import METHODS
from nonsmooth.solver.shortcuts.orbit.oscillator import DEFAULT

#: Of ``alpha`` and so of the normal force: stick is short, as long as slip, and long.
ALPHAS = (0.1, 1.0, 20.0)

#: Orders, of which a shortcut has those that it fits; the highest is for what is matrix-free.
ORDERS = (11, 14, 300)

#: Order above which the whole system takes seconds: it is solved for one case.
DENSE = 100

#: Part of itself by which the last time is wrong where the bound must say so.
MOVED = 1e-7

#: At these orders the times are so near to the exact ones, as a part of the period.
NEAR_EXACT = 0.15

#: Least digits of the times: those of the whole system and of the shortcut, either rounded.
SAME_TIMES = 2e-13


def cases(shortcut: Shortcut) -> list[Case]:
    scene = registry.load(shortcut.scene)
    return [scene(normal_force=400 * alpha) for alpha in ALPHAS]


def instances() -> Iterator[tuple[Shortcut, int, int | None]]:
    """Yield shortcuts with an order that each fits, and with numbers of functions."""
    for shortcut in table():
        orders = [N for N in ORDERS if shortcut.fits(cases(shortcut)[1], N)]
        orders = orders[:1] if len(orders) == 1 else [N for N in orders if N < 100]
        several = shortcut.functions or (None,)
        yield from ((shortcut, N, K) for N in orders for K in {several[0], several[-1]})


@pytest.mark.parametrize(
    ("shortcut", "order", "functions"), list(instances()),
    ids=lambda q: q.name.replace(" ", "-") if isinstance(q, Shortcut) else str(q),
)  # fmt: skip
def test_a_shortcut_solves_the_whole_system(shortcut, order, functions) -> None:
    several = cases(shortcut)
    assert all(shortcut.fits(case, order) for case in several)
    compared = 0
    for case, found in zip(several, shortcut.solve(several, order, functions), strict=True):
        residual = shortcut.full.residual(case, order, functions, found)
        assert np.abs(residual).max() < shortcut.bound
        exact = ns.exact(case)
        parts = np.array(exact.durations) / exact.period
        assert shortcut.times(found) == pytest.approx(parts, rel=0, abs=NEAR_EXACT)
        moved = found.copy()
        moved[-1] *= 1 + MOVED
        wrong = shortcut.full.residual(case, order, functions, moved)
        assert np.abs(wrong).max() > 2 * shortcut.bound  # the bound says something
        if shortcut.full.times is None or (order > DENSE and case != several[1]):
            continue
        times = shortcut.full.times(case, order, functions)
        if times is not None:
            compared += 1
            assert shortcut.times(found) == pytest.approx(times, rel=0, abs=SAME_TIMES)
    assert compared or shortcut.full.times is None


def test_every_method_of_the_paper_has_a_shortcut_and_says_why() -> None:
    (entrance,) = entrances()
    assert {shortcut.method for shortcut in table()} == set(entrance.methods)
    assert set(entrance.methods.values()) == set(METHODS)
    assert {shortcut.scene for shortcut in table()} == {entrance.scene}
    assert all(len(shortcut.why) > 40 for shortcut in table())
    names = [shortcut.name for shortcut in table()]
    assert len(set(names)) == len(names)


def test_what_a_shortcut_is_quicker_than_has_a_factor() -> None:
    for shortcut in table():
        if shortcut.factor is not None:
            assert shortcut.factor > 1
            assert shortcut.full.times is not None
        assert shortcut.fits(cases(shortcut)[1], shortcut.order)


@pytest.mark.parametrize("alpha", [1e-9, 1e9])
def test_none_fits_where_float64_does_not_hold_stick_and_slip(alpha: float) -> None:
    for shortcut in table():
        case = registry.load(shortcut.scene)(normal_force=400 * alpha)
        assert not shortcut.fits(case, 300 if "matrix" in shortcut.name else 10)


def test_the_belt_is_solved_by_shortcuts_unless_they_are_not_wanted() -> None:
    entrance = entrance_of(DEFAULT)
    assert dict(entrance.case(DEFAULT).values) == {
        "mass": 10.0, "stiffness": 1000.0, "belt_speed": 1.0,
        "mu_s": 0.5, "mu_k": 0.25, "normal_force": 400.0,
    }  # fmt: skip
    quick, whole = ns.solve(DEFAULT, "hb", 6), ns.solve(DEFAULT, "hb", 6, shortcuts=False)
    assert isinstance(quick, ns.Orbit)
    assert isinstance(whole, ns.SceneOrbit)
    assert quick.period == pytest.approx(whole.period, rel=1e-14)
    assert isinstance(ns.sweep(DEFAULT, ["hb", "ck"], [4], shortcuts=False), ns.SceneSweep)
    with pytest.raises(TypeError, match="case: got 3, expected a case of a scene or a Stick"):
        ns.solve(3, "hb", 4)  # type: ignore[call-overload]
