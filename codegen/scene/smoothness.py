"""The class of continuity at each switch, deduced from the equations of motion.

The paper, Section 3.3: "the degree of continuity can be determined by inspection of the
equation(s) of motion".  The inspection: with the state ``y = (x, v, 1, cos, sin)`` a phase is
``y' = A y``, so the jump of the j-th derivative of x at a switch is ``e_x (A+^j - A-^j) y``.
It vanishes for every motion if and only if that row is a combination of the rows known to
vanish there: the event, and the velocity at which a constraint holds the mass.
"""

from dataclasses import dataclass

import sympy as sp
from sympy.polys.matrices import DomainMatrix

from .data import Phase, Scene
from .error import SceneError
from .linear import linear_phase, state_row
from .symbols import v

#: Derivatives that are looked at; a phase that differs from the next differs in these.
HIGHEST = 8


@dataclass(frozen=True)
class Switch:
    """One switch: after which phase, its class, and the first derivative that jumps.

    Parameters
    ----------
    after, before : str
        The phases on both sides.
    k : int
        The motion is C^k there.
    """

    after: str
    before: str
    k: int

    @property
    def jumps(self) -> int:
        """The order of the first derivative of x that jumps."""
        return self.k + 1

    @property
    def derivative(self) -> str:
        """That derivative in words: ``x''``."""
        return "x" + "'" * self.jumps


def switches(scene: Scene) -> tuple[Switch, ...]:
    """Return the switches of a cell: that which begins the first phase, the second, and so on.

    Raises
    ------
    SceneError
        If nothing changes at a switch.
    """
    phases = scene.phases
    return tuple(
        Switch(left.name, right.name, _class(scene, left, right, scene.sign if q == 0 else 1))
        for q, (left, right) in enumerate(zip((phases[-1], *phases[:-1]), phases, strict=True))
    )


def generator(phase: Phase, frequency: sp.Expr, sign: int = 1) -> sp.Matrix:
    """Return ``A`` of a phase; with `sign` -1, of the mirrored motion ``-x``."""
    q = linear_phase(phase)
    return sp.Matrix(
        [
            [0, 1, 0, 0, 0],
            [-q.k / q.m, -q.c / q.m, sign * q.f / q.m, q.g / q.m, 0],
            [0, 0, 0, 0, 0],
            [0, 0, 0, 0, -frequency],
            [0, 0, 0, frequency, 0],
        ]
    )


def _class(scene: Scene, left: Phase, right: Phase, sign: int) -> int:
    jump = dict(left.ends.jump)
    if jump and sp.simplify(jump.get(v, v) - v) != 0:
        return 0
    frequency = scene.frequency if scene.frequency is not None else sp.Integer(0)
    before, after = generator(left, frequency, sign), generator(right, frequency)
    event = state_row(left.ends.zero, f"phase {left.name}: ends")
    known = [[sign * event.x, sign * event.v, event.constant, sign * event.cos, 0]]
    if left.held is not None:
        known.append([0, sign, -left.held, 0, 0])
    for order in range(2, HIGHEST + 1):
        row = (after**order - before**order).row(0)
        if not _in_span(row, sp.Matrix(known)):
            return order - 1
    raise SceneError(f"phase {right.name}: its motion is that of {left.name}; nothing changes")


def _in_span(row: sp.Matrix, known: sp.Matrix) -> bool:
    return _rank(known.col_join(row)) == _rank(known)


def _rank(matrix: sp.Matrix) -> int:
    """Return the rank for general values of the parameters."""
    return int(DomainMatrix.from_Matrix(matrix).to_field().rank())
