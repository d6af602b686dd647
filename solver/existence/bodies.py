"""Solutions of the exact equations of a body: listed for up to two phases, else searched.

At given durations every event is linear in the cosine and the sine of the forcing's phase.  So
one phase has a closed form: two solutions or none.  Two phases leave one function of one
duration, whose sign changes are scanned.  The scan uses the slow modes and the static response
of the others; Newton's method refines each root with the whole body.

Without a forcing one phase leaves one function of its duration, which is scanned as well.

For more phases the first start is the linear response of the slow modes, which is quick.  If
it does not lead to a stable orbit, starts on a grid follow: first those at which the events
nearly vanish, then all others.
"""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from itertools import groupby, product

import numpy as np

from ..arrays import Matrix, Vector
from ..bodies.exact import events_by_wave
from ..bodies.modal import Modal
from ..bodies.part import later, parts_of, phase_map, wave
from ..kernels.bodies import ends
from ..kernels.start import RoughTimes, rough_times
from ..orbit.errors import times_apart
from ..orbit.exact_orbit import ExactOrbit, from_times
from ..scenes.bodies.cell import BodyCell
from ..scenes.case import Case
from ..simulation import homotopy
from .enclosure import changes_of_sign
from .one_phase import ROUNDING, on_the_circle

#: Modes of the scan: at least so many, and all below so many frequencies of the forcing.
SLOW, BELOW = 6, 6.0

#: Numbers of durations of the first phase in the scan: evenly spaced, and near each end.
EVENLY, AT_ENDS = 160, 40

#: Durations tried without a forcing, relative to the longest natural period.
PARTS = (1.0, 0.7, 0.4, 0.2, 0.1)

#: The longest duration in the scan of one phase without a forcing, relative to the same; how
#: many there are in the shortest period of the slow modes, and the most of all.
LONGEST, FINE, MOST = 3.0, 24, 6000

#: Shortest duration in the scan, relative to the cell.
SHORTEST = 1e-6

#: Bisections of an interval of durations before Newton's method.
HALVINGS = 24

#: Largest number of entries of all phase maps of one block of the scan.
ROOM = 2_000_000

#: Difference of times, relative to the cell, below which two solutions are the same.
SAME = 1e-7

#: Least divisor of events.
TINY = 1e-300

#: Number of times at which the size of the forced response of one phase is evaluated; ``|s| T``
#: of a pole above which rounding errors grow with it.
FEW, FAST = 8, 1e3

#: How far Newton's method may move from a solution in closed form, relative to the cell.
NEAR = 1e-6


def solutions(case: Case) -> Iterator[ExactOrbit]:
    """Yield solutions of the exact equations of a body, orbits or not, each once.

    After a group of starts that has led to a stable orbit, the less likely ones are skipped.
    """
    roots: list[ExactOrbit] = []
    for group in _starts(case.cell):  # type: ignore[arg-type]
        if any(solution.admissible and solution.stable for solution in roots):
            return
        for start in ends(case.cell, [*group]):  # type: ignore[arg-type]
            if any(times_apart(q, start.durations, start.angle) <= SAME for q in roots):
                continue
            solution = from_times(case, start)
            if solution.outcome.converged:
                roots.append(solution)
                yield solution


def complete(cell: BodyCell, orbits: Sequence[ExactOrbit]) -> bool:
    """Whether `orbits` provably have all solutions of a cell; known for one forced phase only.

    False at a resonance, where periodicity and event do not determine the state.
    """
    if not cell.forced or len(cell.phases) > 1:
        return False
    angles, are_all = _of_one_phase(cell)
    length = (cell.duration,)
    return are_all and all(
        any(times_apart(q, length, angle) <= NEAR for q in orbits) for angle in angles
    )


def listed(cell: BodyCell) -> bool:
    """Whether the solutions of a cell can be listed, in closed form or by a scan."""
    return cell.forced and len(cell.phases) <= 2


