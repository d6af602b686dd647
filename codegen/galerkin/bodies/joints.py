"""The conditions that join the phases of a body: impulses, events, memories, the period."""

from collections.abc import Callable, Iterator, Sequence

import sympy as sp

from ...scene import Scene
from .. import closure
from ..condition import Block, Condition, Times
from .contacts import Contacts, dot

#: ``seen(phase, at_end)``: the signals of forms at the begin or end, with zero forces.
Seen = Callable[[int, bool], Sequence[sp.Expr]]


def impulse(contacts: Contacts, p: int, c: int) -> sp.Symbol:
    """Return the symbol of the impulse at contact `c` where phase `p` ends."""
    word = contacts.scene.phases[p].name
    return sp.Symbol(contacts.name("J", c, word=word), real=True)


def blocks(scene: Scene) -> Iterator[Block]:
    """Yield the unknowns besides those of the forces: impulses and memories."""
    contacts = Contacts(scene)
    for p, phase in enumerate(scene.phases):
        for c, _ in contacts.impulses(p):
            what = f"impulse at {contacts.each[c].name} where {phase.name} ends"
            yield Block(impulse(contacts, p, c), sp.Integer(1), what)
    yield from closure.memory_blocks(scene)


def conditions(scene: Scene, times: Times, seen: Seen) -> Iterator[Condition]:
    """Yield the conditions of impulses, memories, events and the period."""
    contacts = Contacts(scene)
    for p, phase in enumerate(scene.phases):
        hit, velocities = dict(contacts.impulses(p)), seen(p, True)
        after = scene.phases[scene.after(p)[0]]
        for c, law in hit.items():
            contact, row = contacts.each[c], contacts.form(law - contacts.each[c].v)
            push = sp.Add(
                *(
                    contacts.whole(c, d, after.held is not None) * impulse(contacts, p, d)
                    for d in hit
                )
            )
            title = f"the impulse at {contact.name} where {phase.name} ends"
            name = f"impulse_{contact.name}_{phase.name}"
            yield Condition(name, title, push - sp.expand_mul(dot(row, velocities)))
    for q in scene.memory:
        row = contacts.form(q.value, memory=False)
        at = seen(scene.setting(q), False)[: len(row)]
        title = f"{q.symbol} is set where {q.at} begins"
        yield Condition(f"memory_{q.symbol}", title, q.symbol - dot(row, at))
    for p, phase in enumerate(scene.cell):
        signals = seen(p, True)
        with_forces = contacts.forced(signals, contacts.by_law(p, signals))
        title = f"the event that ends {phase.name}, its force by the law there"
        expression = dot(contacts.form(phase.ends.zero), with_forces)
        yield Condition(f"event_{phase.name}", title, expression)
    yield from closure.period(times)
