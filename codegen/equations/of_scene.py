"""The equations of a scene, to be printed: motion, events, jumps, demands, classes, scales."""

import re
from collections.abc import Iterator

import sympy as sp

from ..galerkin.closure import law
from ..scene import Scene
from ..scene.scales import scales
from ..scene.smoothness import HIGHEST, place
from ..system import Equation, line
from . import bodies
from .conditions.functions import T, state, t, x
from .notation import Notation
from .switching import (
    at_state,
    at_the_end,
    balanced,
    equation_of_motion,
    event,
    jump,
    not_negative,
    perturbations,
    set_to,
)

ORDINAL = {1: "first", 2: "second", 3: "third"}


def scene_equations(scene: Scene) -> tuple[Equation, ...]:
    """Return the equations of an oscillator, or of a body.

    Returns
    -------
    tuple of Equation
        The equation of motion of each phase, or the laws of the contacts, its constraint and
        demands, the event that ends it and the jump there; for one mass the class and the
        saltation at each switch; and the scales.  The paper's scene has equation numbers.

    Examples
    --------
    >>> from ..scenes import beam_clearance, impact
    >>> print(scene_equations(impact.SCENE)[0].text(unicode=False))
        -  equation of motion in flight; 0 <= t < T
           m*x''(t) + c*x'(t) + k*x(t) = F*cos(Omega*t + phi)
    >>> print(scene_equations(beam_clearance.SCENE)[2].text(unicode=False))
        -  law at tip in contact; 0 <= t < t1
           k_c*x(t) + f(t) = g*k_c
    """
    notation = Notation(scene)
    parts = [_phases, _switches, _classes, whole_motion]
    if scene.body is not None:
        parts = [bodies.of_the_body, _phases, bodies.rate, _switches, whole_motion]
    return tuple(row for part in parts for row in part(notation))


def _phases(notation: Notation) -> Iterator[Equation]:
    """Yield the equations of motion, constraints and demands of all phases."""
    scene, numbers = notation.scene, notation.numbers
    for p, phase in enumerate(scene.phases):
        name, when = phase.name, notation.during(p)
        if scene.body is not None:
            yield from bodies.laws_of(notation, p)
        else:
            sides, number = equation_of_motion(notation, p), numbers.get(f"motion_{name}", "")
            yield Equation(number, f"equation of motion in {name}", sides, when)
        if phase.held is not None:
            held = (state(1, t), sp.sympify(phase.held))
            number = numbers.get(f"held_{name}", "")
            yield Equation(number, f"the velocity is held in {name}", held, when)
            if scene.body is not None:
                yield bodies.returning(notation, p)
        at = place(scene, p) if scene.body is None else None
        if at is not None:
            yield line(f"the displacement is held in {name}", (state(0, t), at), when)
        for words, demand in scene.cell[p].demands.items():
            relation = not_negative(at_state(notation, demand, t))
            title = f"demanded in {name}: {marked(scene, words)}"
            yield Equation(numbers.get(f"demands_{name}", ""), title, (relation,))


def _switches(notation: Notation) -> Iterator[Equation]:
    """Yield the events, jumps and demands at all switches, and the memories."""
    scene = notation.scene
    for p, phase in enumerate(scene.phases):
        left, right, _ = balanced(event(notation, p))
        yield line(f"{phase.name} ends", (left, right))
        for end in phase.each_end[1:]:
            left, right, _ = balanced(at_the_end(notation, p, end.ends.zero))
            words = f"in another order {phase.name} ends, as {end.name}"
            yield line(words, (left, right))
        yield from _jumps(notation, p) if scene.body is None else bodies.velocities(notation, p)
        for words, demand in scene.cell[p].ends.demands.items():
            title = f"demanded where {phase.name} ends: {marked(scene, words)}"
            yield line(title, (not_negative(at_the_end(notation, p, demand)),))
    for memory in scene.memory:
        words = f"{memory.what}: set where {memory.at} begins"
        yield line(words, (memory.symbol, set_to(notation, memory)))


def _jumps(notation: Notation, p: int) -> Iterator[Equation]:
    """Yield the jump of the velocity at the end of a phase, if there is one."""
    scene, phase = notation.scene, notation.scene.phases[p]
    if phase.ends.jump:
        q, sign = scene.after(p)
        value = sign * law(scene, q, notation.end)
        words = f"the velocity jumps where {phase.name} ends"
        yield line(words, (state(1, notation.side(p + 1, "+")), value))


def _classes(notation: Notation) -> Iterator[Equation]:
    """Yield the class at each switch, and its map of small perturbations."""
    for p, switch in enumerate(notation.switches):
        if switch.k == HIGHEST:
            after, before = (state(2, notation.side(p, side)) for side in "+-")
            yield line(f"no derivative jumps where {switch.before} begins", (after, before))
            continue
        order = ORDINAL.get(switch.jumps, f"{switch.jumps}th")
        words = f"the motion is `C^{switch.k}` where {switch.before} begins: its {order} "
        yield line(f"{words}derivative jumps", jump(notation, p))
    for p, phase in enumerate(notation.scene.phases):
        for words, sides in perturbations(notation, p):
            yield line(f"small perturbation {words} where {phase.name} ends", sides)


def whole_motion(notation: Notation) -> Iterator[Equation]:
    """Yield the equations of the whole motion: period, requirements, scales."""
    scene = notation.scene
    if scene.half_period:
        yield line("the motion repeats with the opposite sign", (x(t + T / 2), -x(t)))
        yield line("the period", (T, 2 * notation.cell))
    else:
        yield line("the motion repeats", (x(t + T), x(t)))
    if scene.frequency is not None:
        yield line("the period is that of the forcing", (T, 2 * sp.pi / scene.frequency))
    for words, expression in scene.requires.items():
        yield line(f"required: {marked(scene, words)}", (_required(sp.sympify(expression)),))
    units = zip(("mass", "time", "length"), "mtx", scales(scene), strict=True)
    for name, letter, size in units:
        symbol = sp.Symbol(f"{letter}_unit")
        words = f"unit of {name} in which the equations are dimensionless"
        yield line(words, (symbol, size.xreplace({sp.Float(1.0): sp.S.One})))


def marked(scene: Scene, words: str) -> str:
    """Return words with names of parameters marked, if these contain an underscore."""
    names = [str(symbol) for symbol in scene.symbols if "_" in str(symbol)]
    return re.sub(rf"\b({'|'.join(names)})\b", r"`\1`", words) if names else words


def _required(expression: sp.Expr) -> sp.Expr:
    """Return ``expression >= 0`` with its negative terms on the other side."""
    terms = sp.Add.make_args(sp.expand(expression))
    negated = sp.Add(*(-q for q in terms if q.could_extract_minus_sign()))
    return sp.Le(negated, expression + negated, evaluate=False)
