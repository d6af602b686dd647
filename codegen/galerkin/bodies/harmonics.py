"""Harmonics of the contact forces, with the dynamic compliance of the body.

Each row says that a harmonic of a force is the same harmonic of its law, phase by phase.
Functions ``beta_n`` with breaks at the switches may be added, as in
``codegen/expansions/hb_ck.py``.  The responses of poles to these and to impulses are closed
forms.
"""

from collections.abc import Iterator

import sympy as sp

from ...scene import Scene
from ...system import Equation, line
from ..condition import Block, BodyConditions, Condition, cycles, phi
from . import joints
from .tables import tables
from .terms import Function, T, Terms, beta, m, n, omega_0, t


def derive(scene: Scene, method: str, title: str, functions: int = 0) -> BodyConditions:
    """Return the conditions of a body whose forces are harmonics and functions with breaks."""
    terms = Terms(scene, functions)
    rows = (
        *(galerkin(terms, c) for c in range(terms.count)),
        *(jump(terms, q) for q in terms.functions),
        *joints.conditions(scene, terms.times, terms.seen),
    )
    fields = (
        tuple(blocks(terms)),
        terms.times,
        rows,
        tuple(expansion(terms)),
        tuple(tables(terms)),
    )
    return BodyConditions(scene, method, title, *fields)


def blocks(terms: Terms) -> Iterator[Block]:
    """Yield the unknown coefficients."""
    first, last = terms.limits
    for c, contact in enumerate(terms.contacts.each):
        what = f"harmonics of the force at {contact.name}, those below 0 conjugate"
        yield Block(terms.force(c), last - first + 1, what)
    for q in terms.functions:
        at = terms.scene.phases[q.phase].name
        what = f"of beta_{q.n} of the switch to {at}"
        yield Block(terms.factor(q), sp.Integer(1), what)
    yield from joints.blocks(terms.scene)


def expansion(terms: Terms) -> Iterator[Equation]:
    """Yield the expansions of the forces."""
    for c, contact in enumerate(terms.contacts.each):
        wave = sp.exp(sp.I * terms.times.harmonic(n) * omega_0 * t)
        total = sp.Sum(terms.force(c)[n] * wave, (n, *terms.limits))
        for q in terms.functions:
            if q.contact == c:
                age = (t - terms.times.start(q.phase)) / terms.cell
                total += terms.factor(q) * beta(q.n, age)
        entry = sp.Function(terms.contacts.name("f", c))(t)
        yield line(f"force at {contact.name}", (entry, total))
    yield line("frequency", (omega_0, 2 * sp.pi / T))


def galerkin(terms: Terms, c: int) -> Condition:
    """Return the condition that each harmonic of force `c` is that of its laws."""
    row = terms.force(c)[m]
    for p in terms.phases:
        mean = terms.table("I", phase=p)
        by_force = (
            terms.table("G", c, d, phase=p)[n] * terms.force(d)[n] for d in range(terms.count)
        )
        product = sp.Add(*by_force) * mean[terms.times.harmonic(n) - terms.times.harmonic(m)]
        row -= sp.Sum(product, (n, *terms.limits)) if not terms.contacts.is_given(p) else 0
        row -= terms.constant(p)[c] * mean[-terms.times.harmonic(m)]
        driven = terms.driven(p)[c] * sp.exp(sp.I * phi) / 2
        if driven != 0:
            row -= driven * mean[cycles - terms.times.harmonic(m)]
            row -= sp.conjugate(driven) * mean[-cycles - terms.times.harmonic(m)]
        if terms.has_breaks and not terms.contacts.is_given(p):
            row -= terms.table("B", c, phase=p)[m]
    for q in terms.functions:
        if q.contact == c:
            row += terms.factor(q) * terms.table("b", phase=q.phase)[q.n, m]
    first, last = terms.limits
    title = f"harmonics of the force at {terms.contacts.each[c].name}: those of the laws"
    name = f"harmonic_{terms.contacts.each[c].name}"
    return Condition(name, title, row, m, first, last - first + 1)


def jump(terms: Terms, q: Function) -> Condition:
    """Return the condition of a function with a break: its jump is that of the laws."""
    p = q.phase
    left, sign = terms.scene.before(p)
    after = terms.law(p, False, q.n - 1)[q.contact]
    before = terms.law(left, True, q.n - 1)[q.contact]
    contact, phase = terms.contacts.each[q.contact].name, terms.scene.phases[p].name
    return Condition(
        f"jump_{q.n - 1}_{contact}_{phase}",
        f"jump of derivative {q.n - 1} of the force at {contact} where {phase} begins",
        terms.factor(q) - terms.cell ** (q.n - 1) * (after - sign * before),
    )
