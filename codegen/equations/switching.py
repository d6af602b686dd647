"""Linear forms of the state, in a phase and at switches: events, laws, jumps."""

from collections.abc import Callable, Iterator

import sympy as sp

from ..scene import Memory, forcing, linear_phase, saltation, saltations, v, x
from ..scene.smoothness import generator, known_rows
from .conditions.functions import Rate, state, t
from .notation import Notation
from .tidy import positive

#: Names of the states, and symbols of their small perturbations.
PERTURBATIONS = (
    ("displacement", sp.Function("xi")),
    ("velocity", sp.Function("eta")),
)


def event(notation: Notation, p: int) -> sp.Expr:
    """Return the event function at the end of phase `p`, before the switch."""
    return at_the_end(notation, p, notation.scene.cell[p].ends.zero)


def event_after(notation: Notation, p: int) -> sp.Expr:
    """Return the event function in the state after the switch, but for jumping velocities."""
    following, sign = notation.scene.after(p)
    time = notation.side(following, "+") if following else notation.at(0)
    ends = notation.scene.cell[p].ends

    def after(order: int) -> sp.Expr:
        jumps = order == 1 and v in ends.jump
        return notation.end(p, order) if jumps else sign * state(order, time)

    return at_state(notation, ends.zero, notation.at(p + 1), after)


def at_the_end(notation: Notation, p: int, expression: sp.Expr) -> sp.Expr:
    """Return a linear form in the state where phase `p` ends."""
    return at_state(
        notation, expression, notation.at(p + 1), lambda order: notation.end(p, order)
    )


def set_to(notation: Notation, memory: Memory) -> sp.Expr:
    """Return the value that a memory is set to, in the state there."""
    p = notation.scene.setting(memory)
    return at_state(
        notation, memory.value, notation.at(p), lambda order: notation.start(p, order)
    )


def jump(notation: Notation, p: int) -> tuple[sp.Expr, sp.Expr]:
    """Return the jump of the first discontinuous derivative at the begin of phase `p`.

    As a difference of both sides, and as an expression in the state there, reduced by the event
    and by a prescribed velocity.
    """
    scene, order = notation.scene, notation.switches[p].jumps
    sides = [state(order, notation.side(p, sign)) for sign in "+-"]
    if order == 1:
        before, (q, sign) = sides[1], scene.before(p)
        after = sp.sympify(scene.phases[q].ends.jump[v]).subs(v, sign * before)
        return sides[0] - sides[1], sp.factor(sign * after - before)
    return sides[0] - sides[1], _size(notation, p, order)


def _size(notation: Notation, p: int, order: int) -> sp.Expr:
    """Return the jump of a derivative as an expression in the state at the switch."""
    scene, (q, sign) = notation.scene, notation.scene.before(p)
    left, right = scene.cell[q], scene.cell[p]
    frequency = scene.frequency if scene.frequency is not None else sp.Integer(0)
    turning = sp.Symbol("turning", real=True)
    memory = [q.symbol for q in scene.memory]
    y = sp.Matrix([x, v, 1, forcing, turning, *memory])
    after = generator(right, frequency, memory=memory) ** order
    before = generator(left, frequency, sign, memory) ** order
    size = ((after - before).row(0) * y)[0]
    vanishing = [(sp.Matrix([row]) * y)[0] for row in known_rows(scene, left, right, sign)]
    values: dict[sp.Symbol, sp.Expr] = {}
    for zero in vanishing:
        zero = sp.expand(zero.subs(values))  # noqa: PLW2901
        pivot = next((q for q in (x, v, forcing) if zero.diff(q) != 0), None)
        if pivot is not None:
            solved = {pivot: -zero.subs(pivot, 0) / zero.diff(pivot)}
            values = {q: e.subs(solved) for q, e in values.items()} | solved
    time = notation.at(p)
    waves = {turning: sp.sin(notation.times.angle(time))}
    difference = sp.factor(sp.expand(size.subs(values, simultaneous=True)))
    return at_state(notation, difference, time).subs(waves)


