"""The class of continuity at each switch, deduced from the equations of motion.

The paper, Section 3.3: "the degree of continuity can be determined by inspection of the
equation(s) of motion".  The inspection: with the state ``y = (x, v, 1, cos, sin)`` a phase is
``y' = A y``, so the jump of the j-th derivative of x at a switch is ``e_x (A+^j - A-^j) y``.
It vanishes for every motion if and only if that row is a combination of the rows that vanish
there: the event, the constraint of a held velocity, and the value that a memory is set to.  A
memory is a constant of the periodic motion and one more entry of y.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import sympy as sp
from sympy.polys.matrices import DomainMatrix

from .bodies.law import contact_class, form
from .data import Phase, SceneData, once, v, x
from .error import SceneError
from .linear import fixed, linear_phase, state_row

#: Highest derivative that is checked; phases that differ do so in one of these.
HIGHEST = 8


@dataclass(frozen=True)
class Switch:
    """One switch: its phases and its class.

    Parameters
    ----------
    after, before : str
        The phase that ends there, and the phase that begins.
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


@once
def switches(scene: SceneData) -> tuple[Switch, ...]:
    """Return the switches of a cell, that at the begin of the first phase first.

    Between phases that move alike, k is `HIGHEST`: if they hold the velocity while different
    demands hold, or if one demands what the other excludes.

    Raises
    ------
    SceneError
        If nothing changes at a switch.
    """
    of_cell = []
    for left, right, sign in _sides(scene):
        k = _order(scene, left, right, sign, {})
        if k is None and left.name == right.name:
            words = "it follows itself, and nothing changes where it ends; is a phase missing?"
            raise SceneError(f"phase {right.name}: {words}")
        held = right.held is not None and right.demands != left.demands
        if k is None and not held and not _opposed(scene, left, right, sign):
            raise SceneError(
                f"phase {right.name}: its motion is that of {left.name}; nothing changes: make "
                "them one phase, or demand in one what the other excludes"
            )
        of_cell.append(Switch(left.name, right.name, HIGHEST if k is None else k))
    return tuple(of_cell)


def class_of(scene: SceneData) -> int:
    """Return the class of a scene: the lowest k at any switch of any motion."""
    return min(switch.k for motion in scene.each_motion for switch in switches(motion))


def classes_of(scene: SceneData, values: Mapping[sp.Symbol, sp.Expr]) -> tuple[int, ...]:
    """Return the k at each switch for values of the parameters, which may exceed the generic k.

    It is `HIGHEST` if nothing changes for these values.
    """
    rationals = {q: sp.nsimplify(value, rational=True) for q, value in values.items()}
    classes = (_order(scene, *sides, rationals) for sides in _sides(scene))
    return tuple(HIGHEST if k is None else k for k in classes)


def _sides(scene: SceneData) -> Iterator[tuple[Phase, Phase, int]]:
    """Yield the phases on both sides of each switch, and the sign of the motion there."""
    for p, right in enumerate(scene.cell):
        left, sign = scene.before(p)
        yield scene.cell[left], right, sign


def _opposed(scene: SceneData, left: Phase, right: Phase, sign: int) -> bool:
    """Return whether a demand on one side of a switch is the opposite of one on the other."""

    def rows(phase: Phase) -> list[sp.Matrix]:
        return [sp.Matrix([form(q, scene, "demand")]) for q in phase.demands.values()]

    def is_opposite(one: sp.Matrix, other: sp.Matrix) -> bool:
        turned = sign * one
        turned[3] = one[3]  # the constant
        first = next((i for i, factor in enumerate(turned) if factor != 0), None)
        if first is None:
            return False
        ratio = sp.cancel(other[first] / turned[first])
        return (
            bool(ratio.is_negative)
            and (other - ratio * turned).applyfunc(sp.cancel).is_zero_matrix
        )

    return any(is_opposite(one, other) for one in rows(left) for other in rows(right))


