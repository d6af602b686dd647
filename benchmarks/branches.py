"""What an orbit of a branch costs, and what a phase of a simulation does, compiled.

    python -m benchmarks.branches

Microseconds, the median of some rounds: of a step along a branch with all that is watched and
its multipliers' map; of an orbit of a whole branch, with its events, rows and multipliers; of a
phase of a simulation without records.  Then of a step along the response of a beam with a stop,
by its modes, and of an orbit of that; and of a point of a map of two parameters, filled in
from orbits that are known on some lines of it.  Behind them ten million additions of a loop in
Python, by which machines can be compared.
"""

import statistics
import time
from collections.abc import Callable

import numpy as np

import nonsmooth as ns
from nonsmooth.solver.branch import walk
from nonsmooth.solver.branch.bodies.course import BODIES
from nonsmooth.solver.branch.branch import start_of
from nonsmooth.solver.branch.walk import FAMILY
from nonsmooth.solver.chart import LINES, planes_of
from nonsmooth.solver.charts import block, filling, lines
from nonsmooth.solver.scenes.case import index_of
from nonsmooth.solver.scenes.ordered import of_all_phases
from nonsmooth.solver.simulation import machine
from nonsmooth.solver.simulation.steps import run
from nonsmooth.solver.simulation.steps.state import State

ROUNDS, STEPS, CYCLES = 7, 40, 200

#: Scenes with parameters, and the range of the frequency that is followed.
RESPONSES = {
    "impact": ({"damping": 0.0, "restitution": 0.8, "gap": 0.5}, (0.95, 2.2)),
    "backlash": ({"force": 0.3, "damping": 0.1, "frequency": 0.7}, (0.5, 1.0)),
    "clearance": ({"force": 0.3, "damping": 0.1, "gap": 1.0, "frequency": 1.0}, (0.3, 2.0)),
    "dry-friction": ({"damping": 0.0, "mu_s": 0.4, "mu_k": 0.4}, (0.3, 0.9)),
}


def median(work: Callable[[], int]) -> float:
    """Return the microseconds of one of the things of which `work` does as many as it says."""
    work()
    times = []
    for _ in range(ROUNDS):
        begin = time.perf_counter()
        count = work()
        times.append((time.perf_counter() - begin) / count)
    return statistics.median(times) * 1e6


def measured(scene: str) -> tuple[float, float, float]:
    """Return what a step, an orbit of a branch and a phase of a simulation cost."""
    values, ends = RESPONSES[scene]
    case = ns.scene(scene)(**values)
    orbit = ns.exact(case)
    piece, place = start_of(orbit, index_of(orbit.case, "frequency"), ends)
    simulated = machine.Machine(of_all_phases(case).cell)
    (row,) = ns.family(orbit.case, "frequency", [values.get("frequency", 0.8)])[:1]
    start = State(*np.divide(row.strobe, [case.units.length, case.units.of_motion(1)]), 0.0)
    phases = len(ns.simulate(case, row.strobe, cycles=CYCLES).phases)

    def steps() -> int:
        return len(piece.walk(place, 1e-3, 1e-4 * case.values["frequency"], STEPS)[0])

    def branch() -> int:
        return len(ns.branch(case, "frequency", *ends))

    def simulation() -> int:
        simulated.strobed(start, CYCLES)
        return phases

    return median(steps), median(branch), median(simulation)


#: Modes of the beam, and the range of the frequency that is followed.
MODES, RESPONSE = (2, 6, 20, 60), (95.0, 110.0)


def of_beam(modes: int) -> tuple[float, float]:
    """Return what a step and an orbit of a branch of a structure cost."""
    case = ns.scene("beam-clearance")(modes=modes)
    orbit = ns.exact(case)
    piece, place = start_of(orbit, index_of(case, "frequency"), RESPONSE)

    def steps() -> int:
        return len(piece.walk(place, 1e-3, 1e-4 * case.values["frequency"], STEPS)[0])

    def branch() -> int:
        return len(ns.branch(case, "frequency", *RESPONSE))

    return median(steps), median(branch)


#: What varies beside the frequency, its range, and points of a map each way.
MAPS = {
    "impact": ((0.1, 0.8), "gap"),
    "clearance": ((0.1, 0.6), "force"),
    "dry-friction": ((0.5, 1.5), "normal_force"),
}
POINTS = 200


def mapped(scene: str) -> float:
    """Return what a point of a map costs."""
    values, ends = RESPONSES[scene]
    across, name = MAPS[scene]
    names, bounds = ("frequency", name), (ends, across)
    case = ns.scene(scene)(**values)
    cases = (case.with_value(name, float(q)) for q in np.linspace(*across, LINES))
    stretches = [q for each in cases for q in lines.line_of(each, names, bounds, 1, POINTS)[0]]
    planes, seeds = planes_of(case, names, bounds, stretches)
    A = np.linspace(-1, 1, POINTS)

    def points() -> int:
        return block.block_of(planes, A, A, A[1] - A[0], seeds).size

    return median(points)


def additions() -> float:
    """Return the seconds of ten million additions."""
    begin, total = time.perf_counter(), 0.0
    for i in range(10_000_000):
        total += i
    return time.perf_counter() - begin


def main() -> None:
    """Measure and print."""
    FAMILY.compiled(walk.__name__)
    BODIES.compiled(walk.__name__)
    machine.FAMILY.compiled(run.__name__)
    block.FAMILY.compiled(filling.__name__)
    print("us                    step   orbit of a branch   phase")
    for scene in RESPONSES:
        with np.errstate(all="ignore"):
            step, orbit, phase = measured(scene)
        print(f"{scene:20} {step:6.0f}   {orbit:17.0f}   {phase:5.1f}")
    print("ms             modes   step   orbit of a branch")
    for modes in MODES:
        with np.errstate(all="ignore"):
            step, orbit = of_beam(modes)
        print(f"beam-clearance {modes:5}   {step / 1e3:4.2f}   {orbit / 1e3:17.2f}")
    print("us            point of a map")
    for scene in MAPS:
        print(f"{scene:20} {mapped(scene):7.0f}")
    print(f"10 million additions: {additions():.2f} s")


if __name__ == "__main__":
    main()
