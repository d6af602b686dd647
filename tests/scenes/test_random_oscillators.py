"""Random oscillators of every scene: what is found closes, what simulations find is found."""

import math

import numpy as np
import pytest
from one_mass import NAMES

import nonsmooth as ns
from nonsmooth.solver.kernels import registry
from nonsmooth.solver.orbit.exact_orbit import ExactOrbit
from nonsmooth.solver.simulation.machine import Machine
from nonsmooth.solver.simulation.outcome import outcome_of
from nonsmooth.solver.simulation.record import Simulation
from nonsmooth.solver.simulation.simulate import cycle
from nonsmooth.solver.simulation.steps.state import State
from nonsmooth.solver.simulation.walk import Place, follow, walk

#: Oscillators in every run, and in a block of the long one; blocks of that.
FEW, MANY, BLOCKS = 16, 100, 20

#: Simulations from random states, and their cycles; in every run, and in the long one.
SHORT, LONG = (1, 40), (12, 100)

#: Orders of the expansion; the second is for phases of ten waves.
ORDERS = (24, 60)

#: Phases of one of them, at most.
PHASES = 1000

#: Decades about the default that a parameter is drawn from; those below it of small ones.
DECADES, SMALL = 0.7, (1.0, 8.0)

#: Parameters that are drawn small in a third of all cases.
OFTEN_SMALL = ("gap", "damping")

#: How far a simulated orbit may end from its start, as a part of its size, for each unit that
#: the period makes of a perturbation.
CLOSES = 1e-8


def drawn(random):
    """Return a case of any scene, or None where its parameters are refused."""
    scene = registry.load(str(random.choice(NAMES)))
    values = {}
    for parameter in scene.parameters:
        value = parameter.default * 10 ** random.uniform(-DECADES, DECADES)
        if parameter.name in OFTEN_SMALL and random.random() < 1 / 3:
            value = parameter.default * 10 ** -random.uniform(*SMALL)
        if parameter.name == "gap" and not parameter.bound and random.random() < 0.3:
            value = random.choice([0.0, -value])
        values[parameter.name] = min(value, parameter.most or math.inf)
    try:
        return scene(**values)
    except ValueError:
        return None


def closes(orbit: ExactOrbit) -> bool:
    """Return whether a simulation from within the first phase comes back to its start."""
    case, u = orbit.case, np.array([0.37])
    s = float(orbit.cell_durations[0]) * u[0]
    x, v = (float(orbit.part(0, u, j)[0]) for j in (0, 1))
    machine = Machine(case.cell)
    start = State(x, v, orbit.angle + case.cell.omega * s, memory=orbit.memory_values)
    assert machine.begin(start) is not None
    total = float(np.sum(orbit.cell_durations)) * case.cell.cells
    motion = follow(case, machine, start, total)
    names = [q.phase.name for q in motion.segments]
    cell = [phase.name for phase in case.cell.phases] * case.cell.cells
    last = motion.segments[-1]
    end = [float(last.motion(np.array([last.s]), case.cell.omega, j)[0]) for j in (0, 1)]
    grown = 1 + float(np.abs(orbit.multipliers).max(initial=0.0))
    sizes = orbit.sizes.max(axis=0)
    near = max(abs(end[0] - x) / sizes[0], abs(end[1] - v) / sizes[1]) <= CLOSES * grown
    return near and names == [*cell, cell[0]] and not motion.ended


def settles(case, random, simulations, cycles) -> bool:
    """Return whether simulations from random states come to a declared order of phases."""
    for each in case.each_motion:
        machine = Machine(each.cell)
        for _ in range(simulations):
            start = machine.remembered(
                State(*random.normal(0, 1, 2), random.uniform(0, 2 * math.pi))
            )
            if machine.begin(start) is None:
                continue
            until = cycles * cycle(each.cell)
            segments, _, ended, _ = walk(
                each, machine, Place.first(machine, start), until, PHASES
            )
            motion = Simulation(each, tuple(segments), ended)
            if outcome_of(each.cell, motion).times is not None:
                return True
    return False


def solved(case):
    """Return the orbit at the lowest order that has it, or that there is none."""
    for order in ORDERS:
        try:
            return ns.solve(case, method="ck-tau", order=order)
        except ns.NoOrbit as finding:
            found = finding
            if found.status == "no-orbit":
                break
    return found


def check(seed, simulations, cycles) -> str:
    """Return what is wrong with what is found of one oscillator, if something is."""
    random = np.random.default_rng(seed)
    case = drawn(random)
    if case is None:
        return ""
    orbit = solved(case)
    if isinstance(orbit, ns.NoOrbit):
        if settles(case, random, simulations, cycles):
            return f"{case!r}: a simulation settles where there is {orbit.status}"
        return ""
    assert math.isfinite(orbit.estimate.times)
    exact = orbit.exact
    return "" if exact is None or closes(exact) else f"{case!r}: the simulation does not close"


def test_some_random_oscillators():
    found = [check([1, seed], *SHORT) for seed in range(FEW)]
    assert [wrong for wrong in found if wrong] == []


@pytest.mark.long
@pytest.mark.parametrize("block", range(BLOCKS))
def test_many_random_oscillators(block):
    found = [check([2, block, seed], *LONG) for seed in range(MANY)]
    assert [wrong for wrong in found if wrong] == []
