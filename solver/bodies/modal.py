"""A body in modal coordinates, as its contacts and its forcing see it.

The truncated modes are represented by their static response to contact forces, a residual
flexibility.  Where a force may jump, the contact would leap by that.  There the static response
is a further shape, with its stiffness, mass and damping: R. H. MacNeal, Computers and
Structures 1 (1971), 581-601, with the inertia of S. Rubin, AIAA Journal 13 (1975), 995-1006.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property, lru_cache
from typing import Any

import numpy as np

from ..arrays import Complex, Indices, Matrix, Vector
from .left_out import LeftOut, beyond_shapes, left_out_of, static_answers, static_shapes
from .modes import DENSE, marks, natural_modes
from .systems import BodyError, exact_product, factored, solver

#: What a contact, or a damper, may see of a mode that it does not see, as a part.
UNSEEN = 1e-11


@dataclass(frozen=True, eq=False)
class Modal:
    """A body in some shapes, ``q = Phi eta`` with ``Phi^T M Phi = I``.

    They are the modes that are kept and, where a contact force may jump, the static responses
    of the others to contact forces.

    Parameters
    ----------
    squares : ndarray, shape (m,)
        Squares of the angular frequencies; 0 where the body moves freely.
    damping : ndarray, shape (m, m)
        ``Phi^T C Phi``.
    at : ndarray, shape (m, c)
        ``Phi^T w`` of each contact.
    forcing : ndarray, shape (m,)
        ``Phi^T f``.
    mobility : ndarray, shape (c, c)
        ``w^T M^-1 w`` of the whole body: the velocities that unit impulses give.
    residual : ndarray, shape (c, c)
        Static compliance of what is left out.
    beyond : ndarray of complex, shape (c,)
        What that adds to the response of the contacts to the forcing.
    marks : ndarray, shape (m, l), optional
        What tells a shape from its opposite: see `facing`.
    left_out : LeftOut, optional
        What `at_frequency` needs, in the units of the matrices.
    """

    squares: Vector
    damping: Matrix
    at: Matrix
    forcing: Vector
    mobility: Matrix
    residual: Matrix
    beyond: Complex
    marks: Matrix = field(default_factory=lambda: np.empty((0, 0)))
    left_out: LeftOut | None = None

    @cached_property
    def is_proportional(self) -> bool:
        """Whether the damping matrix is diagonal in modal coordinates."""
        size = np.abs(self.damping)
        diagonal = size.diagonal().copy()
        np.fill_diagonal(size, 0.0)
        return bool(size.max(initial=0.0) <= 1e-13 * diagonal.max(initial=0.0))

    def in_units(self, mass: float, time: float, length: float) -> "Modal":
        """Return the same body in other units, given in its present ones."""
        root = np.sqrt(mass)
        return Modal(
            self.squares * time**2,
            self.damping * time,
            self.at * root,
            self.forcing * (time**2 / (length * root)),
            self.mobility * mass,
            self.residual * (mass / time**2),
            self.beyond / length,
            self.marks,
        )

    @property
    def kept_mobility(self) -> Matrix:
        """``w^T M^-1 w`` of these shapes."""
        return self.at.T @ self.at


def modal(
    matrices: Mapping[str, Any], modes: int | None, shift: float, jumps: bool = False
) -> Modal:
    """Return a body in its modes, damped by its damping matrix only; see `damped`.

    Parameters
    ----------
    matrices : mapping of str to sparse array
        ``M``, ``K``, ``at`` and, if given, ``C``, ``forcing``; in one system of units.
    modes : int, optional
        How many are kept; without it all.
    shift : float
        What the spectrum is shifted by where a few of many modes are found.
    jumps : bool
        Whether a contact force may jump.

    Returns
    -------
    Modal
        What is left out answers the forcing statically; see `at_frequency`.

    Raises
    ------
    BodyError
        If it is too large for all of its modes, or its eigenvalues are not found.
    """
    M, K, at = matrices["M"], matrices["K"], matrices["at"].toarray()
    n = M.shape[0]
    force = matrices["forcing"].toarray() if "forcing" in matrices else np.zeros((n, 1))
    count = n if modes is None else min(modes, n)
    whole = count == n
    if whole and n > DENSE:
        raise BodyError(f"the body has {n} degrees of freedom: say how many modes are kept")
    factors = None if whole else factored(K + shift * M)
    squares, shapes = natural_modes(M, K, count, shift, factors)
    basis = shapes @ _seen_first(shapes.T @ at, squares == 0)
    left_out = np.zeros((n, at.shape[1] + 1))
    if not whole:
        stiff = solver(K + shift * M, factors)
        left_out = static_answers(M, shapes, np.hstack([at, force]), shift, stiff)
    if not whole and jumps:
        at_contacts = (basis.T @ at) ** 2 / np.where(squares == 0, np.inf, squares)[:, None]
        added, answers = static_shapes(left_out[:, :-1], M, K, at_contacts.sum(axis=0))
        left_out -= answers @ ((answers.T @ np.hstack([at, force])) / added[:, None])
        squares, basis = np.append(squares, added), np.hstack([basis, answers])
    at_contacts, driven = basis.T @ at, basis.T @ force
    damping = np.zeros((len(squares), len(squares)))
    if "C" in matrices:
        damping = basis.T @ exact_product(matrices["C"], basis)[0]
    responds = not whole and {"C", "forcing"} <= matrices.keys()
    coupled = left_out_of(matrices, basis, count) if responds else None
    mobility = at_contacts.T @ at_contacts if whole else at.T @ solver(M)(at)
    compliance = at.T @ left_out
    residual = np.zeros_like(mobility) if jumps else compliance[:, :-1]
    return _without_unseen(
        Modal(
            squares, damping, at_contacts, driven[:, 0], mobility, (residual + residual.T) / 2,
            compliance[:, -1].astype(complex), marks(M, basis), coupled,
        )
    )  # fmt: skip


@lru_cache(maxsize=64)
def facing(body: Modal, other: Modal) -> Modal:
    """Return a body with each shape on the side of that of another body, not opposite to it.

    So its arrays change smoothly with the matrices, as far as the shapes do not turn by more
    than a right angle.
    """
    if body.marks.shape != other.marks.shape:
        return body
    sides = np.where((body.marks * other.marks).sum(axis=1) < 0, -1.0, 1.0)
    if (sides > 0).all():
        return body
    return replace(
        body, damping=body.damping * np.outer(sides, sides), at=body.at * sides[:, None],
        forcing=body.forcing * sides, marks=body.marks * sides[:, None],
    )  # fmt: skip


def damped(body: Modal, ratio: float | None) -> Modal:
    """Return a body with the same damping ratio in all shapes, if one is given."""
    if ratio is None:
        return body
    return replace(body, damping=np.diag(2 * ratio * np.sqrt(np.abs(body.squares))))


def at_frequency(
    body: Modal, matrices: Mapping[str, Any], omega: float, modes: int | None = None
) -> Modal:
    """Return a body whose truncated modes respond dynamically to the forcing.

    That needs the damping matrix; without one their response is static.  `modes` are kept.

    Raises
    ------
    BodyError
        If the forcing is faster than all modes kept: a truncated one may be in resonance.
    """
    n, squares = matrices["M"].shape[0], np.sort(body.squares)[:modes]  # shapes come last
    if modes is not None and modes < n and omega**2 > squares.max():
        raise BodyError("the forcing is faster than all modes that are kept: keep more of them")
    if body.left_out is None or not omega:
        return body
    rows = np.diag(body.squares - omega**2) + 1j * omega * body.damping
    direct, inside = beyond_shapes(body.left_out, matrices, omega, rows, body.forcing)
    return replace(body, beyond=matrices["at"].T @ direct + body.at.T @ inside)


def _seen_first(at: Matrix, free: Indices) -> Matrix:
    """Return a rotation of the rigid-body modes that puts those first which contacts see.

    `at`, shape (m, c), are the modes at the contacts.
    """
    rotation = np.eye(len(at))
    if free.any():
        rotation[np.ix_(free, free)] = np.linalg.svd(at[free])[0]
    return rotation


def _without_unseen(body: Modal) -> Modal:
    """Return a body without the rigid-body modes that neither contacts nor forcing see."""
    sizes, coupling = np.linalg.norm(body.at, axis=1), np.abs(body.damping)
    least = UNSEEN * coupling.max()
    np.fill_diagonal(coupling, 0.0)  # damped by itself it still moves none of the others
    seen = (body.squares != 0) | (sizes > UNSEEN * sizes.max()) | (coupling.max(axis=0) > least)
    return replace(
        body, squares=body.squares[seen], damping=body.damping[np.ix_(seen, seen)],
        at=body.at[seen], forcing=body.forcing[seen], marks=body.marks[seen],
        left_out=body.left_out and LeftOut(*(q[:, seen] for q in body.left_out)),
    )  # fmt: skip
