"""The saltation matrix: the linear map of perturbations of the motion across a switch.

A perturbed motion reaches the event a little earlier or later than the orbit.  Compared at one
time, its difference after the switch has three parts: the difference before, the delay of the
event, and the difference of the rates before and after, over that delay.  The delay is solved
for from the event, and the law of the switch is differentiated: no result is typed in.
"""

import sympy as sp

from .data import Memory, Phase, SceneData, forcing, once, v, x
from .linear import state_row
from .smoothness import switches

#: The state whose perturbations a switch maps.
STATE = (x, v)

#: Accelerations on both sides of a switch, and the derivative of ``forcing`` by time there.
before, after, turning = sp.symbols("a_before a_after turning", real=True)


@once
def saltations(scene: SceneData) -> tuple[sp.Matrix, ...]:
    """Return the saltation matrix at the end of each phase of a cell; see `saltation`.

    If the last phase leads into the mirror image of the first, the state on both sides is that
    of the motion itself, before it is mirrored.

    Examples
    --------
    >>> from ..scenes.impact import SCENE
    >>> saltations(SCENE)[0]
    Matrix([
    [                      -r,  0],
    [(a_after + a_before*r)/v, -r]])
    """
    cell_switches, phases = switches(scene), scene.phases
    behind = (scene.after(p)[0] for p in range(len(phases)))
    return tuple(
        saltation(left, phases[q], cell_switches[q].k, scene.memory)
        for left, q in zip(phases, behind, strict=True)
    )


def saltation(left: Phase, right: Phase, k: int, memory: tuple[Memory, ...] = ()) -> sp.Matrix:
    """Return the derivative of the state after a switch by the state before, at one time.

    The state is `x`, `v` and the memories.  The result is in terms of the state before the
    switch, the accelerations `before` and `after`, and `turning`, the rate of the forcing.

    Parameters
    ----------
    left, right : Phase
        The phases before and after.
    k : int
        Class of the motion at the switch: from 2 on the acceleration is continuous.
    memory : tuple of Memory
        Constants that switches set.
    """
    state = (*STATE, *(each.symbol for each in memory))
    constant = [sp.Integer(0)] * len(memory)
    rates_before = sp.Matrix([v, before, *constant])
    speed = sp.sympify(left.ends.jump.get(v, v))
    law = sp.Matrix([x, speed, *(_remembered(each, right, speed) for each in memory)])
    rates_after = sp.Matrix([speed, after, *constant])
    perturbation = sp.Matrix(sp.symbols(f"d_:{len(state)}"))
    delay = sp.Dummy("delay")

    # to first order: the state of the perturbed motion at the event, and its delay
    moved = perturbation + rates_before * delay
    zero = sp.sympify(left.ends.zero)
    change = sum(sp.diff(zero, q) * step for q, step in zip(state, moved, strict=True))
    (solution,) = sp.solve(change + sp.diff(zero, forcing) * turning * delay, delay)

    # the law of the switch there, and back to the time of the orbit's event
    behind = law.jacobian(state) * moved - rates_after * delay
    behind += law.diff(forcing) * turning * delay
    matrix = behind.subs(delay, solution).jacobian(perturbation)
    return matrix.subs(_known(left, right, k)).applyfunc(sp.factor)


def _remembered(memory: Memory, right: Phase, speed: sp.Expr) -> sp.Expr:
    """Return the value of a memory after a switch: the new one if it is set, or the old one."""
    if memory.at != right.name:
        return memory.symbol
    return sp.sympify(memory.value).subs(v, speed)


def _known(left: Phase, right: Phase, k: int) -> dict[sp.Symbol, sp.Expr]:
    """Return values at a switch that follow from constraints and the class of the motion."""
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
