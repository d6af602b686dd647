"""The equation of motion of a phase and what else is linear in the state, for the reader."""

from collections.abc import Callable

import sympy as sp

from ..scene import forcing, linear_phase, v, x
from .functions import Rate, state, t
from .notation import Notation
from .tidy import positive


def at_state(
    expression: sp.Expr, derivative: Callable[[int], sp.Expr], force: sp.Expr
) -> sp.Expr:
    """Return a linear form with the state and the forcing put in."""
    values = {x: derivative(0), v: derivative(1), forcing: force}
    return sp.sympify(expression).subs(values, simultaneous=True)


def during(notation: Notation, expression: sp.Expr) -> sp.Expr:
    """Return a linear form at a time `t`."""
    return at_state(expression, lambda order: state(order, t), notation.times.forcing(t))


def equation_of_motion(notation: Notation, p: int) -> tuple[sp.Expr, sp.Expr]:
    """Return both sides: what depends on the motion, and the force."""
    q = linear_phase(notation.scene.cell[p])
    left = sum(factor * state(order, t) for order, factor in ((2, q.m), (1, q.c), (0, q.k)))
    return left, positive(q.f) + q.g * notation.times.forcing(t)


def balanced(expression: sp.Expr) -> tuple[sp.Expr, sp.Expr, bool]:
    """Return ``(left, right, turned)``: what depends on the state, and what does not.

    Where nothing does, the forcing stands on the left.  They are equal where `expression` is
    zero; `turned` if ``left <= right`` is what ``expression >= 0`` says.
    """
    terms = sp.Add.make_args(sp.expand_mul(expression))
    moving = [q for q in terms if q.has(Rate, sp.Abs) or q.has(sp.core.function.AppliedUndef)]
    moving = moving or [q for q in terms if q.has(sp.cos)]
    left = sp.Add(*moving)
    rest = sp.factor_terms(expression.expand(deep=False) - left) if moving else expression
    if rest.has(Rate, sp.Abs, sp.core.function.AppliedUndef):  # spelled in two ways
        rest = sp.factor_terms(sp.expand_mul(expression) - left)
    turned = all(q.could_extract_minus_sign() for q in moving)
    return (-left, rest, True) if turned else (left, -rest, False)


def not_negative(expression: sp.Expr) -> sp.Expr:
    """Return ``expression >= 0`` as a reader would write it."""
    left, right, turned = balanced(expression)
    return (sp.Le if turned else sp.Ge)(left, right, evaluate=False)
