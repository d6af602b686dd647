"""The cell of a body: its modes and the laws of its contacts, without units."""

import io
import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from functools import lru_cache
from typing import TYPE_CHECKING, Any, Self, TypeAlias

import numpy as np

from ...arrays import Matrix
from ...bodies.laws import places
from ...bodies.modal import Modal, at_frequency, damped, modal
from ...bodies.poles import poles_of
from ...bodies.switch import impulses
from ...bodies.systems import BodyError
from ..cell import Cell, Form, Phase
from ..dimensionless import Units
from ..of_module import fields_of_cell, fields_of_phases, form_of
from ..parameter_error import ParameterError

if TYPE_CHECKING:
    from ..loaded import LoadedScene

#: The file of a body's matrices, in the folder of its scene.
MATRICES = "body.npz"

#: Entries of a form for the first contact, the forcing and 1; and for each further contact.
FIRST, OTHER = 6, 4

#: Part of a velocity left behind a jump that turns it, which is rounding.
GOES_ON = 1e-9

#: Difference of two entries of a symmetric matrix, relative to the largest, that is rounding.
ROUNDING = 1e-12

#: The least k of a scene whose contact forces do not jump.
CONTINUOUS = 2

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
    cell = _under_laws(scene, numbers, _body(scene, values, units, frequency), cycles)
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
                raise ParameterError([
                    f"body: behind the jump that ends {phase.name} the modes kept go on "
                    f"as before, at {goes_on:.2g} of their velocity: keep more, or let "
                    f"the contact come back with more than {least:.2g} of it"
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


@lru_cache(maxsize=64)
def _body(
    scene: "LoadedScene", values: tuple[float, ...], units: Units, frequency: float
) -> Modal:
    """Return the body in the units of a case, for parameters in SI units.

    Its modes are computed in units that are powers of two, which change no digit of its
    matrices.
    """
    binary = Units(*(2.0 ** round(math.log2(unit)) for unit in vars(units).values()))
    try:
        ratio, modes, entries = _in_numbers(scene, values)
        if modes is not None and (modes != int(modes) or modes < 1):
            raise BodyError(f"modes: got {modes!r}, expected a whole number from 1")
        matrices, count = _matrices(scene, entries, binary), None
        if modes is not None:
            count = int(modes)
        body = damped(_modes(scene, entries, binary, count), ratio)
        omega = frequency * binary.time / units.time
        body = at_frequency(body, matrices, omega, count)
        ratios = (
            a / b for a, b in zip(*(vars(q).values() for q in (units, binary)), strict=True)
        )
        body = body.in_units(*ratios)
        poles_of(body, frequency)
        return body
    except BodyError as error:
        raise ParameterError([f"body: {error}"]) from None


Entries: TypeAlias = tuple[tuple[Any, ...], ...]


def _in_numbers(scene: "LoadedScene", values: tuple[float, ...]) -> tuple[Any, Any, Entries]:
    """Return damping ratio, modes and entries of matrices for parameters in SI units."""
    try:
        ratio, modes = scene.numbers("modal", values)
        entries = tuple((*place, float(q)) for *place, q in scene.numbers("entries", values))
    except (ArithmeticError, ValueError, TypeError) as error:
        raise BodyError(f"an entry is no number with these parameters ({error})") from None
    for name, i, j, value in entries:
        if not math.isfinite(value):
            raise BodyError(f"{name}[{i}, {j}]: got {value}, expected a finite number")
    return ratio, modes, entries


def _check_matrix(name: str, matrix: Matrix) -> None:
    """Check a matrix with parameters in it, of which the scene has checked the defaults."""
    asymmetry = float(np.abs(matrix - matrix.T).max())
    if asymmetry > ROUNDING * np.abs(matrix).max():
        raise BodyError(f"{name}: it is not symmetric with these parameters")
    try:
        if name == "M":
            np.linalg.cholesky(matrix)
    except np.linalg.LinAlgError:
        raise BodyError("M: it is not positive definite with these parameters") from None


@lru_cache(maxsize=16)
def _modes(scene: "LoadedScene", entries: Entries, units: Units, modes: int | None) -> Modal:
    """Return the body in modal coordinates, without forcing frequency and damping ratio.

    A memory, or a force that may jump, excludes a massless compliance at the contact.
    """
    matrices = _matrices(scene, entries, units)
    size = matrices["M"].shape[0]
    if modes is not None and modes > size:
        raise BodyError(f"modes: got {modes:g}, more than the {size} degrees of freedom")
    jumps = scene.module.CLASS < CONTINUOUS  # whatever the order of the phases
    return modal(matrices, modes, 1.0, jumps or bool(scene.module.MEMORY))


def matrices_of(scene: "LoadedScene") -> Mapping[str, Any]:
    """Return the arrays of a body's file: shape of each matrix and, if numeric, its entries."""
    content = None if scene.kept is None else scene.kept[MATRICES]
    with np.load(scene.folder / MATRICES if content is None else io.BytesIO(content)) as file:
        return dict(file)


@lru_cache(maxsize=4)
def _matrices(scene: "LoadedScene", entries: Entries, units: Units) -> dict[str, Any]:
    """Return the matrices of a body as sparse arrays, in given units."""
    from scipy import sparse  # noqa: PLC0415  (a scene of one mass needs none)

    by_matrix: dict[str, list[tuple[int, int, float]]] = {}
    for name, i, j, value in entries:
        by_matrix.setdefault(name, []).append((i, j, value))
    sizes = {
        "M": units.mass,
        "C": units.mass / units.time,
        "K": units.mass / units.time**2,
        "forcing": units.mass * units.length / units.time**2,
        "at": 1.0,
    }
    matrices = {}
    file = matrices_of(scene)
    for name in (q.removesuffix("_shape") for q in file if q.endswith("_shape")):
        if name in by_matrix:
            rows, columns, numbers = map(np.array, zip(*by_matrix[name], strict=True))
        else:
            rows, columns, numbers = (
                file[q] for q in (f"{name}_rows", f"{name}_columns", name)
            )
        scaled = np.asarray(numbers, dtype=float) / sizes[name]
        shape = tuple(map(int, file[f"{name}_shape"]))
        matrices[name] = sparse.csc_array((scaled, (rows, columns)), shape=shape)
        if name in by_matrix and name in ("M", "K"):
            _check_matrix(name, matrices[name].toarray())
    return matrices
