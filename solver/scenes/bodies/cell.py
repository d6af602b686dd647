"""The cell of a body: its modes and the laws of its contacts, without units."""

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any, Self

import numpy as np

from ...bodies.laws import places
from ...bodies.modal import Modal
from ...bodies.switch import impulses
from ..cell import Cell, Form, Phase
from ..dimensionless import Units
from ..of_module import fields_of_cell, fields_of_phases, form_of
from ..parameter_error import ParameterError
from .body import body_of

if TYPE_CHECKING:
    from ..loaded import LoadedScene

#: Entries of a form for the first contact, the forcing and 1; and for each further contact.
FIRST, OTHER = 6, 4

#: Part of a velocity left behind a jump that turns it, which is rounding.
GOES_ON = 1e-9

#: Unused coefficients of the equation of one mass.
NO_EQUATION: Any = {"m": 1.0, "c": 0.0, "k": 0.0, "f": 0.0, "g": 0.0}


@dataclass(frozen=True)
class BodyPhase(Phase):
    """One phase of a body: the laws of its contacts in place of an equation of motion.

    A form has factors of ``x, v, cos, 1, force, a`` of the first contact, then of ``x, v,
    force, a`` of each further contact, then of each memory.

    Parameters
    ----------
    laws : tuple of Form
        Forms that vanish throughout the phase, one for each contact.
    jumps : tuple of (float, float)
        Velocity of each contact after the switch at the end: ``rho v + d``.
    """

    laws: tuple[Form, ...] = ()
    jumps: tuple[tuple[float, float], ...] = ()

    @property
    def width(self) -> int:
        """Number of entries of a form without those of the memories."""
        return FIRST + OTHER * (len(self.laws) - 1)

    @property
    def equation(self) -> tuple[object, ...]:
        """Its laws, normalised, by which phases are compared."""
        return tuple(map(_scaled, self.laws)), self.held, self.speed

    @property
    def rests(self) -> bool:
        """False: a body moves also where a contact is held."""
        return False

    def cut(self) -> Self:
        """Return the phase cut where the velocity vanishes: event ``x' = 0``, no jumps."""
        return replace(super().cut(), jumps=((1.0, 0.0),) * len(self.laws))

    def lawful(self, form: Form) -> Form:
        """Return a form with the contact forces by the laws of the phase, then memories."""
        laws, force = np.array(self.laws), places(len(self.laws))[2]
        row = np.append(form, np.zeros(laws.shape[1] - len(form)))
        if row[force].any():
            row -= row[force] @ np.linalg.solve(laws[:, force], laws)
            row[force] = 0.0
        return tuple(map(float, row))

    def leaps(self, form: Form) -> bool:
        """Return whether the value of a form may jump at the switch that ends the phase.

        Forces and accelerations may; a velocity does if its jump is not the identity.
        """
        _, v, force, a = places(len(self.laws))
        velocities = zip(self.jumps, v, strict=True)
        jumps = any(form[q] for jump, q in velocities if jump != (1.0, 0.0))
        return jumps or any(form[q] for q in (*force, *a))

    def with_forms(self, put: Callable[[Form], Form], **others: Any) -> Self:
        """Return the phase with each form replaced by ``put(form)``, and `others` as given."""
        return super().with_forms(put, laws=tuple(map(put, self.laws)), **others)


def _scaled(law: Form) -> Form:
    """Return a law scaled to first nonzero factor 1: a mirror image may have another sign."""
    first = next(factor for factor in law if factor)
    return tuple(factor / first for factor in law)


@dataclass(frozen=True)
class BodyCell(Cell):
    """A cell whose phases are those of a body, and the body itself."""

    phases: tuple[BodyPhase, ...]
    body: Modal = field(kw_only=True)

    def carrying(self, p: int) -> BodyPhase:
        """Return phase `p` with factors of the actual values of the memories; see `Cell`."""
        phase = super().carrying(p)
        assert isinstance(phase, BodyPhase)
        return phase

    def place(self, p: int) -> float | None:
        """Return None: a body does not rest at one displacement."""
        return None


def body_cell(
    scene: "LoadedScene", numbers: tuple[float, ...], cycles: int, units: Units | None
) -> BodyCell:
    """Return the cell of a scene of one motion with a body, for parameters in given units.

    Without `units` the body is a stand-in with as many contacts, enough for the laws alone.

    Raises
    ------
    ParameterError
        If its parameters make no body.
    """
    if units is None:
        return _under_laws(scene, numbers, _stand_in(len(scene.module.CONTACTS)), cycles)
    values = tuple(
        number * units.of_parameter(powers)
        for number, powers in zip(numbers, scene.powers, strict=True)
    )
    frequency = fields_of_cell(scene, numbers)["frequency"] or 0.0
    cell = _under_laws(scene, numbers, body_of(scene, values, units, frequency), cycles)
    _check_jumps(cell)
    return cell


def _check_jumps(cell: BodyCell) -> None:
    """Check that a contact turns where its velocity jumps, as the modes that are kept have it.

    The impulse is that of all modes: of the velocity of a few it turns a part.
    """
    for p, phase in enumerate(cell.phases):
        turns = any(rho <= 0 for rho, _ in phase.jumps)
        if not turns or any(cell.phases[q].held for q, _ in cell.followers(p)):
            continue
        factors = 1 + np.diag(cell.body.kept_mobility @ impulses(cell, p)[0])
        for (rho, _), goes_on in zip(phase.jumps, factors, strict=True):
            if rho <= 0 and goes_on > GOES_ON:
                least = (1 - rho) / (1 - goes_on) - 1
                back = f", or let the contact come back with more than {least:.2g} of it"
                raise ParameterError([
                    f"body: behind the jump that ends {phase.name} the modes kept go on "
                    f"as before, at {goes_on:.2g} of their velocity: keep more"
                    + (back if least < 1 else "")
                ])  # fmt: skip


def _stand_in(contacts: int) -> Modal:
    """Return a generic body with a number of contacts, and three modes for each."""
    omega = 1.0 + 0.618034 * np.arange(3 * contacts, dtype=float)
    at = np.cos(np.outer(omega, 1.0 + np.arange(contacts)))
    none, nothing = np.zeros((contacts, contacts)), np.zeros(contacts, dtype=complex)
    return Modal(omega**2, np.diag(omega / 50), at, np.sin(omega), at.T @ at, none, nothing)


def _under_laws(
    scene: "LoadedScene", numbers: tuple[float, ...], body: Modal, cycles: int
) -> BodyCell:
    """Return the cell of a body under the laws of a scene."""
    rows = zip(
        scene.numbers("laws", numbers),
        scene.numbers("jumps", numbers),
        fields_of_phases(scene, numbers),
        strict=True,
    )
    phases = tuple(
        BodyPhase(
            **NO_EQUATION,
            memory=(0.0,) * len(scene.memory),
            laws=tuple(map(form_of, laws)),
            jumps=tuple(
                (float(rho), float(d)) for rho, d in zip(jumps[::2], jumps[1::2], strict=True)
            ),
            **fields,
        )
        for laws, jumps, fields in rows
    )
    return BodyCell(phases=phases, cycles=cycles, body=body, **fields_of_cell(scene, numbers))
