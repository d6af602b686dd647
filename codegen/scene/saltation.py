"""What a switch makes of a small perturbation of the motion: the saltation matrix.

A perturbed motion reaches the event a little earlier or later than the orbit.  Two motions are
compared at one time, so that what they differ by behind a switch is made of three parts: the
difference before it, the delay of the event, and in that delay the difference of the motions
before and after it.  The delay is solved for from the event, and the law of the switch is
differentiated: nothing of the result is typed.
"""

import sympy as sp

from .data import Memory, Phase, SceneData, forcing, v, x
from .linear import state_row
from .smoothness import switches

#: The state whose perturbations a switch maps.
STATE = (x, v)

#: Accelerations on both sides of a switch, and the derivative of ``forcing`` by time there.
before, after, turning = sp.symbols("a_before a_after turning", real=True)


def saltations(scene: SceneData) -> tuple[sp.Matrix, ...]:
    """Return the saltation matrix at the end of each phase of a cell; see `saltation`.

    Where the last phase leads into the mirror image of the first, it is the state of the motion
    itself that is meant on both sides, before it is mirrored.

    Examples
    --------
    >>> from ..scenes.impact import SCENE
    >>> saltations(SCENE)[0]
    Matrix([
    [                      -r,  0],
    [(a_after + a_before*r)/v, -r]])
    """
    found, phases = switches(scene), scene.phases
    after = [(p + 1) % len(phases) for p in range(len(phases))]
    return tuple(
        saltation(left, phases[q], found[q].k, scene.memory)
        for left, q in zip(phases, after, strict=True)
    )


def saltation(left: Phase, right: Phase, k: int, memory: tuple[Memory, ...] = ()) -> sp.Matrix:
    """Return the derivative of the state behind a switch by that before it, at one time.

    It is of `x`, `v` and the memory, in the state before the switch, the accelerations `before`
    and `after`, and `turning`, the derivative of the forcing by time.

    Parameters
    ----------
    left, right : Phase
        On both sides.
    k : int
        Class of the motion at the switch: from 2 on the acceleration is continuous.
    memory : tuple of Memory
        What the motion remembers: constant in a phase, set by the switch that sets it.
    """
    state = (*STATE, *(each.symbol for each in memory))
    constant = [sp.Integer(0)] * len(memory)
    rates_before = sp.Matrix([v, before, *constant])
    speed = sp.sympify(left.ends.jump.get(v, v))
    law = sp.Matrix([x, speed, *(_remembered(each, right, speed) for each in memory)])
    rates_after = sp.Matrix([speed, after, *constant])
    perturbation = sp.Matrix(sp.symbols(f"d_:{len(state)}"))
    delay = sp.Dummy("delay")

    # to first order: where the perturbed motion meets the event, and how much later
    moved = perturbation + rates_before * delay
    zero = sp.sympify(left.ends.zero)
    change = sum(sp.diff(zero, q) * step for q, step in zip(state, moved, strict=True))
    (late,) = sp.solve(change + sp.diff(zero, forcing) * turning * delay, delay)

    # the law of the switch there, and back to the time at which the orbit passed it
    behind = law.jacobian(state) * moved - rates_after * delay
    behind += law.diff(forcing) * turning * delay
    matrix = behind.subs(delay, late).jacobian(perturbation)
    return matrix.subs(_known(left, right, k)).applyfunc(sp.factor)


def _remembered(memory: Memory, right: Phase, speed: sp.Expr) -> sp.Expr:
    """Return a memory behind a switch: what it is set to, where it is, or what it was."""
    if memory.at != right.name:
        return memory.symbol
    return sp.sympify(memory.value).subs(v, speed)


def _known(left: Phase, right: Phase, k: int) -> dict[sp.Symbol, sp.Expr]:
    """Return what constraints and the class of the motion say of both sides of a switch."""
    values: dict[sp.Symbol, sp.Expr] = {}
    if k >= 2:
        values[after] = before if left.held is None else sp.Integer(0)
    if left.held is not None:
        values |= {before: sp.Integer(0), v: sp.sympify(left.held)}
    if right.held is not None:
        values[after] = sp.Integer(0)
        of_x, of_v, cos, constant = state_row(left.ends.zero, f"phase {left.name}: ends")
        if of_x == 0 and cos == 0:
            values[v] = sp.simplify(-constant / of_v)
    return values
