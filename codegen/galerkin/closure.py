"""The conditions that join the phases: continuity, jumps, events, memories, the period.

They hold for any expansion that gives the derivatives of the displacement at both ends of each
phase.
"""

from collections.abc import Callable, Iterator, Sequence

import sympy as sp

from ..scene import Scene, Switch, forcing, v, x
from .condition import Block, Condition, Times
from .harmonics import equations

#: ``end(phase, order)``: a derivative of the displacement at one end of a phase.
End = Callable[[int, int], sp.Expr]

#: The name of the condition that replaces the first event.
START = "start"


def one_sum(expression: sp.Expr) -> sp.Expr:
    """Return an expression in which sums over the same index are one sum."""
    expression = sp.expand_mul(expression)
    summands: dict[tuple[sp.Expr, ...], sp.Expr] = {}
    for part in sorted(expression.atoms(sp.Sum), key=sp.default_sort_key):
        weight = expression.coeff(part)
        expression -= weight * part
        limits = part.limits
        summands[limits] = summands.get(limits, sp.Integer(0)) + weight * part.function
    sums = (sp.Sum(f, *limits) for limits, f in summands.items() if sp.expand_mul(f) != 0)
    return sp.Add(sp.expand_mul(expression), *sums)


def law(scene: Scene, p: int, end: End) -> sp.Expr:
    """Return the velocity at the begin of phase `p` by the jump law, from that before."""
    left, sign = scene.before(p)
    return sign * sp.sympify(scene.phases[left].ends.jump.get(v, v)).subs(v, end(left, 1))


def differentiated(
    scene: Scene,
    times: Times,
    p: int,
    order: int,
    start: End,
    end: End,
    at: Callable[[int], sp.Expr],
) -> sp.Expr:
    """Return a condition, zero, on the jump of a derivative where phase `p` begins.

    For order 1 it is the law of the velocity; for higher orders the equation of motion,
    differentiated ``order - 2`` times, after the switch less before.  ``at(p)`` is the time.
    """
    if order == 1:
        return start(p, 1) - law(scene, p, end)
    phases = equations(scene)

    def side(q: int, derivative: End, time: sp.Expr) -> sp.Expr:
        phase = phases[q]
        parts = enumerate((phase.m, phase.c, phase.k))
        total = sp.Add(*(factor * derivative(q, order - step) for step, factor in parts))
        force = phase.f if order == 2 else sp.Integer(0)
        if times.frequency is not None and phase.g != 0:
            turned = times.angle(time) + (order - 2) * sp.pi / 2
            force += phase.g * times.frequency ** (order - 2) * sp.cos(turned)
        return total - force

    left, sign = scene.before(p)
    return side(p, start, at(p)) - sign * side(left, end, at(left + 1))


def joints(
    scene: Scene, switches: Sequence[Switch], start: End, end: End
) -> Iterator[Condition]:
    """Yield continuity of displacement, the law of the velocity, and smoothness up to C^k."""
    for p, switch in enumerate(switches):
        left, sign = scene.before(p)
        name, held = switch.before, scene.phases[p].held is not None
        yield Condition(
            f"displacement_{name}",
            f"displacement is continuous where {name} begins",
            start(p, 0) - sign * end(left, 0),
        )
        jumps = "jumps as the event says" if switch.k == 0 else "is continuous"
        yield Condition(
            f"velocity_{name}",
            f"velocity {jumps} where {name} begins",
            one_sum(start(p, 1) - law(scene, p, end)),
        )
        for order in range(2, switch.k + 1 if not held else 2):
            yield Condition(
                f"derivative_{order}_{name}",
                f"derivative {order} is continuous where {name} begins",
                one_sum(start(p, order) - sign * end(left, order)),
            )


def events(scene: Scene, times: Times, end: End) -> Iterator[Condition]:
    """Yield the event at the end of each phase."""
    for p, phase in enumerate(scene.cell):
        yield _event(scene, times, p, end, f"event_{phase.name}", "")


def events_after(scene: Scene, times: Times, start: End, end: End) -> Iterator[Condition]:
    """Yield the events in the state after the switch, except a velocity that jumps.

    With continuity they are equivalent to `events`, and each prescribes the state in which a
    phase begins.
    """
    for p, phase in enumerate(scene.cell):

        def after(q: int, order: int, jump: bool = v in phase.ends.jump) -> sp.Expr:
            following, sign = scene.after(q)
            return end(q, order) if jump and order == 1 else sign * start(following, order)

        name, words = f"event_{phase.name}_after", ", in the state after it"
        yield _event(scene, times, p, after, name, words)


def _event(scene: Scene, times: Times, p: int, state: End, name: str, words: str) -> Condition:
    """Return the event that ends phase `p`, in a given state."""
    phase = scene.cell[p]
    at = {x: state(p, 0), v: state(p, 1), forcing: times.forcing(times.start(p + 1))}
    return Condition(
        name,
        f"the event that ends {phase.name}{words}",
        one_sum(phase.ends.zero.subs(at, simultaneous=True)),
    )


def begins(scene: Scene, start: End) -> Iterator[Condition]:
    """Yield the condition on the begin of the first phase, if the scene states one: (9)."""
    for symbol, value in scene.start.items():
        order = (x, v).index(symbol)
        what = ("displacement", "velocity")[order]
        name = scene.phases[0].name
        title = f"the {what} where {name} begins is that of the exact orbit"
        yield Condition(START, title, start(0, order) - sp.sympify(value), number="9")


def period(times: Times) -> Iterator[Condition]:
    """Yield the condition that a forced cell has the duration of the forcing."""
    if times.frequency is not None:
        yield Condition(
            "cell",
            "the cell is as long as the forcing makes it",
            times.cell - times.forced_cell,
        )


def memory(scene: Scene, times: Times, start: End) -> Iterator[Condition]:
    """Yield the condition that sets each memory, in the state at the begin of its phase."""
    for q in scene.memory:
        p = scene.setting(q)
        at = {x: start(p, 0), v: start(p, 1), forcing: times.forcing(times.start(p))}
        value = sp.sympify(q.value).subs(at, simultaneous=True)
        yield Condition(
            f"memory_{q.symbol}",
            f"{q.symbol} is set where {q.at} begins",
            one_sum(q.symbol - value),
        )


def memory_blocks(scene: Scene) -> Iterator[Block]:
    """Yield the unknown memories."""
    for q in scene.memory:
        what = f"{q.what}, set where {q.at} begins"
        yield Block(q.symbol, sp.Integer(1), what)