def _of_one_phase(cell: BodyCell) -> tuple[list[float], bool]:
    """Return the phases of the forcing at which one phase is periodic and ends by its event.

    These conditions are linear in state, cos and sin.  The second value is whether there are
    no other solutions.
    """
    (part,), rotation = parts_of(cell), later(cell.omega * cell.duration)
    maps = phase_map(part, cell.duration * np.linspace(0, 1, FEW + 1)[1:])
    flow, by_wave = (q[-1] for q in maps)
    size, sign = len(flow), cell.sign
    jump, inputs = sign * part.switch.state, sign * part.switch.inputs @ rotation
    closing = np.hstack([jump @ flow - np.eye(size), jump @ by_wave + inputs])
    gradient, waves = part.switch.gradient, part.switch.waves
    event = np.hstack([gradient @ flow, gradient @ by_wave + waves @ rotation])
    if not (np.isfinite(closing).all() and np.isfinite(event).all()):
        return [], False
    added = np.abs(maps[1]).max() or 1.0  # the unit of states below
    closing[:, size:] /= added
    event[:size] *= added
    rows = np.vstack([closing, event / (np.abs(event).max() or 1.0)])
    A, b = rows[:, :-1], -rows[:, -1]
    rounding = ROUNDING * max(1.0, float(np.abs(part.flow.poles).max()) * cell.duration / FAST)
    point = np.linalg.lstsq(A, b, rcond=rounding)[0]
    if np.abs(A @ point - b).max() > rounding * max(1.0, np.abs(point).max()):
        return [], True
    _, singular, Vh = np.linalg.svd(A)
    null_space = Vh[int((singular > rounding).sum()) :]
    _, sizes, lines = np.linalg.svd(null_space[:, -2:])
    if len(null_space) > 1 and sizes[1] > rounding:
        return [], False
    line = on_the_circle(point[-2:], sizes[0] * lines[0])
    return [q[-1] % (2 * np.pi) for q in line.states], len(null_space) == 1


def slow(cell: BodyCell) -> BodyCell:
    """Return a cell with the slow modes of its body, and the static response of the others."""
    body = cell.body
    speed = np.sqrt(np.abs(body.squares))
    count = max(SLOW, int((speed <= BELOW * cell.omega).sum()))
    if count >= len(speed) or not (body.squares[count:] > 0).all():
        return cell
    retained, truncated = slice(count), slice(count, None)
    at, square = body.at[truncated], body.squares[truncated, None]
    reduced = Modal(
        body.squares[retained],
        body.damping[retained, retained],
        body.at[retained],
        body.forcing[retained],
        body.mobility,
        body.residual + at.T @ (at / square),
        body.beyond + (at / square).T @ body.forcing[truncated],
    )
    return replace(cell, body=reduced)


def _starts(cell: BodyCell) -> Iterator[Iterable[RoughTimes]]:
    """Yield groups of starts, the likely ones first."""
    if not cell.forced:
        if len(cell.phases) == 1:
            yield _of_one_duration(slow(cell))
        yield _everywhere(cell)
    elif len(cell.phases) > 2:
        by_response = homotopy.from_linear_response(slow(cell))
        unlikely: list[RoughTimes] = []
        yield [by_response] if by_response else []
        yield _likely(cell, unlikely)
        yield unlikely
    elif len(cell.phases) == 1:
        angles = _of_one_phase(cell)[0]
        yield (RoughTimes((cell.duration,), angle, "the closed form") for angle in angles)
    else:
        yield _scanned(cell)


def _likely(cell: BodyCell, unlikely: list[RoughTimes]) -> Iterator[RoughTimes]:
    """Yield the starts whose events are nearest to zero; append the rest to `unlikely`."""
    quick = slow(cell)
    for durations, starts in groupby(rough_times(cell), key=lambda start: start.durations):
        around = list(starts)
        events = events_by_wave(quick, np.array(durations))
        events /= np.maximum(np.abs(events).max(axis=1, keepdims=True), TINY)
        residuals = [float(np.sum((events @ wave(start.angle)) ** 2)) for start in around]
        for i, start in enumerate(around):
            if residuals[i - 1] > residuals[i] <= residuals[(i + 1) % len(residuals)]:
                yield start
            else:
                unlikely.append(start)


def _everywhere(cell: BodyCell) -> Iterator[RoughTimes]:
    """Yield rough durations without a forcing, long and short relative to the slowest mode."""
    slowest = _slowest(cell)
    for durations in product(PARTS, repeat=min(len(cell.phases), 2)):
        fractions = durations + (PARTS[-1],) * (len(cell.phases) - 2)
        yield RoughTimes(tuple(slowest * q for q in fractions), 0.0, "durations all around")


def _slowest(cell: BodyCell) -> float:
    """Return the longest natural period; of a mode without one, that of a frequency of 1."""
    return 2 * np.pi / float(np.sqrt(np.abs(cell.body.squares).min() or 1.0))


