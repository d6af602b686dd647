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
from .modes import DENSE, marks, natural_modes, signs
from .systems import BodyError, Solve, exact_product, factored, solver

#: What a contact, or a damper, may see of a mode that it does not see, as a part.
UNSEEN = 1e-11

#: Steps in which the static answer of the modes left out is found.
STEPS = 200

#: What of that answer rounding may go on changing, as a part.
BY_ROUNDING = 1e-9

#: What of the compliance at a contact is rounding, as a part; and what of a static answer is
#: new beside the others.
STIFF, NEW = 1e-12, 1e-10


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
    """

    squares: Vector
    damping: Matrix
    at: Matrix
    forcing: Vector
    mobility: Matrix
    residual: Matrix
    beyond: Complex
    marks: Matrix = field(default_factory=lambda: np.empty((0, 0)))

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
        left_out = _left_out(M, shapes, np.hstack([at, force]), shift, stiff)
    if not whole and jumps:
        at_contacts = (basis.T @ at) ** 2 / np.where(squares == 0, np.inf, squares)[:, None]
        added, answers = _static_shapes(left_out[:, :-1], M, K, at_contacts.sum(axis=0))
        left_out -= answers @ ((answers.T @ np.hstack([at, force])) / added[:, None])
        squares, basis = np.append(squares, added), np.hstack([basis, answers])
    at_contacts, driven = basis.T @ at, basis.T @ force
    damping = np.zeros((len(squares), len(squares)))
    if "C" in matrices:
        damping = basis.T @ exact_product(matrices["C"], basis)[0]
    mobility = at_contacts.T @ at_contacts if whole else at.T @ solver(M)(at)
    compliance = at.T @ left_out
    residual = np.zeros_like(mobility) if jumps else compliance[:, :-1]
    return _without_unseen(
        Modal(
            squares, damping, at_contacts, driven[:, 0], mobility, (residual + residual.T) / 2,
            compliance[:, -1].astype(complex), marks(M, basis),
        )
    )  # fmt: skip


def _static_shapes(
    left_out: Matrix, M: Any, K: Any, compliances: Vector
) -> tuple[Vector, Matrix]:
    """Return static answers as shapes with unit mass, and the squares of their frequencies.

    Parameters
    ----------
    left_out : ndarray, shape (n, c)
        What the modes that are left out answer to a unit force at each contact.
    M, K : sparse array, shape (n, n)
    compliances : ndarray, shape (c,)
        By how much each contact gives way without them.

    Returns
    -------
    squares : ndarray, shape (a,)
        Fewer than contacts where answers are rounding, or combinations of others.
    shapes : ndarray, shape (n, a)
    """
    stiff, mass = left_out.T @ (K @ left_out), left_out.T @ (M @ left_out)
    strong = np.diag(stiff) > STIFF * compliances
    sizes = np.sqrt(np.diag(stiff)[strong])
    values, vectors = np.linalg.eigh(stiff[np.ix_(strong, strong)] / np.outer(sizes, sizes))
    new = values > NEW
    basis = vectors[:, new] / sizes[:, None] / np.sqrt(values[new])  # of unit stiffness
    values, vectors = np.linalg.eigh(basis.T @ mass[np.ix_(strong, strong)] @ basis)
    shapes = left_out[:, strong] @ basis @ vectors / np.sqrt(values)
    return 1 / values, shapes * signs(shapes)


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
    from scipy import sparse  # noqa: PLC0415  (a scene of one mass needs none)

    n = matrices["M"].shape[0]
    few, squares = len(body.squares) < n, np.sort(body.squares)[:modes]  # shapes come last
    if modes is not None and modes < n and omega**2 > squares.max():
        raise BodyError("the forcing is faster than all modes that are kept: keep more of them")
    if not (few and omega and "C" in matrices and "forcing" in matrices):
        return body
    rows = np.diag(body.squares - omega**2) + 1j * omega * body.damping
    retained = body.at.T @ np.linalg.solve(rows, body.forcing.astype(complex))
    at, force = matrices["at"].toarray(), matrices["forcing"].toarray()
    stiff, damping = (matrices["K"] - omega**2 * matrices["M"], -omega * matrices["C"])
    full = sparse.block_array([[stiff, damping], [damping, -stiff]], format="csr")  # Re, Im
    real, imag = np.split(solver(full)(np.vstack([force, 0 * force]))[:, 0], 2)
    return replace(body, beyond=at.T @ real + 1j * (at.T @ imag) - retained)


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
    )  # fmt: skip


def _left_out(M: Any, shapes: Matrix, right: Matrix, shift: float, stiff: Solve) -> Matrix:
    """Return the static response of the truncated modes.

    By ``1/w^2 = 1/(w^2 + shift) (1 + shift/w^2)``, repeated, since K may be singular.
    """

    def without(q: Matrix) -> Matrix:
        return np.asarray(q - shapes @ (shapes.T @ (M @ q)))

    first = without(stiff(right - M @ (shapes @ (shapes.T @ right))))
    response, last = first, np.inf
    for _ in range(STEPS):
        before, response = response, first + shift * without(stiff(M @ response))
        change, size = np.abs(response - before).max(), np.abs(response).max()
        if change <= 4 * np.finfo(float).eps * size or last <= change <= BY_ROUNDING * size:
            return response
        last = change
    raise BodyError("the modes left out are too slow for the forcing: keep more of them")
