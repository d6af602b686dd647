"""What is claimed of the three expansions in space, each as a test that could fail."""

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from known import FELT, NAMES, SPRINGS, attached

import nonsmooth as ns
from nonsmooth.solver.space.attached import Attached
from nonsmooth.solver.space.convergence import Line, convergence
from nonsmooth.solver.space.eigenvalues import secular
from nonsmooth.solver.space.eigenvalues.exact import exact_modes
from nonsmooth.solver.space.expansions.bare import BareModes
from nonsmooth.solver.space.expansions.forced import ritz_forced
from nonsmooth.solver.space.expansions.pieces import piecewise
from nonsmooth.solver.space.modes import at_order

ONE, TWO, THREE = (1,), (1, 2), (1, 2, 3)


def off(one: Attached, bare: BareModes, count: int = 1) -> "np.ndarray":
    """Return the relative errors of the lowest eigenvalues."""
    roots = secular.eigenvalues(bare, one, count)
    return roots.values / exact_modes(one, count).eigenvalues - 1


@pytest.mark.parametrize("name", NAMES)
def test_rates_by_class_and_forced_modes(name: str) -> None:
    """Fitted where rounding is far: sines at low modes, forced modes at the fifteenth."""
    lines = [Line("ritz"), Line("ritz-ck", 1)]
    one = attached(name, "0.3183098861837907")
    study = convergence(one, lines[name == "beam-crack" :], (12, 16, 24, 32, 48), 1)
    for line in study.lines:
        rate = study.rate(line)
        if rate is not None:  # else all is rounding by order 12
            # the errors fall in steps: |r_n|^2 of the first mode left out comes and goes
            assert rate == pytest.approx(study.expected(line), abs=0.8)
    assert study.rate(study.lines[0]) is not None


def test_the_first_forced_mode_is_the_one_that_matters() -> None:
    """Footnote 2: by itself the second is worth next to nothing..."""
    one = attached("beam-rotational-spring")
    none, first, second = (
        off(one, ritz_forced(one, 8, chosen))[0] for chosen in ((), ONE, (2,))
    )
    assert none == pytest.approx(2.7e-2, rel=0.02)
    assert second == pytest.approx(1.6e-2, rel=0.02)
    assert first < 2e-10
    rates = [off(one, ritz_forced(one, N, (2,)))[0] for N in (16, 64)]
    assert np.log(rates[1] / rates[0]) / np.log(4) == pytest.approx(-1, abs=0.1)


def test_after_the_first_each_further_one_helps_as_much_again() -> None:
    """... and what the footnote did not see, since the first has removed what a plot shows."""
    one = attached("beam-rotational-spring")
    at_one_sine = [off(one, ritz_forced(one, 1, chosen))[0] for chosen in ((), ONE, TWO, THREE)]
    assert at_one_sine == pytest.approx([1.7e-1, 7.4e-5, 4.6e-8, 5.6e-13], rel=0.03)


def test_too_smooth_is_fatal_and_too_rough_costs_only_unknowns() -> None:
    one = attached("beam-rotational-spring")
    smooth = {k: off(one, piecewise(one, 10, continuity=k))[0] for k in (1, 2, 3)}
    assert abs(smooth[1]) < 1e-13
    assert smooth[2] == pytest.approx(3.0e-3, rel=0.2)
    assert smooth[3] == pytest.approx(3.8e-3, rel=0.3)
    stiff = attached("beam-spring", "3/10", 1000.0)
    rough, right, wrong = (piecewise(stiff, 9, continuity=k) for k in (1, 2, 3))
    assert rough.unknowns != right.unknowns
    assert max(abs(off(stiff, rough)[0]), abs(off(stiff, right)[0])) < 1e-9
    assert off(stiff, wrong)[0] > 1e-6


def test_sines_never_see_a_crack() -> None:
    one = attached("beam-crack")
    bare = np.pi**4 * np.arange(1, 4) ** 4
    for order in (4, 64):
        found = secular.eigenvalues(ritz_forced(one, order, ()), one, 3).values
        np.testing.assert_allclose(found, bare, rtol=1e-14)
    assert off(one, ritz_forced(one, 8, ONE))[0] == pytest.approx(1.7e-9, rel=0.05)
    assert abs(off(one, ritz_forced(one, 8, TWO))[0]) < 1e-15
    assert off(one, piecewise(one, 4))[0] == pytest.approx(2.3e-11, rel=0.05)


