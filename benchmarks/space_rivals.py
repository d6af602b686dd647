"""The finite-element rival: Hermite beam elements or linear ones, by scikit-fem.

Uniform elements, with a node at the attachment or as near to it as none is: then the attachment
sits inside an element, and the mesh does not know where the mode breaks.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.linalg import eigh

from nonsmooth.solver.space.attached import Attached


@dataclass(frozen=True)
class Rival:
    """One finite-element model: its lowest eigenvalue and how many unknowns it has."""

    unknowns: int
    eigenvalue: float


def finite_elements(attached: Attached, elements: int, node: bool) -> Rival:
    """Return the lowest eigenvalue by finite elements.

    Parameters
    ----------
    attached : Attached
        Not a crack without a node at it: that cannot be built.
    elements : int
        With a node at the attachment their number on each side is in proportion.
    node : bool
        Whether one node is at the attachment.

    Raises
    ------
    ValueError
        If a crack is to be inside an element.
    """
    import skfem
    from skfem.helpers import d, dd

    structure, a, s = attached.structure, float(attached.a), attached.s
    compliant = structure.kind == "compliance"
    if compliant and not node:
        raise ValueError("a crack inside an element has no slope jump")
    mesh = skfem.MeshLine(_nodes(a, elements, node))
    beam = structure.m == 2
    element = skfem.ElementLineHermite() if beam else skfem.ElementLineP1()
    basis = skfem.Basis(mesh, element, intorder=8)
    curve: Callable[[Any], Any] = dd if beam else d
    stiff = skfem.BilinearForm(lambda u, v, w: _inner(curve(u), curve(v), beam)).assemble(basis)
    mass = skfem.BilinearForm(lambda u, v, w: u * v).assemble(basis)
    K, M = stiff.toarray(), mass.toarray()
    fixed = basis.get_dofs().all("u") if beam else basis.get_dofs().all()
    if compliant:
        K, M, fixed = _hinged(K, M, fixed, basis, mesh, a, s)
    else:
        felt = _felt(basis, mesh, a, structure.felt, beam)
        if structure.kind == "stiffness":
            K = K + s * np.outer(felt, felt)
        else:
            M = M + s * np.outer(felt, felt)
    free = np.setdiff1d(np.arange(len(K)), fixed)
    inside = np.ix_(free, free)
    # the inverse keeps the digits of the lowest
    largest = eigh(M[inside], K[inside], eigvals_only=True)[-1]
    return Rival(len(free), float(1 / largest))


def _inner(u: Any, v: Any, beam: bool) -> Any:
    return u[0, 0] * v[0, 0] if beam else u[0] * v[0]


def _nodes(a: float, elements: int, node: bool) -> Any:
    if node:
        left = max(1, round(a * elements))
        right = max(1, elements - left)
        return np.append(np.linspace(0, a, left + 1), np.linspace(a, 1, right + 1)[1:])
    found = np.linspace(0, 1, elements + 1)
    if np.abs(found - a).min() < 1e-9:
        return np.linspace(0, 1, elements + 2)
    return found


def _felt(basis: Any, mesh: Any, a: float, derivative: int, beam: bool) -> Any:
    """Return what each unknown contributes to a derivative of the displacement at `a`."""
    nodes = np.sort(mesh.p[0])
    place = int(np.clip(np.searchsorted(nodes, a) - 1, 0, len(nodes) - 2))
    order = np.argsort(mesh.p[0])
    first, second = order[place], order[place + 1]
    start, h = nodes[place], nodes[place + 1] - nodes[place]
    v, found = (a - start) / h, np.zeros(basis.N)
    if not beam:
        rows = {0: (1 - v, v)}[derivative]
        for vertex, value in zip((first, second), rows, strict=True):
            found[basis.nodal_dofs[0, vertex]] = value
        return found
    rows = {
        0: (
            1 - 3 * v**2 + 2 * v**3,
            h * v * (1 - v) ** 2,
            3 * v**2 - 2 * v**3,
            h * v**2 * (v - 1),
        ),
        1: (6 * (v**2 - v) / h, 1 - 4 * v + 3 * v**2, 6 * (v - v**2) / h, 3 * v**2 - 2 * v),
    }[derivative]
    for n, vertex in enumerate((first, second)):
        found[basis.nodal_dofs[0, vertex]] = rows[2 * n]
        found[basis.nodal_dofs[1, vertex]] = rows[2 * n + 1]
    return found


def _hinged(K: Any, M: Any, fixed: Any, basis: Any, mesh: Any, a: float, s: float) -> Any:
    """Return the matrices with two slopes at the node of a crack, a spring between them."""
    vertex = int(np.argmin(np.abs(mesh.p[0] - a)))
    slope = int(basis.nodal_dofs[1, vertex])
    right = int(np.flatnonzero(np.isclose(mesh.p[0][mesh.t[0]], a))[0])
    size = len(K)
    import skfem
    from skfem.helpers import dd

    # the element right of the crack, by itself, hands its slope to a new unknown
    part = skfem.Basis(mesh, skfem.ElementLineHermite(), elements=np.array([right]), intorder=8)
    found = []
    for whole, form in (
        (K, skfem.BilinearForm(lambda u, v, w: dd(u)[0, 0] * dd(v)[0, 0])),
        (M, skfem.BilinearForm(lambda u, v, w: u * v)),
    ):
        one = form.assemble(part).toarray()
        matrix = np.zeros((size + 1, size + 1))
        matrix[:size, :size] = whole - one
        index = np.arange(size)
        index[slope] = size
        matrix[np.ix_(index, index)] += one
        found.append(matrix)
    stiff, mass = found
    stiff[[slope, size], [slope, size]] += 1 / s
    stiff[[slope, size], [size, slope]] -= 1 / s
    return stiff, mass, fixed
