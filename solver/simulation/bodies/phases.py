"""The phases of a body as arrays: poles, contacts, and linear forms.

P phases, c contacts, n entries of y, W of ``Y = (y, cos, sin, 1, memory)``, F forms.  In each
phase y is the real part of `bases` by m poles at most, one of each pair; see `bodies.flow`.
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from ...arrays import Complex, Indices, Integers, Matrix, Vector
from ...bodies.switch import impulses_of
from ...scenes.bodies.cell import BodyCell
from ..nodes import Node
from ..steps import column
from ..steps.rules import Rules, rules_of
from .regime import Regime

#: How many derivatives of a form by time are examined.
TERMS = 6

#: Distance of a pole from its drive below which it is near, relative to the frequency of the
#: forcing or, without one, to the fastest pole.
REACH, UNFORCED = 0.25, 1e-6

#: Value of `Laws.hit` where not exactly one contact jumps at a wall at rest.
NO_CONTACT = -1


class Poles(NamedTuple):
    """The poles of each phase.

    Parameters
    ----------
    counts, free : ndarray of int, shape (P,)
        The numbers of poles and of rigid-body modes.
    values : ndarray of complex, shape (P, m)
    bases, inverses : ndarray of complex, shape (P, n, m), (P, m, n)
    inputs : ndarray of complex, shape (P, m, W - n)
        What drives each pole: factors of cos, sin, 1, memory.
    apart : ndarray of complex, shape (P, 3, m)
        ``q - s`` of each pole s for q of ``e^(i Omega t), e^(-i Omega t), 1``; 1 for 0.
    least : ndarray, shape (P, m)
        The distance of each pole from the nearest frequency that drives it.
    near : ndarray of bool, shape (P, m)
        Whether that is too small for a steady answer.
    window, growth : ndarray, shape (P,)
        A time in which a motion has few extremes; the largest growth rate.
    """

    counts: Integers
    free: Integers
    values: Complex
    bases: Complex
    inverses: Complex
    inputs: Complex
    apart: Complex
    least: Matrix
    near: Indices
    window: Vector
    growth: Vector


class Laws(NamedTuple):
    """Contacts in the phases, and at their switches.

    Parameters
    ----------
    velocity : ndarray, shape (P, c, 3, W)
        Velocity, acceleration and its rate.
    place, rounding : ndarray, shape (P, c, W)
        Displacement; moduli of the terms of the velocity, by the entries of Y.
    variables : ndarray, shape (S, W)
        The variables of forms, without contact forces.
    struck : ndarray, shape (n, c)
        The change of y by impulses.
    switching, holding : ndarray, shape (P, c, W)
        The impulses at the event of a phase, and those that bring a contact to the velocity at
        which it is held.
    jumps, moving, rests : ndarray of bool, shape (P,)
        Whether a velocity jumps at its event; whether the event is of a velocity; whether the
        jump leaves the velocity at which the next phase is held.
    hit : ndarray of int, shape (P,)
        The contact that jumps, if it is one alone and its wall is at rest.
    rho, speed : ndarray, shape (P,)
        The factor of its velocity; the velocity at which a phase is held.
    """

    velocity: Matrix
    place: Matrix
    rounding: Matrix
    variables: Matrix
    struck: Matrix
    switching: Matrix
    holding: Matrix
    jumps: Indices
    moving: Indices
    rests: Indices
    hit: Integers
    rho: Vector
    speed: Vector


class Forms(NamedTuple):
    """Forms, each of one phase.

    Parameters
    ----------
    rates : ndarray, shape (F, TERMS, W)
        The form and its derivatives by time.
    rounding : ndarray, shape (F, TERMS, W)
        The moduli of their terms, by the entries of Y.
    by_poles : ndarray of complex, shape (F, 2, m)
        The form and its slope, by the poles.
    """

    rates: Matrix
    rounding: Matrix
    by_poles: Complex


class Phases(NamedTuple):
    """The phases of a body, and the forms that end them."""

    poles: Poles
    laws: Laws
    forms: Forms


def body_rules_of(cell: BodyCell, nodes: Sequence[Node], regimes: Sequence[Regime]) -> Rules:
    """Return the rules of a cell of a body, whose phases are nodes."""
    rules = rules_of(cell, nodes)
    ends = zip(regimes, rules.kinds[:, column.ROW], rules.kinds[:, column.END], strict=True)
    rows = [rules.forms[a:b] @ regime.part.lawful.rows for regime, a, b in ends]
    phases = Phases(poles_of(regimes), laws_of(regimes), forms_of(regimes, rows))
    return rules._replace(phases=phases, forms=np.vstack(rows))


def poles_of(regimes: Sequence[Regime]) -> Poles:
    """Return the poles of phases."""
    flows = [regime.part.flow.upper for regime in regimes]
    count, n = max(len(q.poles) for q in flows), regimes[0].states
    P, width = len(flows), flows[0].inputs.shape[1]
    values, inputs = np.zeros((P, count), complex), np.zeros((P, count, width), complex)
    bases, inverses = np.zeros((P, n, count), complex), np.zeros((P, count, n), complex)
    for p, q in enumerate(flows):
        columns = slice(0, len(q.poles))
        values[p, columns], bases[p, :, columns] = q.poles, q.basis
        inverses[p, columns], inputs[p, columns] = q.inverse, q.inputs
    omega = flows[0].omega
    apart = 1j * np.array([omega, -omega, 0.0])[:, None] - values[:, None]
    least = np.abs(apart).min(axis=1)
    fastest = np.abs(values).max(axis=1, initial=1.0)
    reach = np.where(omega > 0, REACH * omega, UNFORCED * fastest)
    return Poles(
        np.array([len(q.poles) for q in flows]), np.array([q.free for q in flows]), values,
        bases, inverses, inputs, np.where(apart == 0, 1.0, apart), least,
        least <= reach[:, None], np.array([regime.window for regime in regimes]),
        np.maximum(values.real, 0.0).max(axis=1),
    )  # fmt: skip


def laws_of(regimes: Sequence[Regime]) -> Laws:
    """Return contacts in phases, in the order of their cell."""
    velocity = np.array([_rates(regime, regime.contacts[1], 3) for regime in regimes])
    switching, holding, hit, rho = [], [], [], []
    for regime in regimes:
        phase, body = regime.phase, regime.body
        held = [(0.0, phase.speed)] + [(1.0, 0.0)] * (len(phase.laws) - 1)
        switching.append(_impulses(regime, impulses_of(body.mobility, phase.jumps)))
        holding.append(_impulses(regime, impulses_of(body.kept_mobility, held)))
        jumping = [i for i, jump in enumerate(phase.jumps) if jump != (1.0, 0.0)]
        alone = len(jumping) == 1 and phase.jumps[jumping[0]][1] == 0
        hit.append(jumping[0] if alone else NO_CONTACT)
        rho.append(phase.jumps[jumping[0]][0] if alone else 0.0)
    phases = [regime.phase for regime in regimes]
    speeds = [q.speed for q in phases]
    return Laws(
        velocity,
        np.array([regime.contacts[0] for regime in regimes]),
        np.array([_rounding(regime, regime.contacts[1]) for regime in regimes]),
        regimes[0].free.rows,
        regimes[0].free.B,
        np.array(switching),
        np.array(holding),
        np.array([any(jump != (1.0, 0.0) for jump in q.jumps) for q in phases]),
        np.array([q.event[1] != 0 for q in phases]),
        np.array([
            before.jumps[0] == (0.0, speed)
            for before, speed in zip([phases[-1], *phases[:-1]], speeds, strict=True)
        ]),
        np.array(hit),
        np.array(rho, dtype=float),
        np.array(speeds, dtype=float),
    )  # fmt: skip


@np.errstate(over="ignore", invalid="ignore")  # said of the motion, if it matters
def forms_of(regimes: Sequence[Regime], forms: Sequence[Matrix]) -> Forms:
    """Return the forms of each phase, shape (F, W) each, one behind another."""
    rates, rounding, by_poles = [], [], []
    count = max(len(regime.part.flow.upper.poles) for regime in regimes)
    for regime, rows in zip(regimes, forms, strict=True):
        derivatives, basis = _rates(regime, rows, TERMS), regime.part.flow.upper.basis
        factors = np.zeros((len(rows), 2, count), complex)
        factors[..., : basis.shape[1]] = derivatives[:, :2, : regime.states] @ basis
        rates.append(derivatives)
        errors = [_rounding(regime, derivatives[:, k]) for k in (0, 1)]
        sums = np.abs(derivatives[:, 1:-1]) @ np.abs(regime.generator)
        rounding.append(np.concatenate([np.stack(errors, axis=1), sums], axis=1))
        by_poles.append(factors)
    return Forms(np.concatenate(rates), np.concatenate(rounding), np.concatenate(by_poles))


def _rates(regime: Regime, rows: Matrix, count: int) -> Matrix:
    """Return forms and their derivatives by time; shape (F, count, W)."""
    derivatives = [rows]
    for _ in range(count - 1):
        derivatives.append(derivatives[-1] @ regime.generator)
    return np.stack(derivatives, axis=1)


def _rounding(regime: Regime, rows: Matrix) -> Matrix:
    """Return the moduli of the terms of forms, by the entries of Y.

    The rounding of a place or a velocity is at least that of its change in a unit of time.
    """
    size = np.abs(rows)
    return np.asarray(size + size @ np.abs(regime.generator))


def _impulses(regime: Regime, law: tuple[Matrix, Matrix]) -> Matrix:
    """Return impulses as forms of Y, from those by contact velocities and a constant."""
    by_velocity, constant = law
    forms = by_velocity @ regime.contacts[1]
    forms[:, regime.states + 2] += constant
    return np.asarray(forms)
