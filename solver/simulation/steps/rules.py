"""The phases that a motion can be in as arrays, and which may follow which: once for a cell."""

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from ...arrays import Integers, Matrix
from ...scenes.cell import Cell, Form
from ..nodes import Node, ending, turns, walls
from .column import NONE


class Rules(NamedTuple):
    """The phases of a cell as a motion can be in them, and the surfaces that end them.

    Parameters
    ----------
    omega : float
        Of the forcing.
    phases : ndarray, shape (P, 8 + M)
        Of each phase: equation, speed, law, and factors of the memory in its force.  Of a body
        in their place its `Phases`.
    kinds : ndarray of int, shape (P, 8)
        Of each phase: whether it is held; whether its event is none of its demands; behind the
        jump of which it is a rest at a place; its place in the cell; -1 if it is mirrored.
        Then in `forms` the row of its event, before its demands; the first row of what it
        demands at its switch; and the one behind them.
    forms : ndarray, shape (F, 4 + M)
        By ``x, v, cos, 1, memory``.  Of a body by its ``Y``; see `Phases`.
    surfaces : ndarray of int, shape (F,)
        On which each vanishes.
    endings : ndarray of int, shape (P, S)
        The phase of the same equation whose event is a surface, for each phase and surface.
    turns : ndarray of int, shape (P + 1, P)
        In which turn phases are tried where one is declared, or at last none: constraints hold
        while they can.
    setting, memory : ndarray, shape (M,), (M, 4)
        As in `Arrays`.  Of a body the forms are longer.
    """

    omega: float
    phases: Any
    kinds: Integers
    forms: Matrix
    surfaces: Integers
    endings: Integers
    turns: Integers
    setting: Integers
    memory: Matrix


def rules_of(cell: Cell, nodes: Sequence[Node]) -> Rules:
    """Return the rules of a cell, whose phases are nodes."""
    phases, more = range(len(nodes)), len(cell.memory)
    numbers, kinds, behind = [], [], walls(nodes)
    forms: list[Form] = []
    surfaces: list[int] = []
    for p, node in enumerate(nodes):
        phase, row = node.phase, len(forms)
        forms += [phase.event, *(form for _, form in phase.demands)]
        surfaces += [node.event, *node.demands]
        at_switch = len(forms)
        forms += [form for _, form in phase.switch_demands]
        surfaces += [NONE] * len(phase.switch_demands)
        own = phase.m, phase.c, phase.k, phase.f, phase.g, phase.speed, phase.rho, phase.d
        numbers.append([*own, *(phase.memory or [0.0] * more)])
        place = behind[p], node.index, -1 if node.mirrored else 1
        rows = row, at_switch, len(forms)
        kinds.append([phase.held, node.event not in node.demands, *place, *rows])
    width = max(4, *(len(form) - more for form in forms))
    return Rules(
        cell.omega,
        np.array(numbers, dtype=float),
        np.array(kinds, dtype=np.int64),
        np.array([[*form, *[0.0] * more][: width + more] for form in forms], dtype=float),
        np.array(surfaces, dtype=np.int64),
        np.array([[ending(nodes, p, q) for q in range(max(surfaces) + 1)] for p in phases]),
        np.array(turns(nodes)),
        np.array([each.phase for each in cell.memory], dtype=np.int64),
        np.array([each.value[:width] for each in cell.memory], dtype=float).reshape(-1, width),
    )
