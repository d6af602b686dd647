"""A scene of a body for the reader: the body, laws, events, impulses, demands, scales."""

from collections.abc import Iterator

import sympy as sp

from ...galerkin.bodies.contacts import RATE, Contacts
from ...scene import Scene, forcing
from ...scene.bodies.law import body_of, laws
from ...system import Equation
from ..functions import state, t
from ..notation import Notation
from ..of_scene import marked, whole_motion
from ..switching import balanced, not_negative

#: Of the whole body: its coordinates.
q = sp.Function("q")


def body_equations(scene: Scene) -> tuple[Equation, ...]:
    """Return the equations of a body: its motion, laws, demands, what happens at switches.

    Examples
    --------
    >>> from ...scenes.beam_clearance import SCENE
    >>> print(body_equations(SCENE)[2].text(unicode=False))
        -  law at tip in contact; 0 <= t < t1
           k_c*x(t) + f(t) = g*k_c
    """
    notation = Notation.of(scene)
    return (*_body(notation), *_phases(notation), *_switches(notation), *whole_motion(notation))


def vector(contacts: Contacts, c: int) -> sp.Symbol:
    """Return what picks the displacement of a contact."""
    return sp.Symbol(contacts.name("b", c))


def _body(notation: Notation) -> Iterator[Equation]:
    scene = notation.scene
    contacts, body = Contacts(scene), body_of(scene)
    M, C, K, p = sp.symbols("M C K p", commutative=False)
    damped = body.C is not None or body.ratio is not None
    left = M * q(t).diff(t, 2) + K * q(t) + (C * q(t).diff(t) if damped else 0)
    right = sp.Add(
        *(vector(contacts, c) * force(scene, c, t) for c in range(len(contacts.each)))
    )
    if scene.frequency is not None:
        right += p * notation.times.forcing(t)
    words = f"the body, of {body.size} degrees of freedom"
    if body.ratio is not None:
        words += f"; C gives every mode the damping ratio `{body.ratio}`"
    if body.modes is not None:
        words += f"; `{body.modes}` modes move, and the others answer statically"
    yield Equation("", words, (left, right))
    for c, contact in enumerate(contacts.each):
        b = vector(contacts, c)
        sides = (displacement(scene, c, 0, t), sp.Symbol(f"{b}'", commutative=False) * q(t))
        yield Equation("", f"displacement of {contact.name}, which `{b}` picks", sides)


def _phases(notation: Notation) -> Iterator[Equation]:
    scene = notation.scene
    contacts = Contacts(scene)
    for p, phase in enumerate(scene.phases):
        when = notation.during(p)
        for contact, law in zip(contacts.each, laws(scene.cell[p]), strict=True):
            left, right, _ = balanced(at(notation, law, t, t))
            yield Equation("", f"law at {contact.name} in {phase.name}", (left, right), when)
        if phase.held is not None:
            sides = (displacement(scene, 0, 1, t), sp.sympify(phase.held))
            words = f"the velocity is held in {phase.name}"
            yield Equation("", words, sides, when)
            back = displacement(scene, 0, 2, t) + RATE * (sides[0] - sides[1])
            words = f"law that is solved in {phase.name}: the same from that velocity on"
            yield Equation("", words, (back, sp.Integer(0)), when)
        for words, demand in scene.cell[p].demands.items():
            title = f"demanded in {phase.name}: {marked(scene, words)}"
            yield Equation("", title, (not_negative(at(notation, demand, t, t)),))
    if any(phase.held is not None for phase in scene.phases):
        value = scene.frequency or 1 / sp.Symbol("t_unit")
        yield Equation(
            "", "rate at which a held contact returns to its velocity", (RATE, value)
        )


def _switches(notation: Notation) -> Iterator[Equation]:
    scene = notation.scene
    contacts = Contacts(scene)
    for p, phase in enumerate(scene.phases):
        end = notation.at(p + 1)
        left, right, _ = balanced(at(notation, scene.cell[p].ends.zero, end, end))
        yield Equation("", f"{phase.name} ends", (left, right))
        for c, law in contacts.impulses(p):
            before, after = (
                displacement(scene, c, 1, notation.side(p + 1, side)) for side in "-+"
            )
            sign = scene.sign if p + 1 == len(scene.phases) else 1
            value = law.subs(contacts.each[c].v, before)
            words = f"velocity of {contacts.each[c].name} where {phase.name} ends"
            yield Equation("", words, (after, sign * value))
        for words, demand in scene.cell[p].ends.demands.items():
            title = f"demanded where {phase.name} ends: {marked(scene, words)}"
            yield Equation("", title, (not_negative(at(notation, demand, end, end)),))
    names = [phase.name for phase in scene.phases]
    for memory in scene.memory:
        begin = notation.at(names.index(memory.at))
        words = f"{memory.what}: set where {memory.at} begins"
        yield Equation("", words, (memory.symbol, at(notation, memory.value, begin, begin)))


def displacement(scene: Scene, c: int, order: int, time: sp.Expr) -> sp.Expr:
    """Return the displacement of a contact, or a derivative of it; that of the first is x."""
    if c == 0:
        return state(order, time)
    name = list(body_of(scene).at)[c]
    return sp.Function(f"x_{name}" + "'" * order)(time)


def force(scene: Scene, c: int, time: sp.Expr) -> sp.Expr:
    """Return the force at a contact; where there is one alone it is f."""
    names = list(body_of(scene).at)
    return sp.Function("f" if len(names) == 1 else f"f_{names[c]}")(time)


def at(notation: Notation, expression: sp.Expr, time: sp.Expr, angle: sp.Expr) -> sp.Expr:
    """Return a linear form of the contacts at a time, the forcing at another."""
    scene = notation.scene
    values: dict[sp.Expr, sp.Expr] = {forcing: notation.times.forcing(angle)}
    for c, contact in enumerate(body_of(scene).at.values()):
        for order, symbol in enumerate((contact.x, contact.v, contact.a)):
            values[symbol] = displacement(scene, c, order, time)
        values[contact.force] = force(scene, c, time)
    return sp.sympify(expression).subs(values, simultaneous=True)