def perturbations(notation: Notation, p: int) -> Iterator[tuple[str, tuple[sp.Expr, ...]]]:
    """Yield name and equation of each perturbation after the end of phase `p`."""
    sides = {side: notation.side(p + 1, side) for side in "+-"}
    angle = notation.times.angle(notation.at(p + 1))
    frequency = notation.scene.frequency
    values = {
        v: state(1, sides["-"]),
        saltation.before: state(2, sides["-"]),
        saltation.after: state(2, sides["+"]),
    }
    if frequency is not None:
        values[saltation.turning] = -frequency * sp.sin(angle)
    matrix = saltations(notation.scene)[p].subs(values, simultaneous=True)
    components = [*PERTURBATIONS, *_of_memory(notation)]
    for (name, perturbation), row in zip(components, matrix.tolist(), strict=True):
        terms = (entry * q(sides["-"]) for entry, (_, q) in zip(row, components, strict=True))
        yield f"`{perturbation}` of the {name}", (perturbation(sides["+"]), sp.Add(*terms))


def _of_memory(notation: Notation) -> Iterator[tuple[str, sp.FunctionClass]]:
    """Yield the name of each memory, and the symbol of a small perturbation of it."""
    for i, memory in enumerate(notation.scene.memory):
        yield f"memory `{memory.symbol}`", sp.Function("zeta" if i == 0 else f"zeta_{i}")


def at_state(
    notation: Notation,
    expression: sp.Expr,
    time: sp.Expr,
    derivative: Callable[[int], sp.Expr] | None = None,
) -> sp.Expr:
    """Return a linear form with the state at a time put in.

    For one mass, ``derivative(order)`` may give displacement and velocity there, on one side of
    a switch.
    """
    values: dict[sp.Expr, sp.Expr] = {forcing: notation.times.forcing(time)}
    if notation.scene.body is None:
        derivative_at = derivative or (lambda order: state(order, time))
        values |= {x: derivative_at(0), v: derivative_at(1)}
    else:
        for c, contact in enumerate(notation.scene.contacts):
            for order, symbol in enumerate((contact.x, contact.v, contact.a)):
                values[symbol] = notation.displacement(c, order, time)
            values[contact.force] = notation.force(c, time)
    return sp.sympify(expression).subs(values, simultaneous=True)


def equation_of_motion(notation: Notation, p: int) -> tuple[sp.Expr, sp.Expr]:
    """Return both sides of the equation of motion: terms of the motion, and the force."""
    q = linear_phase(notation.scene.cell[p])
    left = sum(factor * state(order, t) for order, factor in ((2, q.m), (1, q.c), (0, q.k)))
    return left, positive(q.f) + q.g * notation.times.forcing(t)


def balanced(expression: sp.Expr) -> tuple[sp.Expr, sp.Expr, bool]:
    """Return ``(left, right, turned)`` of an equation: terms with the state, other terms.

    Without the state, the forcing is on the left.  The sides are equal if `expression` is zero;
    if `turned`, ``expression >= 0`` is ``left <= right``.
    """
    terms = sp.Add.make_args(sp.expand_mul(expression))
    moving = [q for q in terms if q.has(Rate, sp.Abs) or q.has(sp.core.function.AppliedUndef)]
    moving = moving or [q for q in terms if q.has(sp.cos)]
    left = sp.Add(*moving)
    remainder = sp.factor_terms(expression.expand(deep=False) - left) if moving else expression
    if remainder.has(Rate, sp.Abs, sp.core.function.AppliedUndef):  # spelled in two ways
        remainder = sp.factor_terms(sp.expand_mul(expression) - left)
    turned = all(q.could_extract_minus_sign() for q in moving)
    return (-left, remainder, True) if turned else (left, -remainder, False)


def not_negative(expression: sp.Expr) -> sp.Expr:
    """Return ``expression >= 0`` with terms of the state on the left."""
    left, right, turned = balanced(expression)
    return (sp.Le if turned else sp.Ge)(left, right, evaluate=False)
