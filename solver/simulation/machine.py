"""The phases of a cell of one mass: rules as arrays, run by plain or compiled functions."""

import math
from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from types import ModuleType
from typing import Any, ClassVar

import numpy as np

from ..arrays import Integers, Matrix
from ..flow import divided, responses
from ..kernels import linking
from ..kernels.family import Family
from ..scenes.cell import Cell
from ..scenes.classes import generator
from ..scenes.orders import Step
from .lasting import lasts
from .nodes import InState, Node, nodes
from .segment import Segment
from .steps import (
    bounds,
    chatter,
    clock,
    column,
    locate,
    rules,
    run,
    state,
    step,
    switches,
    zeros,
)
from .steps.clock import Clock
from .steps.column import AT_SWITCH, NONE, ROW
from .steps.rules import Rules, rules_of
from .steps.state import AnyState, State
from .steps.step import Passed

#: Velocities from which `settle` simulates, relative to one that reaches all surfaces, about.
THROWN = 1.5, -1.5, 4.0, -4.0

#: The frequency by which it is reached without a forcing, without units.
ALONE = 2.5

#: Most phases that compiled functions follow at once.
AT_ONCE = 64

#: Distance from a limit, in units of length, at which rest is tried beside it.
ASIDE = 0.1

#: Modules whose functions follow a motion, beside those of the flow in a phase.
PARTS = zeros, bounds, locate, chatter, clock, state, switches, step


def linked(motion: ModuleType, make: linking.Make) -> dict[str, Any]:
    """Return the functions of `step` and `run`, plain or compiled."""
    by_flow = linking.made((divided, responses), {}, make)
    return linking.made((*PARTS, motion), {"state_at": by_flow["state_at"]}, make)


#: The functions, linked as plain Python or compiled once plain ones have cost enough.
FAMILY = Family(linked, (divided, responses, column, rules, *PARTS))


def with_arrays(state: AnyState) -> AnyState:
    """Return a state with arrays in place of sequences, as compiled functions take it."""
    parts = (np.array(part, dtype=float) if np.ndim(part) else part for part in state)
    return type(state)(*parts)


