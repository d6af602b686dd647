"""Harmonics: Section 3.1 of the paper for any scene (`hb`).

Where the velocity jumps, the impulse is an unknown besides.  The delta in the acceleration
moves to the right side of the orthogonality conditions exactly, the series has the mean
velocity of both sides at the jump, and the law of the impact is one row more.
"""

from collections.abc import Iterator

import sympy as sp

from ..galerkin import Block, Condition, GalerkinConditions, Times, closure
from ..galerkin.bodies import harmonics as of_forces
from ..galerkin.condition import BodyConditions, N
from ..galerkin.harmonics import Harmonics, a, a0, angle, b, j, n
from ..scene import Scene, Switch, switches, v
from . import About

METHOD = "hb"
KERNEL = "hb"
TITLE = "Fourier series"
ABOUT = About(place=1, power=True, colour="#0072B2", marker="D", line=(0, (6, 2)), filled=False)


def jump(cell_switches: tuple[Switch, ...], p: int) -> sp.Expr:
    """Return the jump of the velocity where phase `p` begins, an unknown if it has one."""
    switch = cell_switches[p]
    return sp.Symbol(f"J_{switch.before}", real=True) if switch.k == 0 else sp.Integer(0)


def series(harmonics: Harmonics, time: sp.Expr, order: int) -> sp.Expr:
    """Return (3), or a derivative of it, at a time."""
    number, w = harmonics.times.harmonic(n), harmonics.omega_0
    turned = number * w * time + order * sp.pi / 2
    size = (number * w) ** order
    sum_ = sp.Sum(size * (a[n] * sp.sin(turned) + b[n] * sp.cos(turned)), (n, 1, N))
    return sum_ + (a0 / 2 if order == 0 and not harmonics.odd else 0)


def orthogonality(
    harmonics: Harmonics, cell_switches: tuple[Switch, ...]
) -> Iterator[Condition]:
    """Yield (5), (6), (7): the residual is orthogonal to the constant and to each harmonic."""
    trial, wave = (harmonics.times.harmonic(index) * angle for index in (n, j))
    tests = (
        ("by_one", "1", sp.Integer(1), "5"),
        ("by_sine", "sin(j omega_0 t)", sp.sin(wave), "6"),
        ("by_cosine", "cos(j omega_0 t)", sp.cos(wave), "7"),
    )
    for name, words, test, number in tests[1:] if harmonics.odd else tests:
        summed = a[n] * harmonics.residual_by(sp.sin(trial), test)
        summed += b[n] * harmonics.residual_by(sp.cos(trial), test)
        expression = sp.Sum(sp.expand(summed), (n, 1, N)) - harmonics.force_by(test)
        if not harmonics.odd:
            expression += a0 / 2 * harmonics.over_cell("k", test)
        for p in range(len(cell_switches)):
            mass = harmonics.weights["m"][p]
            at = test.subs(angle, harmonics.omega_0 * harmonics.times.start(p))
            expression -= mass * jump(cell_switches, p) * at
        title = f"residual, orthogonal to {words}"
        index, count = (j, N) if test.has(angle) else (None, sp.Integer(1))
        yield Condition(name, title, expression, index, sp.Integer(1), count, number)


def impacts(
    scene: Scene, harmonics: Harmonics, cell_switches: tuple[Switch, ...]
) -> Iterator[Condition]:
    """Yield the law of each impact, with the mean velocity that the series has there."""
    for p, switch in enumerate(cell_switches):
        if switch.k:
            continue
        left, sign = scene.before(p)
        law = scene.phases[left].ends.jump[v]
        mean = series(harmonics, harmonics.times.start(p), 1)
        before = sign * (mean - jump(cell_switches, p) / 2)
        yield Condition(
            f"impact_{switch.before}",
            f"the velocity jumps as the event says where {switch.before} begins",
            closure.one_sum(
                mean + jump(cell_switches, p) / 2 - sign * sp.sympify(law).subs(v, before)
            ),
        )


def derive(scene: Scene) -> GalerkinConditions:
    """Return the conditions of a scene in this expansion."""
    times, cell_switches, harmonics = Times.of(scene), switches(scene), Harmonics.of(scene)

    def end(p: int, order: int) -> sp.Expr:
        after, sign = scene.after(p)
        mean = series(harmonics, times.start(p + 1), order)
        return mean - sign * jump(cell_switches, after) / 2 if order == 1 else mean

    def start(p: int, order: int) -> sp.Expr:
        mean = series(harmonics, times.start(p), order)
        return mean + jump(cell_switches, p) / 2 if order == 1 else mean

    conditions = (
        *orthogonality(harmonics, cell_switches),
        *impacts(scene, harmonics, cell_switches),
        *closure.events(scene, times, end),
        *closure.memory(scene, times, start),
        *closure.period(times),
    )
    blocks = tuple(_blocks(scene, cell_switches))
    return GalerkinConditions(scene, METHOD, TITLE, blocks, times, conditions)


def series_blocks(scene: Scene) -> Iterator[Block]:
    """Yield the coefficients of (3)."""
    if scene.sign == 1:
        yield Block(a0, sp.Integer(1), "twice the mean")
    yield Block(a, N, "of the sines")
    yield Block(b, N, "of the cosines")


def _blocks(scene: Scene, cell_switches: tuple[Switch, ...]) -> Iterator[Block]:
    yield from series_blocks(scene)
    for p, switch in enumerate(cell_switches):
        if switch.k == 0:
            what = f"jump of the velocity where {switch.before} begins"
            yield Block(jump(cell_switches, p), sp.Integer(1), what)
    yield from closure.memory_blocks(scene)


def of_body(scene: Scene) -> BodyConditions:
    """Return the conditions of a body: its contact forces in harmonics."""
    return of_forces.derive(scene, METHOD, "contact forces as Fourier series")
