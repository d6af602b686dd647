"""What stands beside each figure: what to see, in numbers of this case, and the command."""

from collections.abc import Callable
from dataclasses import asdict, dataclass

from nonsmooth.solver.no_orbit import NoOrbit
from nonsmooth.solver.shortcuts.orbit.motion import exact
from nonsmooth.solver.shortcuts.orbit.oscillator import DEFAULT, StickSlip

from .case import MOST, Case
from .checks.c1 import THREE
from .checks.fourier import BAND, rises
from .reading import reading
from .words import listed, number, percent, power_of_order


@dataclass(frozen=True)
class Plate:
    """A figure of the paper: pictures, and what is written beside them.

    Parameters
    ----------
    title : str
    pictures : dict of str to str
        Names of the pictures, and what each shows, for those who do not see it.
    see : callable
        From a `Case` to what to look at; it may raise `NoOrbit`.
    number : int
        Of the figure in the paper.
    """

    title: str
    pictures: dict[str, str]
    see: Callable[[Case], str]
    number: int

    def text(self, case: Case) -> str:
        """Return what to look at in this case."""
        try:
            return self.see(case)
        except NoOrbit as missing:
            return f"In this case {missing.reason}."

    def command(self, belt: StickSlip) -> str:
        """Return the command that draws this figure alone."""
        return f"nonsmooth report --figure {self.number}{flags(belt)} -o fig{self.number}.pdf"


def flags(belt: StickSlip) -> str:
    """Return the flags that make the default oscillator this one.

    Examples
    --------
    >>> from dataclasses import replace
    >>> flags(replace(DEFAULT, normal_force=98.1))
    ' --normal-force 98.1'
    """
    usual = asdict(DEFAULT)
    return "".join(
        f" --{name.replace('_', '-')} {value!r}".removesuffix(".0")
        for name, value in asdict(belt).items()
        if value != usual[name]
    )


def _oscillator(case: Case) -> str:
    belt = case.belt
    return (
        f"A mass M = {belt.mass:g} kg on a spring K = {belt.stiffness:g} N/m lies on a belt "
        f"that moves at V = {belt.belt_speed:g} m/s, and is pressed to it by "
        f"F_N = {belt.normal_force:g} N. It sticks until the spring pulls with "
        f"μ_s F_N = {number(belt.mu_s * belt.normal_force)} N; then it slips back, held by no "
        f"more than μ_k F_N = {number(belt.mu_k * belt.normal_force)} N, until it is as fast "
        "as the belt again."
    )


def _orbit(case: Case) -> str:
    motion = exact(case.belt)
    share = motion.t1 / motion.period
    jump = case.alpha * case.belt.acceleration_unit
    return (
        f"From A to B the mass sticks, for {number(motion.t1)} s, {percent(share, 2)} of the "
        f"period of {number(motion.period, 4)} s; from B back to A it slips. The displacement "
        "is smooth, the velocity has two kinks, and the acceleration jumps there, by "
        f"{number(jump)} m/s². That is what a series of smooth functions cannot do."
    )


def _many_harmonics(case: Case) -> str:
    jump = case.alpha * case.belt.acceleration_unit
    time, size = case.peak("hb", MOST)
    end = case.orbit("hb", MOST).t1 - time
    error = percent(case.acceleration_error("hb", MOST))
    return (
        f"Even with N = {MOST} harmonics the series overshoots beside each jump, in stick by "
        f"{percent(size / jump)} of it, {number(end)} s before stick ends. More harmonics make "
        "the ripple narrower, not lower: Gibbs' phenomenon. Only the mean square of the "
        f"error, (22), goes to zero; here it is {error}. {reading(case, MOST)}"
    )


def _first_inside(case: Case, method: str) -> int:
    """Return from which order on the period is in the band of Fig. 4; past `MOST` if never."""
    errors = {N: abs(case.period_error(method, N)) for N in case.orders(method)}
    outside = [N for N in range(1, MOST + 1) if N not in errors or errors[N] > BAND]
    return max(outside, default=0) + 1


