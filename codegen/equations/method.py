"""The equations of a scene in one expansion, as a record to be printed."""

import re
from collections.abc import Iterator
from dataclasses import replace

import sympy as sp

from ..expansions import applies, in_order
from ..galerkin import Block, GalerkinConditions, cycles
from ..scene import Scene
from ..scene.smoothness import class_of
from ..system import Equation, GalerkinSystem, line
from .conditions.family import shown
from .conditions.forces import Forces
from .conditions.fourier import Fourier
from .conditions.functions import T
from .conditions.polynomial import Polynomial
from .notation import Notation

#: Remark on printed conditions, if the forcing may have several cycles in the period.
ONE_CYCLE = (
    "The period is one of the forcing; where it is `n` of them, the forcing has the frequency "
    "`n omega_0`."
)


def method_equations(conditions: GalerkinConditions) -> GalerkinSystem:
    """Return the equations of a scene in one expansion.

    Parameters
    ----------
    conditions : GalerkinConditions
        From `derive` of a module of ``codegen/expansions``.

    Returns
    -------
    GalerkinSystem
        `equations` has the expansion, the residual, each condition from its statement to its
        closed form and zero, the tables of closed forms, and the times; `method` is spelled
        with the class of the scene.

    Raises
    ------
    ValueError
        If the unknowns are those of no known family of expansions.

    Examples
    --------
    >>> from ..expansions import ck_tau
    >>> from ..scenes.impact import SCENE
    >>> system = method_equations(ck_tau.derive(SCENE))
    >>> system.method, system.unknowns.split("; ")[0]
    ('c0-tau', 'x_flight: displacement where flight begins')
    """
    conditions = _of_one_cycle(conditions)
    family = next((q for q in (Forces, Fourier, Polynomial) if q.fits(conditions)), None)
    if family is None:
        raise ValueError(f"{conditions.method}: its unknowns are of no family that is known")
    writer = family(conditions)
    return GalerkinSystem(
        method=spelled(conditions.method.partition(",")[0], conditions.scene),
        section=writer.section,
        title=_title(conditions, class_of(conditions.scene)),
        unknowns="; ".join(f"{q}: {what}" for q, what in unknowns(conditions)).replace("`", ""),
        equations=(*writer.equations(), *_times(writer.notation)),
        jacobian=tuple(writer.jacobian()),
    )


def _of_one_cycle(conditions: GalerkinConditions) -> GalerkinConditions:
    """Return conditions for one period of the forcing in the period of the motion."""
    rows = (replace(c, expression=c.expression.subs(cycles, 1)) for c in conditions.conditions)
    return replace(conditions, conditions=tuple(rows))


def spelled(method: str, scene: Scene) -> str:
    """Return the name of a method with the class of a scene.

    It is the generic name if another expansion that applies to the scene has that name.

    Examples
    --------
    >>> from ..scenes import impact, stick_slip
    >>> spelled("ck-tau", impact.SCENE), spelled("hb-ck", stick_slip.SCENE)
    ('c0-tau', 'hb-ck')
    """
    name = method.replace("ck", f"c{class_of(scene)}")
    namesakes = (q for q in in_order() if q.METHOD == name != method)
    return method if any(applies(q, scene) for q in namesakes) else name


def _title(conditions: GalerkinConditions, k: int) -> str:
    _, _, functions = conditions.method.partition(", ")
    title = conditions.title.replace("C^k", f"`C^{k}`")
    return f"{title}, `{functions}`" if functions else title


def unknowns(conditions: GalerkinConditions) -> Iterator[tuple[str, str]]:
    """Yield the printed name of each unknown, and its description."""
    for block in conditions.blocks:
        several = isinstance(block.symbol, sp.IndexedBase)
        yield f"{block.name}[n]" if several else str(shown(block)), _what(block)
    for time, phase in zip(conditions.times.durations, conditions.scene.phases, strict=True):
        yield str(time), f"duration of {phase.name}"
    if conditions.times.frequency is not None:
        yield "phi", "phase of the forcing where the first phase begins"


def _what(block: Block) -> str:
    """Return the description of an unknown, with names of functions marked."""
    several = "s" if block.count != 1 else ""
    begins = f"coefficient{several} " if block.what.startswith("of ") else ""
    return begins + re.sub(r"\b[a-z]+_\d+\b", r"`\g<0>`", block.what)


def _times(notation: Notation) -> Iterator[Equation]:
    """Yield the durations in terms of the times of the switches, and the period."""
    for p, (time, phase) in enumerate(
        zip(notation.times.durations, notation.scene.phases, strict=True)
    ):
        sides = (time, notation.at(p + 1) - notation.at(p))
        yield line(f"duration of {phase.name}", sides)
    if notation.times.sign == -1:
        yield line("the period", (T, 2 * notation.cell))
    if notation.times.frequency is not None:
        sides = (sp.Add(*notation.times.durations), notation.times.forced_cell.subs(cycles, 1))
        yield line("the cell is as long as the forcing makes it", sides)
