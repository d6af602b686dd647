"""Checks of a scene when it is made; each error is one line that names the field."""

from collections.abc import Iterable, Mapping

import sympy as sp

from ....nearest import one_of
from ..data import STATE_UNITS, SceneData, forcing, v, x
from ..error import SceneError, named
from ..orders import all_phases
from ..scales import scales
from ..smoothness import switches
from ..units import balance, dimension_of, spelled, units_of, units_of_contacts
from .bodies import check_body
from .entries import check_entries
from .names import COMMANDS, check_called, check_name
from .parameters import (
    check_extremes,
    check_known,
    check_memory,
    check_parameters,
    check_several,
)
from .phases import Units, check_neighbours, check_phase, check_same_units, fields

#: The scales that a scene may give, and their SI units.
SCALES = {"mass": "kg", "time": "s", "length": "m"}


def check(scene: SceneData) -> None:
    """Check a scene.

    A `SceneError` names the first field that is wrong, what was found and what was expected.
    """
    check_entries(scene)
    check_called("name", scene.name)
    if scene.name in COMMANDS:
        raise SceneError(f"name: got {scene.name!r}, that of a command, expected another")
    if scene.declared:
        _check_motions(scene)
    else:
        _check_motion(scene)
    if not scene.motion:
        _check_used(scene)
        check_extremes(scene)


def _check_motion(scene: SceneData) -> None:
    """Check a scene with one order of phases."""
    _check_phases(scene)
    check_parameters(scene.parameters, [phase.name for phase in scene.phases])
    _check_frequency(scene)
    units = units_of(scene)
    if scene.body is not None:
        check_body(scene, units)
        units |= units_of_contacts(scene.body)
    units |= check_memory(scene, units)
    for end in (end for phase in scene.phases for end in phase.each_end):
        check_phase(end, scene, units)
    for p, phase in enumerate(scene.phases):
        after, sign = scene.after(p)
        check_neighbours(phase, scene.phases[after], sign)
    if scene.body is None:
        check_same_units(scene.phases, units)
    _check_whole(scene, units)
    _check_start(scene, units)
    scales(scene)
    switches(scene)


def _check_motions(scene: SceneData) -> None:
    """Check each motion of a scene by itself, and that their scales agree."""
    if scene.phases and scene.motions:
        raise SceneError("motions: got phases beside them, expected only one of both")
    for name in scene.motions:
        check_called("motions", name)
    if scene.guess and scene.motions and not isinstance(scene.guess, Mapping):
        raise SceneError(
            "guess: got durations, expected a mapping {motion: durations}, as of `motions`"
        )
    for name in scene.guess if isinstance(scene.guess, Mapping) else ():
        if name not in scene.declared:
            known = ", ".join(scene.declared)
            raise SceneError(f"guess: got {name!r}, expected one of {known}")
    first_scales: tuple[sp.Expr, ...] = ()
    check_several(scene)
    for name in scene.declared:
        with named(f"motion {name}" if scene.motions else ""):
            motion = _motion(scene, name)
        motion_scales = scales(motion)
        for unit, expected, size in zip(SCALES, first_scales, motion_scales, strict=False):
            if sp.simplify(expected - size) != 0:
                raise SceneError(
                    f"scales: the unit of {unit} is {expected} in {next(iter(scene.motions))}, "
                    f"{size} in {name}; give {unit!r}"
                )
        first_scales = first_scales or motion_scales
    _check_followers(scene)


def _check_followers(scene: SceneData) -> None:
    """Check that the phases that events say to follow are phases of the scene."""
    names = all_phases(scene).listed
    for phase in (phase for order in scene.declared.values() for phase in order):
        for to in (event.to for event in phase.ends.each if event.to):
            plain = to.removeprefix("-")
            if plain not in names or (plain != to and not scene.half_period):
                expected = f"got {to!r}, expected {one_of(plain, dict.fromkeys(names))}"
                raise SceneError(f"phase {phase.name}: ends: to: {expected}")


def _motion(scene: SceneData, name: str) -> SceneData:
    """Return one of the motions of a scene; a `SceneError` if it cannot be one."""
    try:
        return scene.of_motion(name)
    except SceneError:
        raise
    except ValueError as error:  # its memories
        raise SceneError(str(error)) from None


