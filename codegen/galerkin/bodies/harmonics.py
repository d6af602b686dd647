"""Harmonics of the contact forces: the body answers by its dynamic compliance.

A harmonic of a force is that of what the laws of the phases make of the state: so there is a
row for each.  Beside the harmonics there may be functions ``beta_n`` with breaks at the
switches, as in ``codegen/expansions/hb_ck.py``; to these and to impulses the poles answer in
closed form.
"""

from collections.abc import Iterator

import sympy as sp

from ...scene import Scene
from ..condition import Block, BodyConditions, Condition, Table, cycles, phi
from . import joints
from .tables import tables
from .terms import Function, T, Terms, beta, m, n, omega_0, t


def derive(scene: Scene, method: str, title: str, functions: int = 0) -> BodyConditions:
    """Return the conditions of a body whose forces have harmonics, and functions beside."""
    own = Terms(scene, functions)
    rows = (
        *(galerkin(own, c) for c in range(own.count)),
        *(jump(own, q) for q in own.functions),
        *joints.conditions(scene, own.times, own.seen),
    )
    found = tuple(blocks(own)), own.times, rows, tuple(expansion(own)), tuple(tables(own))
    return BodyConditions(scene, method, title, *found)


def blocks(own: Terms) -> Iterator[Block]:
    """Yield the unknowns."""
    first, last = own.limits
    for c, contact in enumerate(own.contacts.each):
        what = f"harmonics of the force at {contact.name}, those below 0 conjugate"
        yield Block(own.force(c), last - first + 1, what)
    for q in own.functions:
        at = own.scene.phases[q.phase].name
        what = f"of beta_{q.n} of the switch to {at}"
        yield Block(own.factor(q), sp.Integer(1), what)
    yield from joints.blocks(own.scene)


def expansion(own: Terms) -> Iterator[Table]:
    """Yield what the forces are."""
    for c, contact in enumerate(own.contacts.each):
        wave = sp.exp(sp.I * own.times.harmonic(n) * omega_0 * t)
        total = sp.Sum(own.force(c)[n] * wave, (n, *own.limits))
        for q in own.functions:
            if q.contact == c:
                age = (t - own.times.start(q.phase)) / own.cell
                total += own.factor(q) * beta(q.n, age)
        entry = sp.Function(own.contacts.name("f", c))(t)
        yield Table(entry, f"force at {contact.name}", (total,))
    yield Table(omega_0, "frequency", (2 * sp.pi / T,))


def galerkin(own: Terms, c: int) -> Condition:
    """Return that each harmonic of a force is that of what the laws make of the state."""
    row = own.force(c)[m]
    for p in own.phases:
        mean = own.table("I", phase=p)
        by_force = (
            own.table("G", c, d, phase=p)[n] * own.force(d)[n] for d in range(own.count)
        )
        product = sp.Add(*by_force) * mean[own.times.harmonic(n) - own.times.harmonic(m)]
        row -= sp.Sum(product, (n, *own.limits)) if not own.contacts.is_given(p) else 0
        row -= own.constant(p)[c] * mean[-own.times.harmonic(m)]
        driven = own.driven(p)[c] * sp.exp(sp.I * phi) / 2
        if driven != 0:
            row -= driven * mean[cycles - own.times.harmonic(m)]
            row -= sp.conjugate(driven) * mean[-cycles - own.times.harmonic(m)]
        if own.has_breaks and not own.contacts.is_given(p):
            row -= own.table("B", c, phase=p)[m]
    for q in own.functions:
        if q.contact == c:
            row += own.factor(q) * own.table("b", phase=q.phase)[q.n, m]
    first, last = own.limits
    title = f"harmonics of the force at {own.contacts.each[c].name}: those of the laws"
    name = f"harmonic_{own.contacts.each[c].name}"
    return Condition(name, title, row, m, first, last - first + 1)


def jump(own: Terms, q: Function) -> Condition:
    """Return the condition of a function: the jump that the laws make."""
    p = q.phase
    left, sign = (p - 1, 1) if p else (len(own.phases) - 1, own.times.sign)
    after = own.law(p, False, q.n - 1)[q.contact]
    before = own.law(left, True, q.n - 1)[q.contact]
    contact, phase = own.contacts.each[q.contact].name, own.scene.phases[p].name
    return Condition(
        f"jump_{q.n - 1}_{contact}_{phase}",
        f"jump of derivative {q.n - 1} of the force at {contact} where {phase} begins",
        own.factor(q) - own.cell ** (q.n - 1) * (after - sign * before),
    )
