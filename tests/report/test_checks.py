"""Each statement about a series, on cases where it holds and on cases where it does not."""

import re
from math import inf
from types import SimpleNamespace

import numpy as np
import pytest
from fakes import Fake

from nonsmooth.report.case import MOST
from nonsmooth.report.checks.fourier import GIBBS
from nonsmooth.report.claims import CLAIMS

#: Statements by the name of the claim and their place in it.
STATEMENTS = {f"{c.name} {place}": part for c in CLAIMS for place, part in enumerate(c.parts)}

NO_HB = [("hb", N) for N in range(1, MOST + 1)]
NO_C1 = [("c1", N) for N in range(3, MOST + 1)]


def at(*values: float):
    """Return what is measured at N = 10, 20 and 40, and at no other order."""
    return dict(zip((10, 20, 40), values, strict=True)).__getitem__


def power(exponent: float, factor: float = 1.0):
    return lambda N: factor * N**-exponent


def bump(order: int, size: float = 1.0):
    """Return an error that falls at every order but one."""
    return lambda N: size / N if order != N else 2 * size / N


def hb(of: str, values, missing=()) -> Fake:
    return Fake({(of, "hb"): values}, missing=missing)


def hb_c1(of: str, values) -> Fake:
    return Fake({(of, "hb-c1"): values})


def both(of: str, without, with_c1, missing=()) -> Fake:
    return Fake({(of, "hb"): without, (of, "hb-c1"): with_c1}, missing=missing)


def removed(without: float, *over: float) -> Fake:
    return both("overshoot", {40: without}.__getitem__, at(*over))


def at_3(over: float) -> Fake:
    return both("overshoot", {3: 0.2}.__getitem__, {3: over}.__getitem__)


#: Where stick ends in the exact orbit at alpha = 2, as a part of the period.
END = 4 / (4 + np.pi + 2 * np.arctan(0.5))


def level(own: float, exact: float) -> Fake:
    """Return an acceleration of so much of its jump, 20 m/s**2, at the two ends of stick."""
    heights = {0.25: own, END * 0.5: exact}

    def acceleration(t: float) -> float:
        (found,) = (height for time, height in heights.items() if abs(t - time) < 1e-9)
        return -20.0 * found

    def orbit(method: str, order: int) -> SimpleNamespace:
        assert (method, order) == ("hb", 40)
        return SimpleNamespace(t1=0.25, period=0.5, acceleration=acceleration)

    return Fake(alpha=2.0, orbit=orbit)


def c1(error, of: str = "period", missing=()) -> Fake:
    return Fake({(of, "c1"): error}, missing=missing)


def falling(N: int) -> float:
    return 10.0**-N


def alternating(N: int) -> float:
    return (-0.1) ** N


def except_at(order: int, value: float, error=falling) -> Fake:
    return c1(lambda N: value if order == N else error(N))


def in_band(order: int, error: float) -> Fake:
    return except_at(order, error, lambda N: 1e-3 if N > 3 else 1e-2)


def from_order(first: float, of: str = "period") -> Fake:
    """Return a case where the C1 series is better than hb-c1 from an order on."""
    ours = {(of, "hb-c1"): lambda N: -1e-2, (of, "c1"): lambda N: 2e-2 if first > N else -5e-3}
    return Fake(ours)


def at_rounding() -> Fake:
    """Return a case where one error is as good as the other, or there is no other."""
    errors = {
        ("period", "c1"): lambda N: 1e-13 if N < 40 else 1.0,
        ("period", "hb-c1"): lambda N: 1e-14,
    }
    return Fake(errors, missing=[("hb-c1", 40)])


def only_at(bad: int, ours: float = 2e-2) -> Fake:
    """Return a case where the C1 series has this error at one order, and is else better."""
    errors = {"hb-c1": lambda N: -1e-2, "c1": lambda N: ours if bad == N else 1e-3}
    return Fake({("period", method): error for method, error in errors.items()})


def without_orbit_at_4(alpha: float) -> Fake:
    """Return a case whose only solution at N = 4 is one whose stick ends too early."""
    error = {("period", "c1"): lambda N: 1e-4 * 10.0**-N}
    return Fake(error, alpha=alpha, missing=[("c1", 4)])