def _of_one_duration(cell: BodyCell) -> Iterator[RoughTimes]:
    """Yield the durations of one phase without a forcing at which its event vanishes."""
    longest, fastest = LONGEST * _slowest(cell), float(np.sqrt(np.abs(cell.body.squares).max()))
    count = min(int(FINE * longest * fastest / (2 * np.pi)) + FINE, MOST)
    durations = longest * np.arange(1, count + 1) / count

    @np.errstate(all="ignore")  # the motion may grow beyond float64
    def event(durations: Vector) -> Vector:
        blocks = 1 + len(durations) * (2 * len(cell.body.squares)) ** 2 // ROOM
        parts = np.array_split(durations[:, None], blocks)
        return np.concatenate([events_by_wave(cell, q)[:, 0, 2] for q in parts])

    i = np.flatnonzero(np.diff(np.sign(event(durations))))
    roots = changes_of_sign(event, durations[i], durations[i + 1], HALVINGS) if len(i) else i
    for root in map(float, roots):
        yield RoughTimes((root,), 0.0, "a scan of the exact equations")


def _angles(a: float, b: float, c: float) -> list[float]:
    """Return the two zeros of ``a cos + b sin + c``, or none."""
    size = float(np.hypot(a, b))
    if size <= abs(c):
        return []
    middle, half = float(np.arctan2(b, a)), float(np.arccos(-c / size))
    return [(middle - half) % (2 * np.pi), (middle + half) % (2 * np.pi)]


def _scanned(cell: BodyCell) -> Iterator[RoughTimes]:
    """Yield the times at which both events of two phases vanish, for the slow modes."""
    quick = slow(cell)
    even = np.linspace(0, 1, EVENLY + 2)[1:-1]
    close = np.geomspace(SHORTEST, even[0], AT_ENDS, endpoint=False)
    parts = np.concatenate([close, even, 1 - close[::-1]])

    @np.errstate(over="ignore", invalid="ignore")  # the motion may grow beyond float64
    def excess(parts: Vector) -> Vector:
        events = _both(quick, parts)
        (a, b, c), (d, e, f) = (events[:, p].T for p in (0, 1))
        determinant = a * e - b * d
        cos, sin = b * f - c * e, c * d - a * f  # times the determinant
        if not (c.any() or f.any()):  # no gap, no load at rest: the angle is that of both
            return np.asarray(determinant)
        size = np.abs(a * e) + np.abs(b * d) + np.abs(cos) + np.abs(sin)
        size[size == 0] = 1.0
        return np.asarray((cos**2 + sin**2 - determinant**2) / size**2)

    yield from _symmetric(quick)
    i = np.flatnonzero(np.diff(np.sign(excess(parts))))
    roots = changes_of_sign(excess, parts[i], parts[i + 1], HALVINGS) if len(i) else i
    for root in map(float, roots):
        (a, b, c), (d, e, f) = _both(quick, np.array([root]))[0]
        durations = (root * cell.duration, (1 - root) * cell.duration)
        determinant = a * e - b * d
        if c == f == 0:
            angles = _angles(a, b, 0.0)
        elif determinant == 0:  # the angle is undetermined, or growth is beyond float64
            continue
        else:
            sin, cos = (c * d - a * f) / determinant, (b * f - c * e) / determinant
            angles = [float(np.arctan2(sin, cos)) % (2 * np.pi)]
        for angle in angles:
            yield RoughTimes(durations, angle, "a scan of the exact equations")


def _symmetric(cell: BodyCell) -> Iterator[RoughTimes]:
    """Yield the times of two equal phases whose events are the same condition."""
    first, second = _both(cell, np.array([0.5]))[0]
    distance = min(np.abs(first - second).max(), np.abs(first + second).max())
    for angle in _angles(*first) if distance <= SAME else ():
        yield RoughTimes((cell.duration / 2,) * 2, angle, "two equal phases")


def _both(cell: BodyCell, parts: Vector) -> Matrix:
    """Return both events at durations of the first phase, each divided by its largest factor.

    Shape (T, 2, 3).
    """
    durations = cell.duration * np.column_stack([parts, 1 - parts])
    blocks = 1 + len(durations) * (2 * len(cell.body.squares)) ** 2 // ROOM
    pairs = np.concatenate([events_by_wave(cell, q) for q in np.array_split(durations, blocks)])
    return np.asarray(pairs / np.maximum(np.abs(pairs).max(axis=2, keepdims=True), TINY))
