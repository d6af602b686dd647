"""Harmonics and functions of class C^k: Section 3.2 of the paper for any scene (`hb-ck`).

Beside the Fourier series, K functions for each switch: their breaks take from the series the
jumps of the first K derivatives that jump there.  One row for each: the equation of motion,
differentiated, says how large the jump is.

For a switch at ``t_p``, ``beta_n(t - t_p)`` has a jump in its derivative of order n - 1 alone.
With ``u = (t - t_p)/T_c`` on the cell that begins at the switch,

    beta_n = -B_n(u)/n!                    where the motion repeats after a cell,
    beta_n = E_(n-1)(u)/(2 (n - 1)!)       where it repeats with the opposite sign,

with the polynomials of Bernoulli and Euler; the jump is 1 by u, and
``d beta_n/dt = beta_(n-1)/T_c``.
"""

from collections.abc import Iterator
from dataclasses import replace
from functools import partial

import sympy as sp

from ..galerkin import Block, Condition, GalerkinConditions, Times, closure
from ..galerkin.bodies import harmonics as of_forces
from ..galerkin.condition import BodyConditions
from ..galerkin.harmonics import Harmonics, j
from ..scene import Scene, switches
from . import About, hb

METHOD = "hb-ck"
KERNEL = "hb"
TITLE = "Fourier series and functions of class C^k"
ABOUT = About(place=3, power=True, colour="#D55E00", marker="s", line=(0, (6, 2, 1.5, 2)))

#: How many functions a switch may have.
FUNCTIONS = (1, 2, 3)


class Expansion:
    """The pieces of the expansion for one scene, with a number of functions a switch."""

    def __init__(self, scene: Scene, functions: int) -> None:
        self.scene, self.functions, self.switches = scene, functions, switches(scene)
        self.times, self.harmonics = Times.of(scene), Harmonics.of(scene)

    def orders(self, p: int) -> range:
        """Return the n of the functions ``beta_n`` with a break at switch `p`."""
        lowest = self.switches[p].k + 2
        return range(lowest, lowest + self.functions)

    def unknown(self, p: int, n: int) -> sp.Symbol:
        """Return the coefficient of ``beta_n`` of switch `p`."""
        return sp.Symbol(f"c{n}_{self.switches[p].before}", real=True)

    def all(self) -> Iterator[tuple[int, int, sp.Symbol]]:
        """Yield the switch, the order n and the coefficient of each function."""
        for p in range(len(self.switches)):
            for n in self.orders(p):
                yield p, n, self.unknown(p, n)

    def smooth(self, q: int, order: int, left: bool) -> sp.Expr:
        """Return a derivative of the displacement where phase `q` begins, or ends (`left`)."""
        cell = self.times.cell
        time = self.times.start(q + 1 if left else q)
        total = hb.series(self.harmonics, time, order)
        for p, n, c in self.all():
            if n >= order:
                total += c * self.ends(p)[n - order, q, int(left)] / cell**order
        return total

    def ends(self, p: int) -> sp.IndexedBase:
        """Return what the functions of a switch are called at the ends of the phases."""
        return sp.IndexedBase(f"beta_{self.switches[p].before}")

    def integrals(self, p: int, n: int, wave: str) -> sp.IndexedBase:
        """Return what the integrals of a function with harmonics are called."""
        return sp.IndexedBase(f"G{n}_{self.switches[p].before}_{wave}")


def orthogonality(e: Expansion) -> Iterator[Condition]:
    """Yield (5), (6), (7) with the functions beside the series."""
    for condition in hb.orthogonality(e.harmonics, ()):
        by_functions = sp.Integer(0)
        for p, n, c in e.all():
            wave = "sin" if condition.name == "by_sine" else "cos"
            index = sp.Integer(0) if condition.index is None else j
            by_functions += c * e.integrals(p, n, wave)[index]
        yield replace(condition, expression=condition.expression + by_functions)


def jumps(e: Expansion) -> Iterator[Condition]:
    """Yield, for each function, the jump of a derivative that the equation demands."""
    ends = partial(e.smooth, left=False), partial(e.smooth, left=True), e.times.start
    for p, switch in enumerate(e.switches):
        for n in e.orders(p):
            order = n - 1
            expression = closure.differentiated(e.scene, e.times, p, order, *ends)
            yield Condition(
                f"jump_{order}_{switch.before}",
                f"jump of derivative {order} where {switch.before} begins",
                closure.one_sum(expression),
            )


def derive(scene: Scene, functions: int = 1) -> GalerkinConditions:
    """Return the conditions of a scene with this number of functions a switch."""
    e = Expansion(scene, functions)
    rows = (
        *orthogonality(e),
        *jumps(e),
        *closure.events(scene, e.times, lambda p, order: e.smooth(p, order, left=True)),
        *closure.memory(scene, e.times, lambda p, order: e.smooth(p, order, left=False)),
        *closure.period(e.times),
    )
    method = f"{METHOD}, K = {functions}"
    return GalerkinConditions(scene, method, TITLE, tuple(_blocks(e)), e.times, rows)


def _blocks(e: Expansion) -> Iterator[Block]:
    yield from hb.series_blocks(e.scene)
    for p, n, c in e.all():
        what = f"of beta_{n} of the switch to {e.switches[p].before}"
        yield Block(c, sp.Integer(1), what)
    yield from closure.memory_blocks(e.scene)


def of_body(scene: Scene, functions: int = 1) -> BodyConditions:
    """Return the conditions of a body: its contact forces in harmonics and functions."""
    title = "contact forces as Fourier series and functions with breaks"
    return of_forces.derive(scene, f"{METHOD}, K = {functions}", title, functions)
