"""What is shown of the orbits of a scene: tables, with what stands above and below them."""

import math
from collections.abc import Iterator, Mapping, Sequence

from nonsmooth.nearest import counted, in_short
from nonsmooth.solver.exact import ExactOrbit
from nonsmooth.solver.existence.known import others
from nonsmooth.solver.existence.reasons import WithoutSwitches
from nonsmooth.solver.no_orbit import NoOrbit
from nonsmooth.solver.orbit.errors import Errors
from nonsmooth.solver.orbit.motion import Motion
from nonsmooth.solver.results.branch import Branch
from nonsmooth.solver.results.family import Family
from nonsmooth.solver.results.orbit import Orbit
from nonsmooth.solver.results.sweep import Sweep
from nonsmooth.solver.scenes.case import Case
from nonsmooth.solver.scenes.methods import shown
from nonsmooth.solver.simulation.record import SimulatedPhase, Simulation
from nonsmooth.solver.stability.in_words import VERDICTS, in_words
from nonsmooth.solver.trade.measured import Trade

from ..columns import MORE_DIGITS, Piece, certain_digits, filled, table_of, without_rounding
from ..values import Vary
from .captions import caption, caption_of_family, derivative, estimated, legend

#: Points of a printed family.
ROWS = 25

#: Phases of a long motion that are printed: the first, and the last.
FIRST, LAST = 8, 12

#: Below the table of every orbit, and below that of time against error.
OF_EVERY = (
    "T: period; phi: phase of the forcing at the first switch; least x, largest x: of the "
    "displacement; estimate: error of the times, as a fraction of T; only: without switches."
)
OF_TRADE = """times: largest error of a duration{and_phase}, as a fraction of T;
estimate: the same, {estimated}; exact: by the flow of each phase,
from its own times."""


def solutions(
    case: Case, exact: ExactOrbit | None, outcomes: Mapping[str, Orbit | NoOrbit]
) -> Iterator[Piece]:
    """Show the orbit by each method, below the exact one."""
    scene = case.scene
    phases = scene.phases if len(scene.phases) > 1 and not scene.motions else ()
    table = table_of(
        "method", "N", "T [s]", *(["phi [rad]"] if scene.frequency else []),
        *(f"{phase} [s]" for phase in phases),
        "times", derivative(scene), "estimate", "it",
    )  # fmt: skip
    table.add_row("exact", "", *(["none found"] if exact is None else _times(exact)))
    for method, orbit in outcomes.items():
        if not isinstance(orbit, Orbit):
            table.add_row(shown(scene, method), "", orbit.status)
            continue
        cells = _accuracy(orbit.errors, orbit.estimate)
        table.add_row(
            name_of(orbit), str(orbit.order), *_times(orbit), *cells, str(orbit.iterations)
        )
    yield table
    orbits = [orbit for orbit in outcomes.values() if isinstance(orbit, Orbit)]
    if exact is not None:
        yield filled(f"exact: {in_words(exact)}", "  ")
    elif orbits:
        yield filled(f"{name_of(orbits[0])}: {in_words(orbits[0])}", "  ")
    for orbit in orbits:
        if orbit.estimate.times < MORE_DIGITS:
            words = f"{name_of(orbit)}, N = {orbit.order}: {_in_full(orbit)}"
            yield filled(words, "  ")


def others_beside(exact: ExactOrbit | None) -> Iterator[Piece]:
    """Say that there are other orbits beside one, if they are known."""
    orbits = [] if exact is None else others(exact)
    if orbits:
        verdicts = [VERDICTS[orbit.stable] for orbit in orbits]
        count = "another orbit" if len(orbits) == 1 else f"{len(orbits)} other orbits"
        words = f"{count} at these parameters: {', '.join(verdicts)}; see --all"
        yield filled(words[0].upper() + words[1:])


