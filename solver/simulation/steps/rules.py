"""The phases of a cell, their event functions and their possible successors, as arrays."""

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from ...arrays import Integers, Matrix
from ...scenes.cell import Cell, Form, Memory
from ..nodes import Node, ending, followers, turns, walls
from .column import NONE


class Rules(NamedTuple):
    """The phases that a motion of a cell can be in, and the surfaces that end them, in arrays.

    Parameters
    ----------
    omega : float
        Frequency of the forcing.
    phases : ndarray, shape (P, 8 + M)
        For each phase: equation, speed, law, and coefficients of the memory in its force; see
        `column`.  For a body its `Phases` instead.
    kinds : ndarray of int, shape (P, 7)
        For each phase: whether it is held; whether its event is none of its demands; if it is a
        rest at a place, the phase whose jump it follows; the number of its law, if demands and
        events alone decide what follows.  Then three rows of `forms`: of its event, which its
        demands follow; the first demand at its switch; and the end of those.
    forms : ndarray, shape (F, 4 + M)
        Coefficients of ``x, v, cos, 1, memory``.  For a body of ``Y``; see `Phases`.
    surfaces : ndarray of int, shape (F,)
        The surface on which each form vanishes; `NONE` for a demand at a switch.
    endings : ndarray of int, shape (P, S)
        For each phase and surface: the phase of the same equation whose event is that surface.
    declared : ndarray of int, shape (P + 1, D)
        Row p: the phases declared to follow phase p, behind them `NONE`; last row: none.  The
        demands at the switch are those of the first.
    turns : ndarray of int, shape (P + 1, P)
        Row p: the order in which successors are tried where the event of phase p has ended it;
        last row: where another has.  Constraints come first: they hold while they can.  `NONE`
        stands for a phase that cannot follow, as the event says which does.
    setting : ndarray of int, shape (P + 1, P, M)
        Whether a phase sets each memory behind another one; last row: behind none.
    memory : ndarray, shape (P + 1, P, M, 4)
        The form to whose value it is set.  For a body the forms are longer.
    """

    omega: float
    phases: Any
    kinds: Integers
    forms: Matrix
    surfaces: Integers
    endings: Integers
    declared: Integers
    turns: Integers
    setting: Integers
    memory: Matrix


def rules_of(cell: Cell, nodes: Sequence[Node]) -> Rules:
    """Return the rules of a cell from the phases that its motion can be in."""
    phases, count = range(len(nodes)), len(cell.memory)
    declared = followers(cell, nodes)
    numbers, kinds, behind = [], [], walls(nodes, declared)
    laws = list(dict.fromkeys(node.law for node in nodes))
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
        numbers.append([*own, *(phase.memory or [0.0] * count)])
        law, rows = laws.index(node.law) if cell.to else NONE, (row, at_switch, len(forms))
        kinds.append([phase.held, node.event not in node.demands, behind[p], law, *rows])
    most = max(map(len, declared))
    width = max(4, *(len(form) - count for form in forms))
    return Rules(
        cell.omega,
        np.array(numbers, dtype=float),
        np.array(kinds, dtype=np.int64),
        np.array([[*form, *[0.0] * count][: width + count] for form in forms], dtype=float),
        np.array(surfaces, dtype=np.int64),
        np.array([[ending(nodes, p, q) for q in range(max(surfaces) + 1)] for p in phases]),
        np.array([[*some, *[NONE] * most][:most] for some in (*declared, ())]),
        np.array(turns(cell, nodes, declared)),
        *_memories(cell.memory, nodes, width),
    )


def _memories(
    memories: Sequence[Memory], nodes: Sequence[Node], width: int
) -> tuple[Integers, Matrix]:
    """Return `setting` and `memory` of `Rules`."""
    count = len(nodes)
    setting = np.zeros((count + 1, count, len(memories)), dtype=np.int64)
    forms = np.zeros((*setting.shape, width))
    for i, each in enumerate(memories):
        within = [p for p, node in enumerate(nodes) if node.index in each.within]
        for p, node in enumerate(nodes):
            if node.index == each.phase:
                x, v, cos, constant, *others = each.value[:width]
                setting[:, p, i] = 1
                forms[:, p, i] = x, v, cos, -constant if node.mirrored else constant, *others
            if within and p not in within:
                setting[p, within, i] = 1
                forms[p, within, i] = node.phase.lawful(each.value)[:width]
    return setting, forms