def _inside(case: Case) -> str:
    """Return which methods stay in the band, from which orders on, and which do not."""
    by_order: dict[int, list[str]] = {}
    for method in ("hb", "hb-c1", "c1"):
        by_order.setdefault(_first_inside(case, method), []).append(method)
    never = by_order.pop(MOST + 1, [])
    band = f"{percent(BAND, 1)} of the exact period (grey band)"
    out = f"{listed(never)} {'is' if len(never) == 1 else 'are'} still outside"
    if not by_order:
        return f"{out} {band} at N = {MOST}."
    (first, ahead), *later = sorted(by_order.items())
    stay = "stays" if len(ahead) == 1 else "stay"
    groups = [f"{listed(ahead)} {stay} within {band} from N = {first} on"]
    groups += [f"{listed(methods)} from N = {N} on" for N, methods in later]
    return "; ".join([*groups, *([f"{out} at N = {MOST}"] if never else [])]) + "."


def _overtaking(case: Case) -> str:
    behind = case.behind("period", "c1", "hb-c1")
    if not behind:
        return "The C¹ series is ahead at every order"
    if behind[-1] == MOST:
        return "The C¹ series does not overtake"
    return f"The C¹ series stays ahead from N = {behind[-1] + 1} on"


def _period(case: Case) -> str:
    digits = case.rates("c1").period
    gain = f", and it gains {number(digits, 2)} digits with each order" if digits else ""
    return (
        f"{_inside(case)} {_overtaking(case)}{gain}, until rounding stops it. The second "
        "picture (not in the paper) has a logarithmic scale: on a linear one all three look "
        "converged."
    )


def _three_methods(case: Case) -> str:
    errors = [
        f"{method} {percent(case.acceleration_error(method, THREE))}"
        for method in ("hb", "hb-c1", "c1")
        if case.has(method, THREE)
    ]
    return (
        f"At the same order N = {THREE} the harmonics alone cannot jump at all; those with one "
        "C¹ function can, and so can the C¹ series, whose stick is exact. Error (22): "
        f"{listed(errors)}. {reading(case, THREE, ('hb', 'hb-c1', 'c1'))}"
    )


def _acceleration(case: Case) -> str:
    rates = [(m, case.rates(m).acceleration) for m in ("hb", "hb-c1")]
    fall = listed([f"{m} like {power_of_order(rate)}" for m, rate in rates if rate is not None])
    rising = [(m, len(rises(case, m))) for m in ("hb", "hb-c1", "c1")]
    up = listed([f"{m} {count}" for m, count in rising])
    return (
        f"The error falls slowly in Fourier series, {fall or 'how is not to be said here'}; in "
        "the C¹ series it goes down in stairs, two orders to a step. Number of orders from "
        f"N = 2 to {MOST} at which it is larger than at the order before: {up}. "
        f"{reading(case, MOST)}"
    )


PLATES = (
    Plate(
        "Fig. 1: the oscillator and its friction",
        {
            "fig-1a": "Sketch: a mass on a spring lies on a moving belt.",
            "fig-1b": "Friction against relative velocity: constant in slip, larger in stick.",
        },
        _oscillator,
        1,
    ),
    Plate(
        "Fig. 2: the exact orbit",
        {
            "fig-2a": "Phase plane: level from A to B at the belt's velocity, and an arc back.",
            "fig-2b": "Displacement against time: a straight rise in stick, a wave in slip.",
            "fig-2c": "Velocity against time: constant in stick, with a kink at each end.",
            "fig-2d": "Acceleration against time: zero in stick, with a jump at each end.",
        },
        _orbit,
        2,
    ),
    Plate(
        f"Fig. 3: acceleration by classical harmonic balance, N = {MOST}",
        {
            "fig-3": "Acceleration over a period: the series ripples about the exact curve.",
            "fig-3-detail": "The end of stick, enlarged: the overshoot before the jump.",
        },
        _many_harmonics,
        3,
    ),
    Plate(
        "Fig. 4: the period against the order",
        {
            "fig-4": "Period against N: three methods approach the exact one.",
            "fig-4-errors": "Size of the period error against N, on a logarithmic scale.",
        },
        _period,
        4,
    ),
    Plate(
        f"Fig. 5: acceleration by the three methods, N = {THREE}",
        {"fig-5": "Acceleration over a period at N = 3 by three methods, and the exact one."},
        _three_methods,
        5,
    ),
    Plate(
        "Fig. 6: the error of the acceleration against the order",
        {"fig-6": "Error (22) against N on a logarithmic scale, for three methods."},
        _acceleration,
        6,
    ),
)
