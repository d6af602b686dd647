"""The equations of a scene with a body, to be printed: matrices, laws, impulses."""

from collections.abc import Iterator

import sympy as sp

from ..galerkin.bodies.contacts import RATE, Contacts
from ..scene.bodies.law import body_of
from ..system import Equation, line
from .conditions.functions import state, t
from .notation import Notation
from .switching import at_state, balanced

#: The coordinates of the whole body.
q = sp.Function("q")


def of_the_body(notation: Notation) -> Iterator[Equation]:
    """Yield the equation of motion of the body, and the displacement of each contact."""
    scene, contacts = notation.scene, Contacts(notation.scene)
    body, indices = body_of(scene), range(len(contacts.each))
    picks = [contacts.name("b", c) for c in indices]
    M, C, K, p = sp.symbols("M C K p", commutative=False)
    damped = body.C is not None or body.ratio is not None
    left = M * q(t).diff(t, 2) + K * q(t) + (C * q(t).diff(t) if damped else 0)
    right = sp.Add(*(sp.Symbol(picks[c]) * notation.force(c, t) for c in indices))
    if scene.frequency is not None:
        right += p * notation.times.forcing(t)
    words = f"the body, of {body.size} degrees of freedom"
    if body.ratio is not None:
        words += f"; C gives every mode the damping ratio `{body.ratio}`"
    if body.modes is not None:
        words += f"; `{body.modes}` modes move, and the others answer statically"
    yield line(words, (left, right))
    for c, contact in enumerate(contacts.each):
        picked = sp.Symbol(f"{picks[c]}'", commutative=False) * q(t)
        words = f"displacement of {contact.name}, which `{picks[c]}` picks"
        yield line(words, (notation.displacement(c, 0, t), picked))


def laws_of(notation: Notation, p: int) -> Iterator[Equation]:
    """Yield the law of each contact in phase `p`."""
    phase = notation.scene.cell[p]
    for name, law in zip(body_of(notation.scene).at, phase.laws, strict=True):
        left, right, _ = balanced(at_state(notation, law, t))
        yield line(f"law at {name} in {phase.name}", (left, right), notation.during(p))


def returning(notation: Notation, p: int) -> Equation:
    """Return the law that is solved for a contact held in phase `p`, which returns to it."""
    phase = notation.scene.phases[p]
    law = state(2, t) + RATE * (state(1, t) - sp.sympify(phase.held))
    words = f"law that is solved in {phase.name}: the same from that velocity on"
    return line(words, (law, sp.Integer(0)), notation.during(p))


def rate(notation: Notation) -> Iterator[Equation]:
    """Yield the rate in that law, if a contact is held in any phase."""
    if any(phase.held is not None for phase in notation.scene.phases):
        value = notation.scene.frequency or 1 / sp.Symbol("t_unit")
        words = "rate at which a held contact returns to its velocity"
        yield line(words, (RATE, value))


def velocities(notation: Notation, p: int) -> Iterator[Equation]:
    """Yield the velocity after the end of phase `p` of each contact with an impulse."""
    scene, contacts = notation.scene, Contacts(notation.scene)
    _, sign = scene.after(p)
    for c, law in contacts.impulses(p):
        sides = (notation.side(p + 1, side) for side in "-+")
        before, after = (notation.displacement(c, 1, time) for time in sides)
        value = sign * law.subs(contacts.each[c].v, before)
        words = f"velocity of {contacts.each[c].name} where {scene.phases[p].name} ends"
        yield line(words, (after, value))
