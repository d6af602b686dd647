"""The phases of a body as arrays: its poles in each, its contacts, and forms by both.

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

#: Derivatives of a form by time that are looked at.
TERMS = 6

#: How near to a drive a pole has no parts of its own, as a part of the frequency of the
#: forcing; where nothing forces, of the fastest pole.
REACH, UNFORCED = 0.25, 1e-6

#: Of `Laws.hit`: no contact alone is hit by a wall at rest.
NO_CONTACT = -1


class Poles(NamedTuple):
    """The poles of each phase.

    Parameters
    ----------
    counts, free : ndarray of int, shape (P,)
        How many there are, and in how many ways nothing holds the body.
    values : ndarray of complex, shape (P, m)
    bases, inverses : ndarray of complex, shape (P, n, m), (P, m, n)
    inputs : ndarray of complex, shape (P, m, W - n)
        What drives each, by cos, sin, 1, memory.
    apart : ndarray of complex, shape (P, 3, m)
        ``q - s`` of each pole s for q of ``e^(i Omega t), e^(-i Omega t), 1``; 1 for 0.
    least : ndarray, shape (P, m)
        How far each is from what drives it.
    near : ndarray of bool, shape (P, m)
        Which have no parts of their own.
    window, growth : ndarray, shape (P,)
        A time in which a motion does not turn often; the largest rate at which one grows.
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
    """What phases and their switches make of contacts.

    Parameters
    ----------
    velocity : ndarray, shape (P, c, 3, W)
        Velocity, acceleration and its rate.
    place, rounding : ndarray, shape (P, c, W)
        Displacement; what the velocity is a sum of, by the size of Y.
    seen : ndarray, shape (S, W)
        What forms are of, the contact forces left out.
    struck : ndarray, shape (n, c)
        What impulses add to y.
    switching, holding : ndarray, shape (P, c, W)
        The impulses at the event of a phase, and those that give it the velocity at which it is
        held.
    jumps, moving, rests : ndarray of bool, shape (P,)
        Whether a velocity jumps at its event, the event is of a velocity, and the jump leaves
        the velocity of the phase behind it.
    hit : ndarray of int, shape (P,)
        The contact that jumps, if it is one alone and its wall is at rest.
    rho, speed : ndarray, shape (P,)
        What of its velocity is left; that at which a phase is held.
    """

    velocity: Matrix
    place: Matrix
    rounding: Matrix
    seen: Matrix
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
        What they are sums of, by the size of Y.
    by_poles : ndarray of complex, shape (F, 2, m)
        The same two by the poles.
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
    own = rules_of(cell, nodes)
    ends = zip(regimes, own.kinds[:, column.ROW], own.kinds[:, column.END], strict=True)
    rows = [own.forms[a:b] @ regime.part.lawful.rows for regime, a, b in ends]
    phases = Phases(poles_of(regimes), laws_of(regimes), forms_of(regimes, rows))
    return own._replace(phases=phases, forms=np.vstack(rows))


def poles_of(regimes: Sequence[Regime]) -> Poles:
    """Return the poles of phases."""
    flows = [each.part.flow.upper for each in regimes]
    count, n = max(len(q.poles) for q in flows), regimes[0].states
    P, more = len(flows), flows[0].inputs.shape[1]
    values, inputs = np.zeros((P, count), complex), np.zeros((P, count, more), complex)
    bases, inverses = np.zeros((P, n, count), complex), np.zeros((P, count, n), complex)
    for p, q in enumerate(flows):
        own = slice(0, len(q.poles))
        values[p, own], bases[p, :, own] = q.poles, q.basis
        inverses[p, own], inputs[p, own] = q.inverse, q.inputs
    omega = flows[0].omega
    apart = 1j * np.array([omega, -omega, 0.0])[:, None] - values[:, None]
    least = np.abs(apart).min(axis=1)
    fastest = np.abs(values).max(axis=1, initial=1.0)
    reach = np.where(omega > 0, REACH * omega, UNFORCED * fastest)
    return Poles(
        np.array([len(q.poles) for q in flows]), np.array([q.free for q in flows]), values,
        bases, inverses, inputs, np.where(apart == 0, 1.0, apart), least,
        least <= reach[:, None], np.array([each.window for each in regimes]),
        np.maximum(values.real, 0.0).max(axis=1),
    )  # fmt: skip


def laws_of(regimes: Sequence[Regime]) -> Laws:
    """Return what phases, in the order of their cell, make of contacts."""
    velocity = np.array([_rates(each, each.contacts[1], 3) for each in regimes])
    switching, holding, hit, rho = [], [], [], []
    for each in regimes:
        phase, body = each.phase, each.body
        held = [(0.0, phase.speed)] + [(1.0, 0.0)] * (len(phase.laws) - 1)
        switching.append(_impulses(each, impulses_of(body.mobility, phase.jumps)))
        holding.append(_impulses(each, impulses_of(body.kept_mobility, held)))
        jumping = [i for i, jump in enumerate(phase.jumps) if jump != (1.0, 0.0)]
        alone = len(jumping) == 1 and phase.jumps[jumping[0]][1] == 0
        hit.append(jumping[0] if alone else NO_CONTACT)
        rho.append(phase.jumps[jumping[0]][0] if alone else 0.0)
    phases = [each.phase for each in regimes]
    speeds = [q.speed for q in phases]
    return Laws(
        velocity,
        np.array([each.contacts[0] for each in regimes]),
        np.array([_rounding(each, each.contacts[1]) for each in regimes]),
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


def forms_of(regimes: Sequence[Regime], forms: Sequence[Matrix]) -> Forms:
    """Return the forms of each phase, shape (F, W) each, one behind another."""
    rates, rounding, by_poles = [], [], []
    count = max(len(each.part.flow.upper.poles) for each in regimes)
    for each, rows in zip(regimes, forms, strict=True):
        own, basis = _rates(each, rows, TERMS), each.part.flow.upper.basis
        seen = np.zeros((len(rows), 2, count), complex)
        seen[..., : basis.shape[1]] = own[:, :2, : each.states] @ basis
        rates.append(own)
        known = [_rounding(each, own[:, k]) for k in (0, 1)]
        sums = np.abs(own[:, 1:-1]) @ np.abs(each.generator)
        rounding.append(np.concatenate([np.stack(known, axis=1), sums], axis=1))
        by_poles.append(seen)
    return Forms(np.concatenate(rates), np.concatenate(rounding), np.concatenate(by_poles))


def _rates(regime: Regime, rows: Matrix, count: int) -> Matrix:
    """Return forms and their derivatives by time; shape (F, count, W)."""
    found = [rows]
    for _ in range(count - 1):
        found.append(found[-1] @ regime.generator)
    return np.stack(found, axis=1)


def _rounding(regime: Regime, rows: Matrix) -> Matrix:
    """Return what forms are sums of, by the size of Y.

    Places and velocities are known to the rounding of their way in a unit of time, also where
    they are 0.
    """
    size = np.abs(rows)
    return np.asarray(size + size @ np.abs(regime.generator))


def _impulses(regime: Regime, law: tuple[Matrix, Matrix]) -> Matrix:
    """Return impulses by Y, from those by the velocities of the contacts and a constant."""
    by_velocity, constant = law
    found = by_velocity @ regime.contacts[1]
    found[:, regime.states + 2] += constant
    return np.asarray(found)