def every(
    case: Case, orbits: Sequence[Orbit], still: Sequence[WithoutSwitches]
) -> Iterator[Piece]:
    """Show one row an orbit, and one a motion without switches."""
    yield caption(case)
    if not (orbits or still):
        yield "none found"
        return
    names = ("motion", "T [s]", "phi [rad]", "least x [m]", "largest x [m]", "estimate", "")
    table = table_of(*names)
    for orbit in orbits:
        scene, turn, estimate = orbit.case.scene, orbit.forcing_phase, orbit.estimate.times
        table.add_row(
            scene.motion or ", ".join(scene.phases),
            f"{orbit.period:.9g}",
            "" if turn is None else f"{turn:.7g}",
            *(f"{end:.6g}" for end in without_rounding(orbit.extremes["displacement"])),
            f"{estimate:.1e}",
            VERDICTS[orbit.stable],
        )
    for motion in still:
        document = motion.as_dict()
        ends = (f"{end:.6g}" for end in (motion.least, motion.largest))
        verdict = VERDICTS[motion.stable]
        table.add_row(document["motion"], f"{document['period']:.9g}", "", *ends, "", verdict)
    yield table
    yield f"\n{filled(OF_EVERY)}"


def name_of(orbit: Orbit) -> str:
    """Return a method as tables show it, with its functions where they are not the default."""
    name = shown(orbit.case.scene, orbit.method)
    default = {None, 2 if orbit.case.scene.k == 0 else 1}
    return name if orbit.functions in default else f"{name}({orbit.functions})"


def _times(motion: Motion) -> list[str]:
    """Return period, phase of the forcing and, of several phases, the durations of a cell."""
    count = len(motion.case.cell.phases)
    turn = motion.forcing_phase
    return [
        f"{motion.period:.9g}",
        *([] if turn is None else [f"{turn:.7g}"]),
        *(f"{s:.7g}" for s in motion.durations[:count] if count > 1),
    ]


def _accuracy(errors: Errors | None, estimate: Errors) -> tuple[str, str, str]:
    """Return two errors, where the exact orbit is known, and the estimate of the first."""
    measured = ("", "")
    if errors is not None:
        measured = f"{errors.times:.2e}", f"{errors.discontinuous:.2e}"
    return *measured, f"{estimate.times:.1e}"


def _in_full(orbit: Orbit) -> str:
    """Return the times of an orbit by the digits that its estimated errors leave."""
    part, turn = orbit.estimate.times, orbit.forcing_phase
    words = [f"T = {certain_digits(orbit.period, abs(orbit.estimate.period))} s"]
    if turn is not None:
        forced = 2 * math.pi / float(orbit.case.values[str(orbit.case.scene.frequency)])
        off = 2 * math.pi * part * (orbit.period / forced)
        words.append(f"phi = {certain_digits(turn, off / turn if turn else 1.0)} rad")
    names = orbit.case.scene.phases
    if len(names) > 1:
        for name, s in zip(names, orbit.durations, strict=False):
            words.append(f"{name} = {certain_digits(s, part * orbit.period / s)} s")
    return ", ".join(words)


def family(result: Family) -> Iterator[Piece]:
    """Show some of the points along a parameter, and what holds for all."""
    yield caption_of_family(result)
    scene = result.case.scene
    parameter = next(q for q in scene.parameters if q.name == result.parameter)
    phases = scene.phases if len(scene.phases) > 1 else ()
    heading = parameter.symbol + (f" [{parameter.unit}]" if parameter.unit else "")
    table = table_of(
        heading, "T [s]", *(["phi [rad]"] if scene.frequency else []),
        *(["motion"] if scene.motions else []), *(f"{phase} [s]" for phase in phases),
        "least x [m]", "largest x [m]", "estimate", "it",
    )  # fmt: skip
    count = len(result.rows)
    chosen = sorted({round(i * (count - 1) / (ROWS - 1)) for i in range(ROWS)})
    for row in (result.rows[i] for i in (chosen if count > ROWS else range(count))):
        if row.durations is None or row.extremes is None or row.estimate is None:
            table.add_row(f"{row.value:.6g}", row.status)
            continue
        durations = result.durations_of(row)
        table.add_row(
            f"{row.value:.6g}",
            f"{row.period:.9g}",
            *([f"{row.forcing_phase:.7g}"] if scene.frequency else []),
            *([row.motion] if scene.motions else []),
            *(f"{durations[phase]:.6g}" if phase in durations else "" for phase in phases),
            *(f"{end:.6g}" for end in without_rounding(row.extremes["displacement"])),
            f"{row.estimate.times:.1e}",
            str(row.iterations),
        )
    yield table
    if count > ROWS:
        yield f"{ROWS} of {count} points; -o writes all of them"
    statuses = [row.status for row in result.rows]
    parts = [f"{statuses.count(status)} {status}" for status in dict.fromkeys(statuses)]
    anew = sum(not row.followed for row in result.rows[1:] if row.status == "ok")
    if anew:
        parts.append(f"{anew} searched anew, not followed from the value before")
    yield "; ".join(parts)