def test_the_jump_law_tells_the_error_without_the_exact_modes() -> None:
    """It is never much smaller than the root of the error; of many modes it is much larger."""
    for name in NAMES:
        for method, order in (("ritz-ck", 8), ("ck", 6)):
            for mode in at_order(attached(name, "2/7"), method, order, int(method != "ck"), 3):
                if abs(mode.error) > 1e-11:
                    ratio = abs(mode.jump_mismatch) / np.sqrt(abs(2 * mode.error))
                    assert ratio > 0.5, (name, method, mode.number)
                    assert ratio < 50 or name != "beam-rotational-spring"
        assert abs(at_order(attached(name), "ritz-ck", 16, 2, 1)[0].jump_mismatch) < 1e-5
    sines = at_order(attached("beam-mass"), "ritz", 8, 0, 2)
    assert [mode.jump_mismatch for mode in sines] == [-1.0, -1.0]


def test_shapes_and_moments_of_the_table() -> None:
    one = attached("beam-rotational-spring")
    lines = [Line("ritz"), Line("ritz-ck", 1), Line("ck")]
    study = convergence(one, lines, (10, 16))
    rows = {(row.method, row.order): row for row in study.rows}
    sines, forced, series = rows["ritz", 16], rows["ritz-ck", 16], rows["ck", 10]
    assert (sines.shape, sines.discontinuous) == pytest.approx((1.9e-3, 1.3e-1), rel=0.05)
    assert (forced.shape, forced.discontinuous) == pytest.approx((2.1e-9, 7.0e-7), rel=0.05)
    assert forced.jump_mismatch == pytest.approx(4.2e-6, rel=0.05)
    assert (series.shape, series.discontinuous) == pytest.approx((3.8e-13, 6.2e-11), rel=0.1)
    assert series.jump_mismatch == pytest.approx(-2.0e-10, rel=0.1)


places = st.fractions(min_value=Fraction(1, 50), max_value=Fraction(49, 50), max_denominator=97)
strengths = st.floats(min_value=-6, max_value=6).map(lambda power: 10.0**power)


@settings(max_examples=40)
@given(name=st.sampled_from(NAMES), place=places, strength=strengths)
def test_properties_of_any_structure(name: str, place: Fraction, strength: float) -> None:
    one = attached(name, str(place), strength)
    kind, count = one.structure.kind, 5
    exact = exact_modes(one, count)
    # every root in its own bracket
    bare = one.bare(np.arange(1, count + 2))
    if kind == "stiffness":
        assert (exact.eigenvalues >= bare[:count] * (1 - 1e-14)).all()
        assert (exact.eigenvalues <= bare[1:] * (1 + 1e-14)).all()
    else:
        assert (exact.eigenvalues <= bare[:count] * (1 + 1e-14)).all()
        assert (exact.eigenvalues[1:] >= bare[: count - 1] * (1 - 1e-14)).all()
    # seen from the other end it is the same
    other = exact_modes(attached(name, str(1 - place), strength), count)
    np.testing.assert_allclose(other.eigenvalues, exact.eigenvalues, rtol=2e-13)
    # Ritz values lie above, and fall with the order and with each forced mode
    last = np.full(count, np.inf)
    for N, K in ((6, 0), (6, 1), (9, 1), (9, 2)):
        if kind == "compliance" and K == 0:
            continue
        roots = secular.eigenvalues(ritz_forced(one, N, tuple(range(1, K + 1))), one, count)
        assert (roots.values + roots.rounding >= exact.eigenvalues).all()
        assert (roots.values - roots.rounding <= last).all()
        last = roots.values + roots.rounding
    # a stronger spring raises, a larger mass or a softer hinge lowers
    stronger = exact_modes(attached(name, str(place), 2 * strength), count).eigenvalues
    raised = (stronger - exact.eigenvalues) * (1 if kind == "stiffness" else -1)
    assert (raised >= -1e-14 * stronger).all()