def _check_phases(scene: SceneData) -> None:
    """Check that there are phases with different names, one of them free."""
    if not scene.phases:
        raise SceneError("phases: got none, expected at least one")
    names = [phase.name for phase in scene.phases]
    for name in names:
        check_name(f"phase {name}: name", name)
    if len(set(names)) < len(names):
        raise SceneError(f"phases: got {', '.join(names)}, expected different names")
    if all(phase.held is not None for phase in scene.phases):
        raise SceneError("phases: got only held ones, expected one that moves freely")


def _check_frequency(scene: SceneData) -> None:
    """Check that the frequency is a positive parameter in rad/s."""
    if scene.frequency is None:
        return
    matching = [q for q in scene.parameters if q.symbol == scene.frequency]
    if not matching:
        raise SceneError(f"frequency: {scene.frequency} is not a parameter of the scene")
    if dimension_of(matching[0].unit) != dimension_of("1/s"):
        raise SceneError(f"frequency: got the unit {matching[0].unit!r}, expected rad/s")
    if not scene.frequency.is_positive:
        raise SceneError(f"frequency: got {scene.frequency}, expected a positive symbol")


def _check_whole(scene: SceneData, units: Units) -> None:
    """Check the requirements, scales and rough durations of a scene."""
    symbols = scene.symbols
    for words, expression in scene.requires.items():
        with named(f"requires {words!r}"):
            balance(sp.sympify(expression), units)
            check_known(sp.sympify(expression).free_symbols, symbols)
    for name, scale in scene.scales.items():
        with named(f"scales {name!r}"):
            if name not in SCALES:
                raise SceneError(f"expected one of {', '.join(SCALES)}")
            if not sp.sympify(scale).is_number:  # a number is in SI
                _check_dimension(scale, units, SCALES[name], symbols)
            if sp.sympify(scale).is_nonpositive:
                raise SceneError(f"got {scale}, expected what is positive")
    if isinstance(scene.guess, Mapping):
        raise SceneError("guess: got a mapping, expected a tuple of durations")
    if scene.guess and len(scene.guess) != len(scene.phases):
        raise SceneError(
            f"guess: got {len(scene.guess)} durations for {len(scene.phases)} phases"
        )
    for duration in scene.guess:
        with named("guess"):
            _check_dimension(duration, units, "s", symbols)


def _check_start(scene: SceneData, units: Units) -> None:
    """Check the condition on the begin of the first phase."""
    if not scene.start:
        return
    if scene.frequency is not None:
        raise SceneError("start: the phase of the forcing is not known, expected no frequency")
    if len(scene.start) > 1 or not scene.start.keys() <= {x, v}:
        symbols = ", ".join(map(str, scene.start))
        raise SceneError(f"start: got {symbols}, expected either x or v")
    for symbol, value in scene.start.items():
        with named("start"):
            _check_dimension(value, units, STATE_UNITS[symbol], scene.symbols)


def _check_used(scene: SceneData) -> None:
    """Check that every parameter and memory, and the forcing, occurs somewhere."""
    listed = (scene.phases, *scene.motions.values())
    phases = [end for phases in listed for phase in phases for end in phase.each_end]
    driven = [e for phase in phases for e in (*phase.laws, phase.ends.zero)]
    driven += [forcing] if scene.body is not None and "forcing" in scene.body.arrays else []
    if scene.frequency is not None and not any(sp.sympify(e).has(forcing) for e in driven):
        raise SceneError("frequency: no equation and no event has forcing")
    used = _symbols(value for phase in phases for _, value in fields(phase))
    used |= _symbols(phase.held for phase in phases if phase.held is not None)
    for memory in scene.memory:
        if memory.symbol not in used:
            raise SceneError(f"memory {memory.symbol}: no equation, event or demand has it")
    used |= set() if scene.body is None else scene.body.symbols
    used |= _symbols(scene.requires.values()) | {scene.frequency}
    used |= _symbols(memory.value for memory in scene.memory)
    unused = [q.name for q in scene.parameters if q.symbol not in used]
    if unused:
        raise SceneError(f"parameter {unused[0]}: no equation, event or demand has it")


def _symbols(expressions: Iterable[sp.Expr]) -> set[sp.Symbol]:
    return set().union(*(sp.sympify(e).free_symbols for e in expressions))


def _check_dimension(
    expression: sp.Expr, units: Units, unit: str, known: Iterable[sp.Symbol]
) -> None:
    """Check that an expression has a unit, and no symbols but known ones."""
    dimension = balance(sp.expand(expression), units)
    if dimension != dimension_of(unit):
        raise SceneError(f"{expression} is in {spelled(dimension)}, expected {unit}")
    check_known(sp.sympify(expression).free_symbols, known)
