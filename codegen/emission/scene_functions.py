"""The numerical functions of a scene as Python: units, coefficients, events, demands."""

from collections.abc import Iterable, Iterator, Mapping
from typing import NamedTuple

import sympy as sp

from ..python_text import python
from ..scene import Phase, Scene, linear_phase, state_row
from ..scene.bodies.body import Body
from ..scene.bodies.law import form, law_rows, place, signals, velocities
from ..scene.data import SceneData
from ..scene.linear import without_modulus
from ..scene.scales import scales


def _linear(demands: Mapping[str, sp.Expr], scene: SceneData) -> list[tuple[str, sp.Expr]]:
    """Return demands without moduli, each linear, with its words."""
    states = [q for q in signals(scene) if q != 1]
    return [
        (words, part)
        for words, demand in demands.items()
        for part in without_modulus(sp.sympify(demand), states)
    ]


def words_of(demands: Mapping[str, sp.Expr], scene: SceneData) -> tuple[str, ...]:
    """Return the words of demands, once for each of their linear forms."""
    return tuple(words for words, _ in _linear(demands, scene))


class Function(NamedTuple):
    """One of the functions: name, docstring, and the source of each entry of its result."""

    name: str
    summary: str
    entries: tuple[str, ...]

    def source(self, scene: Scene) -> str:
        """Return the source of the function."""
        arguments = ", ".join(symbol.name for symbol in scene.symbols)
        values = "".join(f"        {entry},\n" for entry in self.entries)
        head = f'def {self.name}({arguments}):\n    """{self.summary}"""\n'
        return f"{head}    return (\n{values}    )\n"


#: The coefficients of a linear form, or of an equation.
Row = tuple[sp.Expr, ...]


def _python_of(row: Row) -> str:
    return f"({', '.join(python(e) for e in row)})"


def _scalars(name: str, summary: str, values: Iterable[sp.Expr]) -> Function:
    return Function(name, summary, tuple(python(e) for e in values))


def _rows(name: str, summary: str, values: Iterable[Row]) -> Function:
    return Function(name, summary, tuple(_python_of(row) for row in values))


def _nested(name: str, summary: str, values: Iterable[list[Row]]) -> Function:
    lines = (f"({' '.join(f'{_python_of(row)},' for row in phase)})" for phase in values)
    return Function(name, summary, tuple(lines))


def whole(scene: Scene) -> Iterator[Function]:
    """Yield the functions on a scene as a whole."""
    sizes = scales(scene.each_motion[0])
    yield _scalars("scales", "Return the units of mass, time and length.", sizes)
    summary = "Return the expressions in the parameters that must not be negative."
    yield _scalars("requires", summary, scene.requires.values())


def extremes(scene: Scene) -> Function:
    """Return the function of the parameters at each extreme."""
    summary = "Return all parameters at each of the extremes."
    values = (
        tuple(sp.sympify(each.get(symbol, symbol)) for symbol in scene.symbols)
        for each in scene.extremes.values()
    )
    return _rows("extremes", summary, values)


def of_phases(scene: SceneData) -> Iterator[Function]:
    """Yield the functions on the phases of one motion."""
    phases, memory = scene.cell, [q.symbol for q in scene.memory]

    def forms(demands: Mapping[str, sp.Expr], what: str) -> list[Row]:
        return [form(part, scene, what) for _, part in _linear(demands, scene)]

    sides = "m x'' + c x' + k x = f + g cos"
    and_memory = "" if not memory else ", and of each memory on the right side"
    if scene.body is not None:
        summary = (
            "Return the linear forms that are zero in each phase: the laws of the contacts."
        )
        yield _nested("laws", summary, [law_rows(p, scene) for p in phases])
        yield from _of_body(scene.body)
    else:
        yield _rows(
            "coefficients",
            f"Return m, c, k, f, g of each phase: {sides}{and_memory}.",
            [linear_phase(p, memory).coefficients for p in phases],
        )
    held = [sp.sympify(p.held if p.held is not None else 0) for p in phases]
    yield _scalars("held", "Return the velocity at which each phase is held.", held)
    yield _rows(
        "events",
        "Return the linear form that is zero at the end of each phase, v before it.",
        [form(p.ends.zero, scene, p.name) for p in phases],
    )
    yield _rows(
        "jumps",
        "Return rho and d at the end of each phase: v+ = rho v + d.",
        [_jump(p, scene) for p in phases],
    )
    yield _nested(
        "demands",
        "Return the linear forms that must not be negative in each phase.",
        [forms(p.demands, p.name) for p in phases],
    )
    yield _nested(
        "switch_demands",
        "Return those that must not be negative where each phase ends, v before it.",
        [forms(p.ends.demands, p.name) for p in phases],
    )
    yield _rows(
        "memory",
        "Return the linear form that each memory is set to.",
        [form(q.value, scene, str(q.symbol), memory=False) for q in scene.memory],
    )


def _of_body(body: Body) -> Iterator[Function]:
    """Yield the functions of a body: entries of matrices with parameters; damping and modes."""
    rows = tuple(
        f"({name!r}, {i}, {j}, {python(value)})"
        for name, q in body.arrays.items()
        if not q.is_numeric
        for i, j, value in zip(q.rows, q.columns, q.values, strict=True)
    )
    yield Function("entries", "Return those entries of matrices that have parameters.", rows)
    summary = "Return the damping ratio and the number of modes, if they are given."
    numbers = (body.ratio, body.modes)
    texts = tuple(python(q) if isinstance(q, sp.Symbol) else repr(q) for q in numbers)
    yield Function("modal", summary, texts)


def start(scene: Scene) -> Iterator[Function]:
    """Yield the function of the condition on the begin of the first phase, if there is one."""
    if scene.start:
        zero = sp.Add(*(symbol - value for symbol, value in scene.start.items()))
        of_x, of_v, _, constant = state_row(zero, "start")
        summary = (
            "Return the linear form in x, v, 1 that is zero at the start of the first phase."
        )
        yield _scalars("start", summary, (of_x, of_v, constant))


def guess(scene: Scene) -> Function:
    """Return the function of rough durations, from which a search begins."""
    summary = "Return rough durations of the phases, if the scene has them."
    assert isinstance(scene.guess, tuple | list)
    return _scalars("guess", summary, scene.guess)


def _jump(phase: Phase, scene: SceneData) -> tuple[sp.Expr, ...]:
    """Return rho and d of each velocity at the end of a phase: ``v+ = rho v + d``."""
    factors: list[sp.Expr] = []
    for velocity in velocities(scene):
        after = form(phase.ends.jump.get(velocity, velocity), scene, phase.name)
        factors += [after[place(scene, velocity)], after[3]]
    return tuple(factors)