def generator(
    phase: Phase, frequency: sp.Expr, sign: int = 1, memory: Sequence[sp.Symbol] = ()
) -> sp.Matrix:
    """Return the matrix A of ``y' = A y`` in a phase; with `sign` -1, for the motion ``-x``."""
    q = linear_phase(phase, memory)
    A = sp.zeros(5 + len(memory))
    A[0, 1] = 1
    A[1, :5] = [[-q.k / q.m, -q.c / q.m, sign * q.f / q.m, q.g / q.m, 0]]
    A[3, 4], A[4, 3] = -frequency, frequency
    for column, factor in enumerate(q.memory, 5):
        A[1, column] = sign * factor / q.m
    return A


def place(scene: SceneData, p: int) -> sp.Expr | None:
    """Return the displacement at which phase `p` of a cell rests, or None if unknown.

    It is known if the event of the phase before prescribes a displacement.
    """
    phase, (left, sign) = scene.cell[p], scene.before(p)
    displacement = fixed(scene.cell[left], x)
    at_rest = phase.held is not None and sp.sympify(phase.held) == 0
    return sign * displacement if at_rest and displacement is not None else None


def known_rows(scene: SceneData, left: Phase, right: Phase, sign: int) -> list[list[sp.Expr]]:
    """Return the rows in y that vanish at the switch between two phases of ``scene.cell``.

    `sign` is -1 if the motion is mirrored there; y is that of the right side.
    """
    memory = [q.symbol for q in scene.memory]
    of_x, of_v, cos, one, *h = state_row(left.ends.zero, f"phase {left.name}: ends", memory)
    rows = [[sign * of_x, sign * of_v, one, sign * cos, 0, *h]]
    nothing = [sp.Integer(0)] * len(memory)
    if left.held is not None:
        rows.append([0, sign, -left.held, 0, 0, *nothing])
    at = place(scene, scene.cell.index(left))
    if at is not None:
        rows.append([sign, 0, -at, 0, 0, *nothing])
    for column, q in enumerate(scene.memory):
        if q.at == right.name:
            of_x, of_v, cos, one = state_row(q.value, f"memory {q.symbol}")
            rows.append([of_x, of_v, one, cos, 0, *nothing])
            rows[-1][5 + column] = sp.Integer(-1)
    return rows


def _order(
    scene: SceneData, left: Phase, right: Phase, sign: int, values: Mapping[sp.Symbol, sp.Expr]
) -> int | None:
    """Return the k of a switch for values of some parameters; None if nothing changes."""
    if scene.body is not None:
        return contact_class(scene, left, right, sign, values)
    jump = dict(left.ends.jump)
    if jump and sp.simplify((jump.get(v, v) - v).subs(values)) != 0:
        return 0
    frequency = scene.frequency if scene.frequency is not None else sp.Integer(0)
    memory = [q.symbol for q in scene.memory]
    before = generator(left, frequency, sign, memory).subs(values)
    after = generator(right, frequency, memory=memory).subs(values)
    rows = sp.Matrix(known_rows(scene, left, right, sign)).subs(values)
    return _first_jump(before, after, rows)


def _first_jump(before: sp.Matrix, after: sp.Matrix, known: sp.Matrix) -> int | None:
    """Return the first j with ``e_x (A+^j - A-^j)`` not in the span of known rows, less 1.

    Ranks are computed over the field of rational functions of the parameters, or of expressions
    if one has roots or other functions of them.
    """
    together = DomainMatrix.from_Matrix(sp.Matrix.vstack(before, after, known)).to_field()
    together = together.to_dense()  # SymPy does not subtract sparse matrices of expressions
    size = before.rows
    A, B, rows = together[:size, :], together[size : 2 * size, :], together[2 * size :, :]
    rank = rows.rank()
    left, right = A[:1, :], B[:1, :]
    for order in range(2, HIGHEST + 1):
        left, right = left * A, right * B
        if rows.vstack(right - left).rank() > rank:
            return order - 1
    return None
