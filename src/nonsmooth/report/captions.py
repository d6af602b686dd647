"""The text beside each figure: what to see, with the numbers of a case, and the command."""

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Any

import nonsmooth as ns
from nonsmooth.kim_perkins import METHODS

from .case import DEFAULT, MOST, Case
from .checks import BAND, THREE
from .checks.fourier import rising
from .claims import table
from .measures import peak
from .words import listed, number, percent, power_of_order

#: The order at which test functions of the C1 series are compared: errors are above rounding.
EIGHT = 8


@dataclass(frozen=True)
class Plate:
    """A figure of the paper: its pictures, and the text beside them; see `figures.toml`."""

    number: int
    title: str
    see: str
    pictures: dict[str, str]

    def text(self, case: Case) -> str:
        """Return the text on what to see, with the numbers of a case."""
        try:
            return self.see.format(**NUMBERS[self.number](case))
        except ns.NoOrbit as missing:
            return f"In this case {missing.reason}."

    def command(self, belt: ns.StickSlip) -> str:
        """Return the command that draws this figure alone."""
        return f"nonsmooth report --figure {self.number}{flags(belt)} -o fig{self.number}.pdf"


PLATES = [Plate(**row) for row in table("figures.toml")["figure"]]


def flags(belt: ns.StickSlip) -> str:
    """Return the command-line flags of an oscillator: parameters that differ from the default.

    Examples
    --------
    >>> flags(ns.StickSlip(**{**DEFAULT.values, "normal_force": 98.1}))
    ' --normal-force 98.1'
    """
    usual = DEFAULT.values
    return "".join(
        f" --{name.replace('_', '-')} {value!r}".removesuffix(".0")
        for name, value in belt.values.items()
        if value != usual[name]
    )


def reading(case: Case, order: int, methods: Iterable[str] = ("hb",)) -> str:
    """Return in words how (22) is read here, and the errors by the other reading."""
    parts = [
        f"{method} {percent(case.measured('acceleration at equal times', method, order))} "
        f"instead of {percent(case.measured('acceleration', method, order))}"
        for method in methods
        if case.has(method, order)
    ]
    other = f"; compared at equal times t it would be, at N = {order}, {listed(parts)}"
    return f"(22) is over normalised time t/T, our reading of (21){other if parts else ''}."


def _oscillator(case: Case) -> dict[str, Any]:
    belt = case.belt
    friction = {"static": belt.mu_s, "kinetic": belt.mu_k}
    return dict(belt.values) | {
        name: number(mu * belt.normal_force) for name, mu in friction.items()
    }


def _orbit(case: Case) -> dict[str, Any]:
    exact = case.exact
    return {
        "t1": number(exact.t1),
        "share": percent(exact.t1 / exact.period, 2),
        "period": number(exact.period, 4),
        "jump": number(case.belt.largest_jump),
    }


def _many_harmonics(case: Case) -> dict[str, Any]:
    orbit = case.orbit("hb", MOST)
    time, size = peak(orbit)
    return {
        "overshoot": percent(size / case.belt.largest_jump),
        "before": number(orbit.t1 - time),
        "error": percent(case.measured("acceleration", "hb", MOST)),
        "reading": reading(case, MOST),
    }


def _inside(case: Case) -> str:
    """Return in words from which order on each method stays in the band of Fig. 4."""
    by_order: dict[int, list[str]] = {}
    for method in METHODS:
        errors = {N: abs(case.measured("period", method, N)) for N in case.orders(method)}
        outside = [N for N in range(1, MOST + 1) if N not in errors or errors[N] > BAND]
        by_order.setdefault(max(outside, default=0) + 1, []).append(method)
    never = by_order.pop(MOST + 1, [])
    band = f"{percent(BAND, 1)} of the exact period (grey band)"
    out = f"{listed(never)} {'is' if len(never) == 1 else 'are'} still outside"
    if not by_order:
        return f"{out} {band} at N = {MOST}."
    (first, ahead), *later = sorted(by_order.items())
    stay = "stays" if len(ahead) == 1 else "stay"
    groups = [f"{listed(ahead)} {stay} within {band} from N = {first} on"]
    groups += [f"{listed(methods)} from N = {N} on" for N, methods in later]
    groups += [f"{out} at N = {MOST}"] if never else []
    return "; ".join(groups) + "."


def _overtaking(case: Case) -> str:
    behind = case.behind("period", "c1", "hb-c1")
    if not behind:
        return "The C¹ series is ahead at every order"
    if behind[-1] == MOST:
        return "The C¹ series does not overtake"
    return f"The C¹ series stays ahead from N = {behind[-1] + 1} on"


def _period(case: Case) -> dict[str, Any]:
    digits = case.rate("period", "c1")
    gain = f", and it gains {number(digits, 2)} digits with each order" if digits else ""
    return {"inside": _inside(case), "overtaking": _overtaking(case), "gain": gain}


def _three_methods(case: Case) -> dict[str, Any]:
    errors = [
        f"{method} {percent(case.measured('acceleration', method, THREE))}"
        for method in METHODS
        if case.has(method, THREE)
    ]
    return {"errors": listed(errors), "reading": reading(case, THREE, METHODS)}


def _acceleration(case: Case) -> dict[str, Any]:
    rates = [(method, case.rate("acceleration", method)) for method in ("hb", "hb-c1")]
    fall = [f"{method} like {power_of_order(q)}" for method, q in rates if q and q > 0]
    rise = [f"{method} {len(rising(case, method))}" for method in METHODS]
    return {
        "fall": listed(fall) or "how is not to be said here",
        "rising": listed(rise),
        "reading": reading(case, MOST),
    }


#: The numbers that are put into the text of each figure.
NUMBERS: dict[int, Callable[[Case], dict[str, Any]]] = {
    1: _oscillator,
    2: _orbit,
    3: _many_harmonics,
    4: _period,
    5: _three_methods,
    6: _acceleration,
}


def other_tests(case: Case) -> str:
    """Return the errors of the period with the paper's test functions and with Legendre's."""
    errors = []
    for method in ("c1", "c1-tau"):
        try:
            orbit = case.orbit(method, EIGHT)
        except ns.NoOrbit as missing:
            return f"In this case {missing.reason}."
        errors.append(percent(abs(orbit.period / case.exact.period - 1)))
    paper, legendre = errors
    return f"At N = {EIGHT} the period is {paper} off with its tests and {legendre} with these."