@dataclass(frozen=True)
class Machine:
    """The phases of a cell of one mass, and the rules by which one follows another."""

    cell: Cell
    family: ClassVar[Family] = FAMILY

    @cached_property
    def nodes(self) -> tuple[Node, ...]:
        """The phases that a motion can be in."""
        return nodes(self.cell)

    @cached_property
    def rules(self) -> Rules:
        """The nodes and their switching surfaces as arrays."""
        return rules_of(self.cell, self.nodes)

    def by(self, name: str, *arguments: Any) -> Any:
        """Call a plain function by its name, with the rules and further arguments."""
        return self.family.plain(run.__name__)[name](self.rules, *arguments)

    def number(self, one: Step) -> int:
        """Return the number of a phase, given as a step of an order."""
        return one.phase + len(self.cell.phases) * one.mirrored

    def node(self, one: Step) -> Node:
        """Return the node of a phase, given as a step of an order."""
        return self.nodes[self.number(one)]

    def ending(self, p: int, surface: int) -> Step | None:
        """Return the phase whose event ends phase p on a surface; None if there is none."""
        number = NONE if surface == NONE else self.rules.endings[p, surface]
        return None if number == NONE else self.nodes[number].step

    def begin(self, state: AnyState) -> tuple[int, AnyState] | None:
        """Return the first phase of a motion from a state, and its start; None if none."""
        p = self.by("first_phase", state)
        return None if p == NONE else (p, self.by("begun", p, state))

    def several(
        self, p: int, state: AnyState, clock: Clock, until: Fraction, most: float
    ) -> list[Passed]:
        """Follow a motion from the start of a phase through some phases: see `run.several`.

        In plain Python one at a time, as for a body each may cost seconds.
        """
        high = float(until)
        time = high, float(until - Fraction(high))
        count = AT_ONCE if self.family.account_of(run.__name__, "several").is_compiled else 1
        arguments = self.rules, p, with_arrays(state), clock, time, most, count
        passed: list[Passed] = self.family.call(run.__name__, "several", *arguments)
        return passed

    def lasts(self, segment: Segment) -> bool:
        """Return whether a phase of a motion is proven to last for ever; see `lasting`."""
        omega, s = self.cell.omega, segment.s
        x, v = responses.state_at(segment.phase, segment.x, segment.v, segment.angle, omega, s)
        return lasts(segment.phase, x, v, omega, segment.angle + omega * s)

    def strobed(self, start: AnyState, cycles: int) -> tuple[Matrix, Integers, int]:
        """Return a motion from a state at each whole turn of the forcing: see `run`."""
        arguments = self.rules, with_arrays(start), cycles
        states, phases, how = self.family.call(run.__name__, "run", *arguments)
        return states, phases, how

    def after(self, one: Step, end: AnyState) -> tuple[Node | None, AnyState]:
        """Return what follows `one`, which its event ends in the state `end`, and the state."""
        p = self.number(one)
        end = self.by("begun", p, end)
        behind = self.by("crossed", p, int(self.rules.kinds[p, ROW]), end)
        number = self.by("next_phase", p, self.nodes[p].event, end, behind)
        return None if number == NONE else self.nodes[number], behind

    def undecided(self, p: int, surface: int, behind: AnyState) -> str:
        """Return in words which phases may follow, where neither demands nor events decide.

        Parameters
        ----------
        p, surface : int
            The phase that ended, and where.
        behind : State
            The state behind the switch.
        """
        if not self.cell.to or surface == NONE:
            return ""
        ended = int(self.rules.endings[p, surface])
        found: dict[object, Node] = {}
        for q in self.rules.turns[ended]:
            if self.by("follows", p, ended, int(q), behind):
                found.setdefault(self.nodes[q].law, self.nodes[q])
        names = " or ".join(node.name for node in found.values())
        may = f"where {self.nodes[p].name} ends, {names} may follow"
        return f"{may}: let `to` of its event say which" if len(found) > 1 else ""

    def in_state(self, p: int) -> InState:
        """Return what forms act on, by the state ``(x, x', 1, cos, sin, memory)``."""
        memories = len(self.cell.memory)
        rows = np.eye(4 + memories, 5 + memories, 1)
        rows[:3] = np.eye(5 + memories)[[0, 1, 3]]
        rows[3] = np.eye(5 + memories)[2]
        return InState(rows, generator(self.cell, self.nodes[p].phase, 1), 2)

    def still(self, angle: float) -> AnyState:
        """Return the state at rest with zero displacement."""
        return State(0.0, 0.0, angle)

    def released(self, x: float, v: float, angle: float) -> AnyState:
        """Return the state with a displacement, a velocity and a suitable memory."""
        return self.remembered(State(x, v, angle))

    def at_rest(self, angle: float) -> AnyState | None:
        """Return the admissible state at rest that is nearest to 0."""
        return next((state for state in self.resting(angle) if self.begin(state)), None)

    def resting(self, angle: float) -> Iterator[AnyState]:
        """Yield states at 0 and at or near limits: at rest or at the speed of a held phase."""
        cosine = math.cos(angle)
        places = [0.0]
        for node in self.nodes:
            for x, _, cos, constant, *_ in (form for _, form in node.phase.demands):
                if x:
                    limit = -(constant + cos * cosine) / x
                    places += [limit, limit - ASIDE, limit + ASIDE]
        speeds = [0.0, *(q.phase.speed for q in self.nodes if q.phase.held)]
        for speed in speeds:
            for place in sorted(places, key=abs):
                yield self.released(place, speed, angle)

    def starts(self, angle: float) -> list[AnyState | None]:
        """Return the states from which `settle` simulates: at rest, and in each held phase.

        Without a forcing rest may last: then a unit of length aside, to either side, too.
        """
        still, held = self.still(angle), (p for p, q in enumerate(self.nodes) if q.phase.held)
        begun = (self.by("begun", p, still) for p in held)
        aside = () if self.cell.forced else (self.released(x, 0.0, angle) for x in (1.0, -1.0))
        return [self.at_rest(angle), *map(self.remembered, begun), *aside]

    def thrown(self) -> list[AnyState]:
        """Return states with so much velocity that a mass passes its switching surfaces."""
        events = (node.phase.event for node in self.nodes)
        places = (abs(event[3] / event[0]) for event in events if event[0])
        speed = (self.cell.omega or ALONE) * max([1.0, *places])
        return [self.released(0.0, part * speed, 0.0) for part in THROWN]

    def remembered(self, state: AnyState) -> AnyState:
        """Return a state with a suitable memory, where none is known.

        Each value is the middle of the interval that the demands of a phase admit; where this
        is unbounded, the value that the start of the phase sets.
        """
        count = len(self.cell.memory)
        if not count:
            return state
        state = state._replace(memory=tuple(state.memory) or (0.0,) * count)
        for p in range(len(self.nodes)):
            entered = self.by("entered", NONE, p, state)
            for i in range(count):
                entered = self._in_the_middle(p, entered, i)
            if self.by("admits", p, entered):
                return entered
        return state

    def _in_the_middle(self, p: int, state: AnyState, i: int) -> AnyState:
        """Return a state with memory i in the middle of its admissible interval in a phase."""
        kinds, values = self.rules.kinds[p], list(map(float, state.memory))
        rows = self.rules.forms[kinds[ROW] + 1 : kinds[AT_SWITCH]]
        numbers, place = state.full, i - len(values)
        numbers[place] = 0.0
        factors, rest = rows[:, place], rows @ numbers
        limits = -rest / np.where(factors == 0, 1.0, factors)
        low = limits[factors > 0].max(initial=-np.inf)
        high = limits[factors < 0].min(initial=np.inf)
        if np.isfinite(low) and np.isfinite(high):
            values[i] = float(low + high) / 2
        return state._replace(memory=tuple(values))

    def unmet(self, state: AnyState) -> str:
        """Return in words why no phase admits a state."""
        reasons = []
        for p, q in enumerate(self.nodes):
            local, first = self.by("local_of", p, state), int(self.rules.kinds[p, ROW]) + 1
            demands = enumerate((words for words, _ in q.phase.demands), first)
            words = [w for row, w in demands if self.by("sign_of", local, row, state) < 0]
            if words:
                reasons.append(f"in {q.phase.name} not true that {words[0]}")
            elif q.phase.held:
                reasons.append(f"the velocity or the place is not that of {q.phase.name}")
        return "; ".join(dict.fromkeys(reasons))

    def recorded(self, p: int, state: AnyState, t: Fraction, s: float, surface: int) -> Segment:
        """Return a phase that was followed as a segment of the record."""
        node, memory = self.nodes[p], [float(value) for value in state.memory]
        place = (node.index, node.mirrored, t, state.angle)
        ended = self.ending(p, surface)
        return Segment(node.phase.remembering(memory), *place, state.x, state.v, s, ended)