def branches(case: Case, along: Vary[float], followed: Sequence[Branch]) -> Iterator[Piece]:
    """Show the branches of a case, one below the other."""
    yield caption(case, along)
    for branch in followed:
        yield from _branch(branch)


def _branch(result: Branch) -> Iterator[Piece]:
    """Show the events of a branch, its pieces between them, and how it ends."""
    parameter = next(q for q in result.case.scene.parameters if q.name == result.parameter)
    heading = parameter.symbol + (f" [{parameter.unit}]" if parameter.unit else "")
    table = table_of("event", heading, "error", "motion", "phase")
    for event in result.events:
        table.add_row(
            event.kind,
            f"{event.parameter:.15g}",
            f"{event.estimate:.0e}",
            in_short(event.motion or ""),
            event.phase or "",
        )
    if result.events:
        yield table
    values, why = result["value"], result.why_it_ended
    first, last = (f"{values[i]:.9g} ({why[i]})" for i in (0, -1))
    yield filled(f"{parameter.symbol} from {first} to {last}", "  ")


def trade(result: Trade) -> Iterator[Piece]:
    """Show time against error, the front marked."""
    scene = result.case.scene
    yield caption(result.case)
    table = table_of("method", "N", "time [s]", "times", "estimate", "front")
    for point in result.points:
        exact = point.order is None
        table.add_row(
            shown(scene, point.method),
            "" if exact else str(point.order),
            f"{point.seconds:.1e}",
            f"{point.error:.1e}",
            "" if exact else f"{point.estimate:.1e}",
            "*" if point.front else "",
        )
    yield table
    also = " or of the phase of the forcing" if scene.frequency else ""
    yield "\n" + OF_TRADE.format(and_phase=also, estimated=estimated(scene))


def convergence(result: Sweep) -> Iterator[Piece]:
    """Show one row a method and order, and how fast each method converges."""
    scene = result.case.scene
    yield caption(result.case)
    forced = scene.frequency is not None
    table = table_of(
        "method", "N", "T [s]", *(["phi [rad]"] if forced else []),
        "times", derivative(scene), "estimate", "it",
    )  # fmt: skip
    for row in result.rows:
        head = (shown(scene, row.method), str(row.order))
        if row.estimate is None:
            table.add_row(*head, row.status, *[""] * (3 + forced), str(row.iterations))
            continue
        times = [f"{row.period:.9g}", *([f"{row.forcing_phase:.7g}"] if forced else [])]
        cells = _accuracy(row.errors, row.estimate)
        table.add_row(*head, *times, *cells, str(row.iterations))
    yield table
    yield "\nConvergence, fitted to the logarithms of all errors above rounding:\n"
    rates = table_of("method", "times", derivative(scene))
    for method, rate in result.rates().items():
        rates.add_row(shown(scene, method), rate.text("times"), rate.text("discontinuous"))
    yield rates
    yield f"\n{legend(scene, durations=False)}"


def transient(case: Case, motion: Simulation) -> Iterator[Piece]:
    """Show the phases of a motion: the first and the last where there are many."""
    yield caption(case)
    table = table_of("phase", "t [s]", "lasts [s]", "x [m]", "x' [m/s]")
    phases = motion.phases
    rows = [_cells(phase) for phase in phases]
    if len(rows) > FIRST + LAST:
        rows[FIRST:-LAST] = [("...", "", "", "", "")]
    for row in rows:
        table.add_row(*row)
    yield table
    count = counted(len(phases), "phase")
    yield f"\n{count} in {motion.time:.6g} s; t, x and x' where each begins."
    if any(phase.mirrored for phase in phases):
        yield "-: the mirror image of the phase."


def _cells(phase: SimulatedPhase) -> tuple[str, ...]:
    name = f"-{phase.name}" if phase.mirrored else phase.name
    numbers = (phase.start, phase.duration, phase.displacement, phase.velocity)
    return name, *(f"{number + 0.0:.7g}" for number in numbers)
