"""Errors in many digits: every digit that is shown is one of the error, not of rounding."""

import json

import mpmath as mp
import pytest
from every_run import tried

import nonsmooth as ns
from nonsmooth.solver.shortcuts.orbit.oscillator import DEFAULT

pytest.importorskip("flint")

from nonsmooth.shortcuts import twin

#: Digits of the computation of this module, and at which its secants end.
WORKING, SECANT = 200, 150


def solution(rows: list[list[mp.mpf]]) -> list[mp.mpf]:
    """Return the solution of a system with its right side as last column, by elimination.

    Over lists: the matrices of mpmath take longer to look up a number than to multiply it.
    """
    size = len(rows)
    for k in range(size):
        rows[k:] = sorted(rows[k:], key=lambda row: -abs(row[k]))
        pivot = rows[k]
        for i in range(k + 1, size):
            factor = rows[i][k] / pivot[k]
            rows[i][k + 1 :] = [
                q - factor * p for q, p in zip(rows[i][k + 1 :], pivot[k + 1 :], strict=True)
            ]
    found: list[mp.mpf] = []
    for k in reversed(range(size)):
        known = mp.fsum(q * f for q, f in zip(rows[k][k + 1 : size], found, strict=True))
        found.insert(0, (rows[k][size] - known) / rows[k][k])
    return found


def motion(N: int, s: mp.mpf) -> tuple[mp.mpf, mp.mpf]:
    """Return y(t1) and y(T) of the series (15) that solves (18) and (20), for a slip of s.

    In powers of u, as the paper has them; alpha does not come in before (19).
    """
    square, inverse = s**2, [1 / mp.mpf(n) for n in range(1, 2 * N + 6)]
    twice = [square * inverse[n] * inverse[n + 1] for n in range(N + 1)]
    rows = [
        [inverse[n + k + 2] + twice[n] * inverse[n + k + 4] for n in range(N + 1)]
        + [inverse[k + 2], -s * inverse[k + 3]]
        for k in range(N + 1)
    ]
    d = solution([*rows, [*inverse[: N + 1], mp.mpf(0), mp.mpf(0)]])
    gain = s + s**2 * mp.fsum(d[n] / ((n + 1) * (n + 2)) for n in range(N + 1))
    return d[N + 1], d[N + 1] + gain


def errors(N: int, alpha: int) -> tuple[mp.mpf, mp.mpf]:
    """Return the errors of T and t1, by secants from the exact slip."""
    with mp.workdps(WORKING):
        exact = mp.pi + 2 * mp.atan(1 / mp.mpf(alpha))
        before, s = exact, exact + mp.mpf(10) ** -90
        start, end = motion(N, before)
        while abs(s - before) > mp.mpf(10) ** -SECANT:
            old = end
            start, end = motion(N, s)
            before, s = s, s - (end + alpha) * (s - before) / (end - old)
        t1 = start + alpha
        return (t1 + s) / (2 * alpha + exact) - 1, t1 / (2 * alpha) - 1


def belt_at(alpha: float) -> ns.StickSlip:
    return ns.StickSlip(
        mass=1, stiffness=1, belt_speed=1, mu_s=1, mu_k=0.5, normal_force=2 * alpha
    )


@pytest.mark.parametrize(
    ("order", "alpha"),
    tried([(13, 1), (60, 1), (40, 64)], every_run=[(13, 1), (40, 64)]),
)
def test_all_digits_of_the_errors_are_right(order: int, alpha: int) -> None:
    orbit, expected = ns.solve(belt_at(alpha), "c1", order), errors(order, alpha)
    for digits in (1, 6, 12, 20, 60, 120):
        are_right(twin.precise(orbit, digits), min(digits, 20), expected)


def are_right(found: twin.PreciseOrbit, shown: int, errors: tuple[mp.mpf, mp.mpf]) -> None:
    """Compare the errors that are shown with those in many digits."""
    with mp.workdps(WORKING):
        for text, expected in zip((found.error_period, found.error_t1), errors, strict=True):
            # Half of the last digit, and what the text shows of it.
            exponent = mp.floor(mp.log10(abs(expected))) + 1 - shown
            assert abs(mp.mpf(text) - expected) <= mp.mpf("0.501") * mp.mpf(10) ** exponent
            mantissa = text.lstrip("-").partition("e")[0].replace(".", "").lstrip("0")
            assert len(mantissa) == shown


