"""The laws of contacts of a body, phase by phase, as linear forms.

A form has factors of ``x, v, cos, 1, force, a`` of the first contact, then of ``x, v, force,
a`` of each further contact, then of each memory.  The class of continuity follows from the laws
alone: the first derivative of a contact force that jumps is two orders below that of the
displacement.
"""

from collections.abc import Mapping, Sequence

import sympy as sp
from sympy.polys.matrices import DomainMatrix

from ..data import Phase, SceneData, forcing, v, x
from ..error import SceneError
from ..linear import parts, state_row
from .body import Body

#: Number of derivatives of the force that are checked for jumps.
HIGHEST = 6


def body_of(scene: SceneData) -> Body:
    """Return the body of a scene that has one."""
    assert scene.body is not None
    return scene.body


def velocities(scene: SceneData) -> tuple[sp.Symbol, ...]:
    """Return the velocities that may jump: of each contact, or of the mass."""
    return tuple(contact.v for contact in scene.contacts) or (v,)


def signals(scene: SceneData) -> tuple[sp.Symbol | sp.Integer, ...]:
    """Return the symbols of which forms are linear combinations, without the memories."""
    if scene.body is None:
        return x, v, forcing, sp.Integer(1)
    first, *others = scene.contacts
    further = (symbol for contact in others for symbol in contact.symbols)
    return (first.x, first.v, forcing, sp.Integer(1), first.force, first.a, *further)


def form(
    expression: sp.Expr, scene: SceneData, what: str, memory: bool = True
) -> tuple[sp.Expr, ...]:
    """Return the factors of a linear form in the signals of a scene and its memories.

    For one mass it is `state_row`.

    Raises
    ------
    SceneError
        If `expression` is not linear; the message begins with `what`.
    """
    remembered = [q.symbol for q in scene.memory] if memory else []
    if scene.body is None:
        return state_row(expression, what, remembered)
    symbols = [q for q in (*signals(scene), *remembered) if q != 1]
    *factors, constant = parts(sp.sympify(expression), symbols, what)
    return (*factors[:3], constant, *factors[3:])


def law_rows(phase: Phase, scene: SceneData) -> list[tuple[sp.Expr, ...]]:
    """Return the laws of a phase as linear forms, one for each contact.

    Raises
    ------
    SceneError
        If the numbers of laws and contacts differ, or a law has neither force nor acceleration.
    """
    field, equations = f"phase {phase.name}: equation", phase.laws
    contacts = scene.contacts
    if len(equations) != len(contacts):
        raise SceneError(f"{field}: got {len(equations)} laws for {len(contacts)} contacts")
    rows = [form(law, scene, field) for law in equations]
    for contact, row in zip(contacts, rows, strict=True):
        if row[place(scene, contact.force)] == 0 and row[place(scene, contact.a)] == 0:
            raise SceneError(
                f"{field}: it says nothing of the force at {contact.name}: expected a law with "
                f"{contact.force}, or {contact.a} of a held contact"
            )
    return rows


def place(scene: SceneData, symbol: sp.Symbol) -> int:
    """Return the index of a symbol in forms."""
    return signals(scene).index(symbol)


def contact_class(
    scene: SceneData, left: Phase, right: Phase, sign: int, values: Mapping[sp.Symbol, sp.Expr]
) -> int | None:
    """Return the k of a switch between two phases of ``scene.cell``; None if nothing changes.

    Parameters
    ----------
    scene : SceneData
    left, right : Phase
    sign : int
        -1 if the motion is mirrored there, else 1.
    values : mapping of Symbol to Expr
        Values of some parameters.
    """
    jump = dict(left.ends.jump)
    if any(sp.simplify((after - q).subs(values)) != 0 for q, after in jump.items()):
        return 0
    vanishing = sp.Matrix(list(_known(scene, left, right, sign))).subs(values)
    for order in range(HIGHEST):
        before = _forces(scene, left, order, sign, "before")
        after = _forces(scene, right, order, 1, "after")
        jumps = sp.Matrix(after).subs(values) - sp.Matrix(before).subs(values)
        stacked = DomainMatrix.from_Matrix(sp.Matrix.vstack(vanishing, jumps)).to_field()
        rows = stacked[: vanishing.rows, :]
        if stacked.rank() > rows.rank():
            return order + 1
    return None