def three(*errors: float) -> Fake:
    """Return errors (22) at N = 3."""
    by_method = zip(("hb", "hb-c1", "c1"), errors, strict=True)
    return Fake({("acceleration", m): {3: error}.__getitem__ for m, error in by_method})


def sticking(value: float, lowest: int = 1) -> Fake:
    """Return an acceleration in stick at the lowest order that has an orbit."""

    def orbit(method: str, order: int) -> SimpleNamespace:
        values = np.zeros(99)
        values[50] = value if order == lowest else 1.0
        return SimpleNamespace(t1=0.2, acceleration=lambda t: values[: len(t)])

    return Fake(orbit=orbit, missing=[("c1", N) for N in range(1, lowest)])


def unseen(*errors: float) -> Fake:
    return c1(dict(zip((5, 10), errors, strict=True)).__getitem__, "largest acceleration")


def derivatives(slow: str, factor: float) -> Fake:
    """Return largest errors, one of which falls by a factor in three orders."""
    names = ("displacement", "velocity", "acceleration", "jerk")
    falls = {name: factor if name == slow else 0.01 for name in names}
    return Fake(
        {(f"largest {n}", "c1"): lambda N, f=f: f ** ((N - 8) / 3) for n, f in falls.items()}
    )


def steps(odd: float, even: float) -> Fake:
    """Return (22) that falls by one factor at odd orders, and by another at even ones."""
    return c1(lambda N: float(odd ** -((N - 1) // 2) * even ** -(N // 2)), "acceleration")


#: Statements that hold from one number to another, and the case with a number.
EDGES = [
    ("mean-square 0", 0.4, inf, lambda x: hb("acceleration", at(1, 0.5, 0.5 * 2**-x))),
    ("mean-square 0", 0.4, inf, lambda x: hb("acceleration", at(1, 2**-x, 0.1))),
    ("not-pointwise 0", 0.4, inf, lambda x: hb("largest acceleration", at(0.6, 0.6, x))),
    ("not-pointwise 0", 0.4, inf, lambda x: hb("largest acceleration", at(0.6, x, 0.6))),
    ("not-pointwise 1", 0.1, inf, lambda x: hb("inside", at(0.2, 0.3, x))),
    ("gibbs 0", GIBBS * 2 / 3, GIBBS * 4 / 3, lambda x: hb("overshoot", {40: x}.__getitem__)),
    ("gibbs 1", 0.04, inf, lambda x: hb("overshoot", at(0.09, 0.08, x))),
    ("gibbs 1", 0.01, inf, lambda x: hb("overshoot", at(0.001, 0.001, x))),
    ("mean-of-the-jump 0", 0.4, 0.6, lambda x: level(x, 5)),
    ("mean-of-the-jump 1", 0.4, 0.6, lambda x: level(5, x)),
    ("slow-period 0", 0.8, 1.2, lambda x: hb("period", power(x))),
    ("slow-period 1", 1e-3, inf, lambda x: hb("period", lambda N: -x if N == 40 else 0.1)),
    ("monotone-hb 0", 0.3, 0.7, lambda x: hb("acceleration", power(x))),
    ("monotone-hb 1", 0, 2e-5, lambda x: hb("acceleration", bump(40, x))),  # 1e-6 at N = 40
    ("one-function-period 0", 0, 1 / 17, lambda x: both(
        "period", power(1), lambda N: x if N == 17 else 1e-3)),
    ("one-function-period 1", 2, inf, lambda x: both("period", power(1), power(x))),
    ("one-function-gibbs 0", 0, 0.01, lambda x: removed(0.09, 0.05, 0.02, x)),
    ("one-function-gibbs 0", 0.01, inf, lambda x: removed(x, 0.05, 0.02, 0.009)),
    ("one-function-gibbs 1", 0, 0.01, at_3),
    ("one-function-pointwise 0", 0, 0.7, lambda x: hb_c1(
        "largest acceleration", at(1, x, 0.1))),
    ("one-function-pointwise 0", 0, 0.7, lambda x: hb_c1(
        "largest acceleration", at(1, 0.5, 0.5 * x))),
    ("one-function-acceleration 0", 1, inf, lambda x: both(
        "acceleration", power(0.5), power(x))),
    ("one-function-rises 0", 3.5e-6, inf, lambda x: hb_c1("acceleration", bump(7, x))),
    ("overtakes 0", 0, 20, from_order),
    ("overtakes 2", 1e-2, inf, lambda x: only_at(3, x)),
    ("band 0", -1e-3, 1e-3, lambda x: in_band(17, x)),
    ("band 0", -1e-3, 1e-3, lambda x: in_band(4, x)),
    ("band 1", -1e-3, 1e-3, lambda x: in_band(3, x)),
    ("band 2", -1e-3, 1e-3, lambda x: in_band(17, x)),
    ("band 2", 342.5 / 400, inf, without_orbit_at_4),
    ("monotone-c1 0", 1e-10, 1e-8, lambda x: except_at(9, x)),
    ("monotone-c1 0", 1e-10, 1e-8, lambda x: except_at(9, -x)),
    ("poorest 0", 0, 0.2, lambda x: three(0.2, x, 0.1)),
    ("poorest 0", 0, 0.2, lambda x: three(0.2, 0.1, x)),
    ("c1-gibbs 0", 0, 0.01, lambda x: unseen(0.5, x)),
    *(("c1-pointwise 0", 0, 1 / 10, lambda x, name=name: derivatives(name, x))
      for name in ("displacement", "velocity", "acceleration", "jerk")),
    ("swiftest 0", 0, 20, lambda x: from_order(x, "acceleration")),
    ("stairs 0", 2, inf, lambda x: steps(x, 1.5)),
    ("stairs 0", 0, 2, lambda x: steps(10, x)),
    ("stairs 1", 1 / 1.01, 1 / 0.99, lambda x: steps(10, x)),
]  # fmt: skip

#: Cases on which a statement holds, and others on which it does not.
CASES = {
    "slow-period 0": ([], [hb("period", power(1), NO_HB)]),
    "slow-period 1": ([], [hb("period", power(1), NO_HB)]),
    "gibbs 0": ([], [hb("overshoot", {40: -GIBBS}.__getitem__)]),
    "monotone-hb 0": ([], [hb("acceleration", power(0.5), NO_HB)]),
    "monotone-hb 1": (
        [hb("acceleration", power(1))],
        [hb("acceleration", bump(7)), hb("acceleration", power(1), NO_HB)],
    ),
    "one-function-period 0": (
        [both("period", power(1), power(1, -0.9))],
        [both("period", power(1), power(3, 0.5), [("hb-c1", 3)])],
    ),
    "one-function-gibbs 1": ([at_3(-0.1)], []),
    "one-function-rises 0": ([hb_c1("acceleration", bump(40))], []),
    "stick-exact 0": (
        [sticking(0.0), sticking(0.0, 3)],
        [sticking(1e-300), sticking(-1e-300), sticking(1e-300, 3)],
    ),
    "overtakes 0": ([from_order(1), at_rounding()], [from_order(41)]),
    "overtakes 1": ([only_at(3), only_at(1)], [only_at(4), only_at(40)]),
    "overtakes 2": ([], [only_at(4)]),
    "band 0": ([in_band(3, 0.5)], []),
    "monotone-c1 0": ([c1(falling), c1(alternating), except_at(3, 1e-6)], [except_at(4, 1e-6)]),
    "monotone-c1 1": (
        [c1(falling), except_at(3, -1.0)],
        [c1(alternating), except_at(9, -1e-9)],
    ),
    "c1-gibbs 0": ([], [unseen(0.001, 0.011)]),
    "stairs 0": ([steps(10, 0.9)], [steps(1, 10), c1(falling, "acceleration", NO_C1)]),
    "stairs 1": ([], [c1(falling, "acceleration", NO_C1)]),
}


@pytest.mark.parametrize(("name", "low", "high", "case"), EDGES)
def test_a_statement_holds_on_one_side_of_its_thresholds(name, low, high, case) -> None:
    check = STATEMENTS[name].check
    for edge, inwards in ((low, 1), (high, -1)):
        if edge not in (0, inf):
            away = 1e-2 * inwards * abs(edge)
            assert check(case(edge + away)).holds, (edge, check(case(edge + away)).numbers)
            assert not check(case(edge - away)).holds, (edge, check(case(edge - away)).numbers)


@pytest.mark.parametrize("name", CASES)
def test_a_statement_holds_where_it_should_and_not_where_it_should_not(name: str) -> None:
    for wanted, cases in zip((True, False), CASES[name], strict=True):
        for case in cases:
            found = STATEMENTS[name].check(case)
            assert found.holds is wanted, found.numbers


def test_no_statement_is_left_out() -> None:
    own = {"smoothness", "friction", "centre", "g1", "dependence"}  # test_checks_of_motion.py
    tested = {name for name, *_ in EDGES} | set(CASES)
    assert {name for name in STATEMENTS if name.split()[0] not in own} == tested


def test_a_threshold_that_is_ours_is_said_to_be_what_it_is() -> None:
    told = 0
    for name, low, high, _ in EDGES:
        ours = STATEMENTS[name].ours
        found = re.match(r"(?:an exponent of at least |an exponent from |a factor of |N = )?"
                         r"([\d.]+)(?: to ([\d.]+))?( %)?", ours)  # fmt: skip
        if found:
            scale = 100 if found[3] else 1
            said = [float(text) / scale for text in found.groups()[:2] if text]
            known = [low, high, 1 / high if high else inf, high - 1]  # a factor of 10, by 1 %
            assert all(any(abs(x - edge) < 2e-4 for edge in known) for x in said), name
            told += 1
    assert told == 23


HARDLY = {14: 0.033930, 15: 0.033930 * (1 + 2e-6)}

#: What is said of some cases, from its beginning.
SAID = [
    ("gibbs 0", hb("overshoot", {40: 0.12}.__getitem__), "12.0 % of the jump; Gibbs' limit is"),
    ("mean-square 0", hb("acceleration", at(1, 0.7, 0.5)), "100 %, 70 % and 50 % at N = 10,"),
    ("not-pointwise 1", hb("inside", at(1, 1, 1)), "100 %, 100 % and 100 % of the jump at N"),
    ("slow-period 0", hb("period", power(1, -0.1)), "like N⁻¹·⁰⁰; 0.250 % off at N = 40"),
    ("slow-period 1", hb("period", power(2, 0.1)), "inside from N = 10"),
    ("monotone-hb 0", hb("acceleration", power(0.5)), "like N⁻⁰·⁵⁰"),
    ("monotone-hb 1", hb("acceleration", bump(4)), "it rises at N = 4, from 0.33333 to 0.5000"),
    ("monotone-hb 1", hb("acceleration", lambda N: HARDLY.get(N, 1 / N)),
     "it rises at N = 15, from 0.0339300 to 0.0339301, and once more"),
    ("one-function-period 0", both("period", power(1), power(1, 0.5)), "1.25 % against 2.50 %"),
    ("one-function-period 1", both("period", power(1), power(3)), "N⁻³·⁰⁰ against N⁻¹·⁰⁰"),
    ("one-function-gibbs 1", at_3(0.005), "0.50 % of the jump; without g₁ 20 %"),
    ("mean-of-the-jump 0", level(0.45, 5), "45.0 % of the jump at N = 40"),
    ("overtakes 0", from_order(20), "from N = 20 on"),
    ("overtakes 0", from_order(41), "not by then"),
    ("overtakes 1", only_at(9), "2.00 % off against 1.00 % at N = 9"),
    ("overtakes 2", only_at(3), "2.00 % off against 1.00 %"),
    ("band 0", in_band(17, -0.02), "at worst −2.00 %, at N = 17"),
    ("band 2", without_orbit_at_4(0.3), "at N = 4 there is none of a slip shorter than"),
    ("monotone-c1 0", except_at(9, 1e-8), "it grows at N = 9"),
    ("monotone-c1 0", c1(falling), "to rounding at N = 13"),
    ("monotone-c1 1", except_at(9, -1e-9), "it crosses at N = 9 and 10"),
    ("poorest 0", three(0.2, 0.19, 0.1), "hb 20.0 %, hb-c1 19.0 %, c1 10.0 %"),
    ("stairs 0", steps(4, 0.5), "by factors of 4.0 to 4.0 at odd orders, 0.50 to 0.50 at even"),
    ("stairs 1", steps(10, 0.5), "it changes by 100 % at N = "),
]  # fmt: skip


@pytest.mark.parametrize(("name", "case", "words"), SAID)
def test_a_finding_has_the_numbers_that_were_measured(name: str, case, words: str) -> None:
    assert STATEMENTS[name].check(case).numbers.startswith(words)