@pytest.mark.parametrize(
    ("method", "order", "shown"), [("hb", 30, (6, 12, 20)), ("hb-c1", 9, (20,))]
)
def test_errors_of_a_fourier_series_agree_at_all_digits(
    method: str, order: int, shown: tuple[int, ...]
) -> None:
    orbit = ns.solve(DEFAULT, method, order)
    with mp.workdps(40):
        reference, *others = (twin.precise(orbit, digits) for digits in (45, *shown))
        for name in ("error_period", "error_t1"):
            expected = mp.mpf(getattr(reference, name))
            assert float(expected) == pytest.approx(
                getattr(orbit.errors, name.removeprefix("error_")), rel=1e-7
            )
            for other in others:
                value = mp.mpf(getattr(other, name))
                assert abs(value / expected - 1) < mp.mpf(10) ** (1 - other.digits)


def test_the_command_prints_the_error_and_not_what_cancellation_left(run) -> None:
    """T to 6 digits says nothing of an error of 1e-82."""
    arguments = ("solve", "--method", "c1", "--order", 60, "--digits", 6)
    status, out, _ = run(*arguments)
    assert status == 0
    assert "T/T_ex - 1   = 1.80165e-82\n" in out
    document = json.loads(run(*arguments, "--json")[1])
    assert document["precise"]["period"] == "0.671239"
    assert document["precise"]["errors"] == {
        "period": "1.80165e-82",
        "t1": "-5.00604e-79",
    }


@pytest.mark.parametrize("digits", [1, 10, 22, 45])
@pytest.mark.parametrize(("method", "order"), [("hb", 6), ("hb-c1", 6), ("c1", 9)])
def test_the_ball_of_a_time_holds_it_and_is_small(method: str, order: int, digits: int) -> None:
    start = ns.solve(DEFAULT, method, order).unknowns
    few, many = (twin.refine(method, 1.0, start, wanted) for wanted in (digits, 120))
    for name in ("t1", "T"):
        ball, sharp = getattr(few, name), getattr(many, name)
        assert ball.rad() > 0
        assert ball.overlaps(sharp)
        assert float((ball.rad() / few.T).mid()) < 10.0 ** -(digits + 1)
        with twin.precision(150):
            assert abs(float((ball.mid() - sharp.mid()) / few.T)) < 10.0 ** -(digits + 1)


def test_a_small_t1_has_all_its_digits() -> None:
    """t1 is a part 3e-9 of T: as many digits of T would leave it none."""
    orbit = ns.solve(belt_at(1e-8), "c1", 40)
    few, many = (twin.precise(orbit, digits) for digits in (12, 40))
    with mp.workdps(60):
        assert abs(mp.mpf(few.t1) / mp.mpf(many.t1) - 1) < mp.mpf("1e-11")
        assert abs(mp.mpf(many.t1) / mp.mpf(2e-8) - 1 - mp.mpf(many.error_t1)) < mp.mpf("1e-38")


def test_an_error_that_cannot_be_told_from_zero_is_refused(monkeypatch) -> None:
    monkeypatch.setattr(twin, "MOST_DIGITS", 70)
    with pytest.raises(twin.PrecisionError, match="c1: its error is zero in 70 digits"):
        twin.precise(ns.solve(DEFAULT, "c1", 60), 5)


def test_parameters_have_as_many_digits_as_the_times() -> None:
    """The root in alpha is rounded once, to more digits than are asked for."""
    belt = ns.StickSlip(mass=3, stiffness=7, belt_speed=0.3, mu_s=0.4, mu_k=0.1, normal_force=5)
    found = twin.precise(ns.solve(belt, "c1", 60), 80)
    with mp.workdps(120):
        omega = mp.sqrt(mp.mpf(belt.stiffness) / belt.mass)
        drop = (mp.mpf(belt.mu_s) - mp.mpf(belt.mu_k)) * belt.normal_force
        alpha = omega * drop / (mp.mpf(belt.stiffness) * belt.belt_speed)
        exact = (2 * alpha + mp.pi + 2 * mp.atan(1 / alpha)) / omega
        error = mp.mpf(found.period) / exact - 1
        assert abs(error) < mp.mpf(10) ** -60
        assert abs(error - mp.mpf(found.error_period)) < mp.mpf(10) ** -79


@pytest.mark.parametrize("method", ["hb", "hb-c1", "c1"])
def test_digits_guessed_at_first_change_no_result(monkeypatch, method: str) -> None:
    """Without any the balls are too wide, and all is done again with more."""
    orbit = ns.solve(belt_at(0.3), method, 9)
    expected = twin.precise(orbit, 30)
    monkeypatch.setattr(twin, "GUARD", 0)
    found = twin.precise(orbit, 30)
    for name in ("period", "t1", "error_period", "error_t1"):
        assert getattr(found, name) == getattr(expected, name)
    refined = twin.refine(method, 0.3, orbit.unknowns, 30)
    assert float((refined.T.rad() / refined.T).mid()) < 1e-31