@pytest.mark.parametrize("name", NAMES)
def test_first_order_shifts_of_a_weak_attachment(name: str) -> None:
    one = attached(name, "3/10", 1e-7)
    exact, n = exact_modes(one, 3), np.arange(1, 4)
    squares = one.felt(n) ** 2
    slope = {"stiffness": squares, "inertia": -one.bare(n) * squares, "compliance": -squares}
    wanted = one.s * slope[one.structure.kind]
    np.testing.assert_allclose(exact.shifts, wanted, rtol=2e-4)


def test_an_attachment_without_end_makes_two_structures_of_one() -> None:
    pinned = exact_modes(attached("string-spring", "3/10", 1e9), 3).beta
    np.testing.assert_allclose(pinned, [np.pi / 0.7, 2 * np.pi / 0.7, np.pi / 0.3], rtol=1e-8)
    heavy = exact_modes(attached("string-mass", "3/10", 1e9), 1).eigenvalues[0]
    assert heavy * 1e9 == pytest.approx(1 / (0.3 * 0.7), rel=1e-8)
    hinged = exact_modes(attached("beam-crack", "3/10", 1e9), 1).eigenvalues[0]
    assert hinged * 1e9 == pytest.approx(3 / (0.3 * 0.7) ** 2, rel=1e-8)


def test_no_root_is_missed_near_a_node() -> None:
    """So near to a node that next to nothing is felt, the mode is found all the same."""
    for name in FELT:
        near, exactly = (attached(name, q, 1e6) for q in ("0.3333333333333333", "1/3"))
        np.testing.assert_allclose(
            exact_modes(near, 8).eigenvalues, exact_modes(exactly, 8).eigenvalues, rtol=1e-9
        )
        assert not exact_modes(near, 8).untouched.any()
        found = at_order(near, "ritz-ck", 16, 1, 8)
        assert [mode.number for mode in found] == list(range(1, 9))
        assert max(abs(mode.error) for mode in found) < 1e-2


@pytest.mark.parametrize(
    ("name", "position", "strength", "n"),
    [
        ("beam-rotational-spring", "1/2", -11.525276159820116, 1),
        ("beam-spring", "1/4", 7952.45764097404, 4),
    ],
)
@pytest.mark.parametrize(("method", "order", "forced"), [("ritz", 16, 0), ("ritz-ck", 8, 1)])
def test_two_modes_of_one_frequency(
    name: str, position: str, strength: float, n: int, method: str, order: int, forced: int
) -> None:
    """A root that meets one that feels nothing, in the middle of its bracket."""
    one = attached(name, position, strength)
    found = at_order(one, method, order, forced, n + 2)
    both = [mode for mode in found if mode.exact_beta == pytest.approx(n * np.pi, rel=1e-14)]
    assert len(both) == 2
    x = np.array([0.1, 0.7])
    for mode in both:
        assert abs(mode.error) < 0.6  # sines alone are poor near the critical stiffness
        apart = np.abs(mode.shape(x) - np.sqrt(2) * np.sin(n * np.pi * x)).max()
        assert (apart < 1e-9) == (mode.node == n)


@pytest.mark.parametrize("name", SPRINGS)
@pytest.mark.parametrize("position", ["1/3", "3/10", "1/101"])
def test_one_sine_alone(name: str, position: str) -> None:
    """Its root is the very end of its bracket."""
    one, first = attached(name, position, 1.0), np.array([1])
    expected = one.bare(first) + one.felt(first) ** 2
    assert at_order(one, "ritz", 1, 0, 1)[0].eigenvalue == pytest.approx(expected[0], rel=1e-14)


def test_the_mismatch_of_a_jump_is_that_of_its_shape() -> None:
    for mode in ns.modes("string-mass", count=4):  # [u'] = -s lambda u
        before, after = mode.shape([0.3 - 1e-9, 0.3 + 1e-9], 1)
        law = -10 * mode.eigenvalue * mode.shape(0.3)
        assert mode.jump_mismatch == pytest.approx((after - before) / law - 1, abs=1e-6)
        assert mode.jump_mismatch > 1e-5