def _tail(scene: SceneData) -> int:
    """Return the number of columns of x and forces; cos, sin, 1 and memories follow."""
    return len(scene.contacts) * 3 * (HIGHEST + 3)


def _zeros(scene: SceneData) -> list[sp.Expr]:
    """Return a row of zeros."""
    return [sp.Integer(0)] * (_tail(scene) + 3 + len(scene.memory))


def _row(
    scene: SceneData, factors: Sequence[sp.Expr], order: int, sign: int, side: str
) -> list[sp.Expr]:
    """Return derivative `order` of a form by time; forces are unknowns, on either side."""
    row, tail, omega = _zeros(scene), _tail(scene), scene.frequency or sp.Integer(0)
    for i, contact in enumerate(scene.contacts):
        base = 3 * (HIGHEST + 3) * i
        for shift, symbol in ((0, contact.x), (1, contact.v), (2, contact.a)):
            row[base + order + shift] += factors[place(scene, symbol)]
        free = base + (HIGHEST + 3) * (1 if side == "before" else 2)
        row[free + order] += factors[place(scene, contact.force)]
    turned = order % 4
    row[tail + turned % 2] = factors[2] * omega**order * (1, -1, -1, 1)[turned]
    if order == 0:
        row[tail + 2] = sign * factors[3]
        for i, factor in enumerate(factors[len(signals(scene)) :]):
            row[tail + 3 + i] = sign * factor
    return row


def _forces(
    scene: SceneData, phase: Phase, order: int, sign: int, side: str
) -> list[list[sp.Expr]]:
    """Return a derivative of each contact force of a phase; that of a held one is unknown."""
    rows = []
    for contact, row in zip(scene.contacts, law_rows(phase, scene), strict=True):
        at = place(scene, contact.force)
        factor = row[at]
        if factor == 0:
            force = [sp.Integer(q == at) for q in range(len(row))]
        else:
            force = [sp.Integer(0) if q == at else -c / factor for q, c in enumerate(row)]
        rows.append(_row(scene, force, order, sign, side))
    return rows


def _known(scene: SceneData, left: Phase, right: Phase, sign: int) -> list[list[sp.Expr]]:
    """Return the rows that vanish at a switch, in the signs of its right side."""
    event = form(left.ends.zero, scene, f"phase {left.name}: ends")
    rows = [[sign * q for q in _row(scene, event, 0, sign, "before")]]
    places, tail = [place(scene, contact.force) for contact in scene.contacts], _tail(scene)
    forces = _forces(scene, left, 0, sign, "before")
    for at, law, force_row in zip(places, law_rows(left, scene), forces, strict=True):
        if all(law[q] == 0 for q in places):
            continue  # held: its force is an unknown
        unit = [sp.Integer(i == at) for i in range(len(law))]
        free = _row(scene, unit, 0, 1, "before")
        rows.append([f - r for f, r in zip(free, force_row, strict=True)])
    for phase, side in ((left, sign), (right, 1)):
        if phase.held is not None:
            speed = _zeros(scene)
            speed[1], speed[tail + 2] = sp.Integer(1), -side * sp.sympify(phase.held)
            rows.append(speed)
    if left.held is not None:
        for order in range(2, HIGHEST + 3):
            still = _zeros(scene)
            still[order] = sp.Integer(1)
            rows.append(still)
    for i, q in enumerate(scene.memory):
        if q.at == right.name:
            row = form(q.value, scene, f"memory {q.symbol}", memory=False)
            rows.append(_row(scene, row, 0, 1, "x"))
            rows[-1][tail + 3 + i] = sp.Integer(-1)
    return rows
