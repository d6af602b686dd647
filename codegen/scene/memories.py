"""The memories of an order of phases: which phases set them, and to what.

A memory of one phase is set wherever that phase begins.  One that holds in several is set where
the motion comes to one of them from another phase.
"""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

import sympy as sp

from ...nearest import numbered

if TYPE_CHECKING:
    from .data import Memory, Phase, SceneData


def settings(
    memories: Iterable["Memory"],
    names: Sequence[str],
    called: Sequence[str],
    value: Callable[["Memory", int], sp.Expr],
) -> tuple[tuple["Memory", ...], list[dict[sp.Symbol, sp.Expr]]]:
    """Return a memory for each phase that sets one, and its symbol in each phase.

    Before the first phase that sets a memory, the last one of the cell holds; its sign is left
    to `Scene.cell`.

    Parameters
    ----------
    memories : iterable of Memory
        Those of the scene.
    names, called : sequence of str
        The phases of the order, as the scene and as the order calls them.
    value : callable
        Returns what a memory is set to by a phase.

    Raises
    ------
    ValueError
        If no phase sets a memory that some phase has.
    """
    found: list[Memory] = []
    substitutions: list[dict[sp.Symbol, sp.Expr]] = [{} for _ in names]
    for memory in memories:
        own = isinstance(memory.at, str)
        holds = [name == memory.at if own else name in memory.at for name in names]
        places = [p for p, on in enumerate(holds) if on and (own or not holds[p - 1])]
        if not places and own:
            raise ValueError(f"phases: expected {memory.at} among them: it sets {memory.what}")
        if not places and holds[0]:
            what = f"none of them sets {memory.symbol}, which may have any of many values"
            raise ValueError(f"phases: {what}")
        unique = numbered([memory.symbol.name] * len(places))
        symbols = [sp.Symbol(name, real=True) for name in unique]
        for p in range(len(names) if places else 0):
            latest = sum(place <= p for place in places) - 1
            substitutions[p][memory.symbol] = symbols[latest]
        for p, symbol in zip(places, symbols, strict=True):
            found.append(replace(memory, symbol=symbol, at=called[p], value=value(memory, p)))
    return tuple(found), substitutions


def behind(
    memory: "Memory", phases: Sequence["Phase"], p: int, scene: "SceneData", sign: int
) -> sp.Expr:
    """Return what a memory is set to, with the contact forces by the law of the phase before.

    Parameters
    ----------
    memory : Memory
    phases : sequence of Phase
        Those of the order.
    p : int
        The one that sets it.
    scene : SceneData
    sign : int
        -1 if the cell before is the mirror image of the order, else 1.

    Raises
    ------
    ValueError
        If that law does not say what the forces are.
    """
    expression = sp.sympify(memory.value)
    forces = [contact.force for contact in scene.contacts]
    if not expression.has(*forces):
        return expression
    before = phases[p - 1]
    solutions = [*sp.linsolve(before.laws, forces)]
    if not solutions or any(force.has(*forces) for force in solutions[0]):
        what = f"no force follows from the law of {before.name}"
        raise ValueError(f"memory {memory.symbol}: {what}")
    by_law = [sp.sympify(force) for force in solutions[0]]
    if p == 0 and sign < 0:
        images = ({q: -q for q in force.free_symbols - {*scene.symbols}} for force in by_law)
        by_law = [-force.subs(image) for force, image in zip(by_law, images, strict=True)]
    return sp.expand(expression.subs(dict(zip(forces, by_law, strict=True))))
