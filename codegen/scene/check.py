"""What is checked of a scene when it is made; each mistake is one line that names the field."""

import sympy as sp

from .data import Phase, Scene
from .entries import check_entries
from .error import SceneError, named
from .names import check_name
from .parameters import check_parameters
from .phases import Units, check_neighbours, check_phase, check_same_units
from .scales import scales
from .smoothness import switches
from .symbols import STATE_UNITS, forcing
from .units import balance, dimension_of, spelled

#: The units that a scene may say, and what they are in SI.
SCALES = {"mass": "kg", "time": "s", "length": "m"}


def check(scene: Scene) -> None:
    """Check a scene.

    Raises
    ------
    SceneError
        Naming the first field that is wrong, what was found and what was expected.
    """
    check_entries(scene)
    check_name("name", scene.name.replace("-", "_"))
    _check_phases(scene)
    check_parameters(scene.parameters, [phase.name for phase in scene.phases])
    _check_frequency(scene)
    units = {symbol: dimension_of(unit) for symbol, unit in STATE_UNITS.items()}
    units |= {q.symbol: dimension_of(q.unit) for q in scene.parameters}
    for phase in scene.phases:
        check_phase(phase, units, forced=scene.frequency is not None)
    for phase, after in zip(scene.phases, scene.phases[1:], strict=False):
        check_neighbours(phase, after, 1)
    check_neighbours(scene.phases[-1], scene.phases[0], scene.sign)
    check_same_units(scene.phases, units)
    _check_whole(scene, units)
    scales(scene)
    _check_used(scene)
    switches(scene)


def _check_phases(scene: Scene) -> None:
    if not scene.phases:
        raise SceneError("phases: got none, expected at least one")
    names = [phase.name for phase in scene.phases]
    for name in names:
        check_name(f"phase {name}: name", name)
    if len(set(names)) < len(names):
        raise SceneError(f"phases: got {', '.join(names)}, expected different names")
    if all(phase.held is not None for phase in scene.phases):
        raise SceneError("phases: got only held ones, expected one that moves freely")


def _check_frequency(scene: Scene) -> None:
    if scene.frequency is None:
        return
    found = [q for q in scene.parameters if q.symbol == scene.frequency]
    if not found:
        raise SceneError(f"frequency: {scene.frequency} is not a parameter of the scene")
    if dimension_of(found[0].unit) != dimension_of("1/s"):
        raise SceneError(f"frequency: got the unit {found[0].unit!r}, expected rad/s")
    if not scene.frequency.is_positive:
        raise SceneError(f"frequency: got {scene.frequency}, expected a positive symbol")


def _check_whole(scene: Scene, units: Units) -> None:
    known = set(scene.symbols)
    for words, expression in scene.requires.items():
        with named(f"requires {words!r}"):
            balance(sp.sympify(expression), units)
            _check_free(expression, known)
    for name, scale in scene.scales.items():
        with named(f"scales {name!r}"):
            if name not in SCALES:
                raise SceneError(f"expected one of {', '.join(SCALES)}")
            if not sp.sympify(scale).is_number:  # a number is in SI
                _check_dimension(scale, units, SCALES[name])
            _check_free(scale, known)
            if sp.sympify(scale).is_nonpositive:
                raise SceneError(f"got {scale}, expected what is positive")
    if scene.guess and len(scene.guess) != len(scene.phases):
        raise SceneError(
            f"guess: got {len(scene.guess)} durations for {len(scene.phases)} phases"
        )
    for duration in scene.guess:
        with named("guess"):
            _check_dimension(duration, units, "s")
            _check_free(duration, known)


def _check_used(scene: Scene) -> None:
    driven = [e for phase in scene.phases for e in (phase.equation, phase.ends.zero)]
    if scene.frequency is not None and not any(sp.sympify(e).has(forcing) for e in driven):
        raise SceneError("frequency: no equation and no event has forcing")
    used = set().union(
        *(sp.sympify(e).free_symbols for p in scene.phases for e in _expressions(p)),
        *(sp.sympify(e).free_symbols for e in scene.requires.values()),
        {scene.frequency},
    )
    idle = [q.name for q in scene.parameters if q.symbol not in used]
    if idle:
        raise SceneError(f"parameter {idle[0]}: no equation, event or demand has it")


def _expressions(phase: Phase) -> list[sp.Expr]:
    held = [] if phase.held is None else [phase.held]
    ends = [phase.ends.zero, *phase.ends.jump.values()]
    return [phase.equation, *ends, *phase.demands.values(), *held]


def _check_free(expression: sp.Expr, known: set[sp.Symbol]) -> None:
    strange = sorted(sp.sympify(expression).free_symbols - known, key=str)
    if strange:
        raise SceneError(f"{strange[0]} is not a parameter of the scene")


def _check_dimension(expression: sp.Expr, units: Units, unit: str) -> None:
    found = balance(sp.expand(expression), units)
    if found != dimension_of(unit):
        raise SceneError(f"{expression} is in {spelled(found)}, expected {unit}")
