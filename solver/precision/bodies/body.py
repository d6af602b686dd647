"""A body in balls: its poles, and contact quantities and laws as linear forms of them."""

from collections.abc import Callable, Iterator
from functools import cached_property
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from flint import acb, acb_mat, arb, arb_mat

from ...bodies.laws import places
from ..refine import PrecisionError

if TYPE_CHECKING:
    from ...bodies.poles import Held
    from ...scenes.bodies.cell import BodyCell, BodyPhase

#: An array of balls.
Balls = Any


class Forms(NamedTuple):
    """Forms ``Re sum poles z + Re(turn e^(i theta)) + constant + memory h + direct force``.

    Parameters
    ----------
    poles : ndarray of acb, shape (k, m)
        Factors of the states z of the poles.
    turn : ndarray of acb, shape (k,)
        Factor of the forcing; theta is its phase.
    constant : ndarray of arb, shape (k,)
    memory : ndarray of arb, shape (k, M)
        Factors of the memories h.
    direct : ndarray of arb, shape (k, c)
        Factors of the contact forces.
    """

    poles: Balls
    turn: Balls
    constant: Balls
    memory: Balls
    direct: Balls

    def less(self, weights: Balls, others: "Forms") -> "Forms":
        """Return these forms less ``weights @ others``."""
        return Forms(*(a - weights @ b for a, b in zip(self, others, strict=True)))


def balls(values: Any) -> Balls:
    """Return an array of the exact values of float64 numbers."""
    ball = acb if np.iscomplexobj(values) else arb
    return np.frompyfunc(ball, 1, 1)(values)


#: The real parts of an array, and its complex conjugates.
real: Callable[[Balls], Balls] = np.frompyfunc(lambda q: acb(q).real, 1, 1)
conjugate: Callable[[Balls], Balls] = np.frompyfunc(lambda q: acb(q).conjugate(), 1, 1)


def solved(A: Balls, right: Balls) -> Balls:
    """Return the solution of a linear system, real or complex.

    It is NaN if the matrix may be singular at the precision in force.
    """
    real = all(isinstance(q, arb) for q in (*A.flat, *right.flat))
    matrix: Any = arb_mat if real else acb_mat
    try:
        solution = matrix(A.tolist()).solve(matrix(right.tolist()))
    except ZeroDivisionError:
        return np.full(right.shape, arb("nan"))
    return np.array(solution.tolist(), dtype=object).reshape(right.shape)


class Body:
    """The body of a cell by its poles, one of each complex pair.

    Parameters
    ----------
    cell : BodyCell
    held : Held, optional
        Springs and dampers at the contacts that are added to the body: the poles are those of
        both, and contact forces are corrected for them.
    """

    def __init__(self, cell: "BodyCell", held: "Held | None" = None) -> None:
        self.modal, self.held = cell.body, held
        self.omega: Any = arb(cell.omega)
        self.turns = 2 * arb.pi() * cell.cycles / cell.cells  # of the forcing in the cell

    @property
    def duration(self) -> Any:
        """Duration of a forced cell."""
        return self.turns / self.omega

    @cached_property
    def poles(self) -> tuple[Balls, Balls, Balls]:
        """Poles, shape (m,), their forces, (m, c), and displacements by them, (m, c).

        These are s, b and c of ``z' = s z + b force``, ``x = Re sum c z``.
        """
        proportional = self.modal.is_proportional and self.held is None
        return self._of_modes() if proportional else self._of_states()

    def _of_modes(self) -> tuple[Balls, Balls, Balls]:
        """Return the poles of a body with modal damping, mode by mode."""
        rows: list[tuple[Any, Any, Any]] = []
        at = balls(self.modal.at)
        for i, square in enumerate(balls(self.modal.squares)):
            half = arb(float(self.modal.damping[i, i])) / 2
            root = acb(half * half - square).sqrt()
            if root.contains(0):
                raise PrecisionError("two poles of the body may be one")
            pair = bool(square > half * half)
            rows.append((root - half, at[i], at[i] / root / (1 if pair else 2)))
            if not pair:
                rows.append((-root - half, at[i], -at[i] / root / 2))
        s, b, c = (np.array(q, dtype=object) for q in zip(*rows, strict=True))
        return s, b, c

    def _of_states(self) -> tuple[Balls, Balls, Balls]:
        """Return the poles as eigenvalues of the state matrix."""
        count, at = len(self.modal.squares), balls(self.modal.at)
        A = balls(np.zeros((2 * count, 2 * count)))
        A[:count, count:] = balls(np.eye(count))
        A[count:, :count] = balls(np.diag(-self.modal.squares))
        A[count:, count:] = balls(-self.modal.damping)
        for part, block in zip((slice(count), slice(count, None)), self._holding, strict=True):
            A[count:, part] -= block
        try:
            s, basis = acb_mat(A.tolist()).eig(right=True)
        except ValueError:
            raise PrecisionError("the poles of the body are not told apart") from None
        basis = np.array(basis.tolist(), dtype=object)
        forced = np.concatenate([balls(np.zeros(at.shape)), at])
        b, c = solved(basis, forced), basis[:count].T @ at
        real = np.array([q.imag.contains(0) for q in s])
        upper = real | np.array([bool(q.imag > 0) for q in s])
        for i, row in enumerate(c):  # drop poles at 0 that no contact sees
            upper[i] &= not all(q.contains(0) for q in (s[i], *row))
        double = np.where(real, 1, 2)[upper, None]
        return np.array(s, dtype=object)[upper], b[upper], c[upper] * double

    @cached_property
    def response(self) -> Balls:
        """Complex amplitudes of the contacts in the steady response to the forcing."""
        body, turn = self.modal, acb(0, 1) * self.omega
        squares, damping = balls(np.diag(body.squares)), balls(body.damping)
        springs, dampers = self._holding
        A = squares + springs + turn * (damping + dampers)
        A = A + turn * turn * balls(np.eye(len(squares)))
        amplitudes = solved(A, balls(body.forcing.astype(complex))[:, None])[:, 0]
        return balls(body.at).T @ amplitudes + balls(body.beyond)

    @property
    def _holding(self) -> tuple[Balls, Balls]:
        """Matrices of the added springs and dampers, in modal coordinates."""
        at, zero = balls(self.modal.at), np.zeros(self.modal.at.shape[1])
        factors = (zero, zero) if self.held is None else (self.held.springs, self.held.dampers)
        springs, dampers = (at * balls(q) @ at.T for q in factors)
        return springs, dampers

    def forms(self, rows: Balls) -> Forms:
        """Return the forms of a cell, given as rows of factors, as forms of the poles."""
        s, _, c = self.poles
        contacts = c.shape[1]
        width, rates = 2 + 4 * contacts, np.append(s, acb(0, 1) * self.omega)
        place, residual = np.column_stack([c.T, self.response]), balls(self.modal.residual)
        variables = balls(np.zeros((width, len(rates))))
        direct = balls(np.zeros((width, contacts)))
        x, v, force, a = places(contacts)
        for order, which in enumerate((x, v, a)):
            variables[which] = place * rates**order
        variables[2, -1] = arb(1)
        direct[x], direct[force] = residual, balls(np.eye(contacts))
        direct[a] = balls(self.modal.at).T @ balls(self.modal.at)
        if self.held is not None:  # of what is left out nothing is held
            springs, dampers = (
                balls(q)[:, None] for q in (self.held.springs, self.held.dampers)
            )
            place[:, -1] -= balls(self.modal.beyond)
            reaction = place * (springs + dampers * rates)
            variables[force], variables[x] = -reaction, variables[x] - residual @ reaction
        factors, memory = rows[:, :width], rows[:, width:]
        of_rates = factors @ variables
        return Forms(of_rates[:, :-1], of_rates[:, -1], rows[:, 3], memory, factors @ direct)

    def event(self, phase: "BodyPhase") -> Forms:
        """Return the event at the end of a phase, contact forces eliminated by the laws."""
        return closed(self.forms(balls([phase.event])), self.forms(laws(phase)))


def laws(phase: "BodyPhase") -> Balls:
    """Return the laws of a phase as rows; that of a held contact with its velocity added."""
    rows = balls(np.array(phase.laws, dtype=float))
    if phase.held:
        rows[0, 1] += rows[0, 5]
        rows[0, 3] -= rows[0, 5] * arb(phase.speed)
    return rows


def closed(forms: Forms, law: Forms) -> Forms:
    """Return forms with the contact forces eliminated by their laws."""
    return forms.less(solved(law.direct.T, forms.direct.T).T, law)


def impulses(cell: "BodyCell", p: int) -> tuple[list[int], Balls, Balls, Balls]:
    """Return ``mobility J = factors v + constants`` at the end of a phase.

    Returns
    -------
    hit : list of int
        The contacts with an impulse J.
    mobility, factors, constants : ndarray of arb
        For these contacts; v are their velocities before.
    """
    jumps, last = list(cell.phases[p].jumps), p == len(cell.phases) - 1
    after = cell.phases[0 if last else p + 1]
    whole = balls(cell.body.mobility)
    if after.held:
        jumps[0] = (0.0, (cell.sign if last else 1) * after.speed)
        at = balls(cell.body.at)
        whole = at.T @ at
    hit = [i for i, jump in enumerate(jumps) if jump != (1.0, 0.0)]
    factors = balls(np.array([jumps[i][0] for i in hit], dtype=float)) - 1
    constants = balls(np.array([jumps[i][1] for i in hit], dtype=float))
    return hit, whole[np.ix_(hit, hit)], factors, constants


def at_end(forms: Forms, states: Balls, angle: Any) -> tuple[Balls, Balls]:
    """Return the rows over unknowns, and the known part, of forms without forces and memories.

    `states`, of shape (m, U), are the derivatives of z by each unknown; `angle` is the phase of
    the forcing.
    """
    turned = (acb(0, 1) * angle).exp()
    return real(forms.poles @ states), real(forms.turn * turned) + forms.constant


def statements(
    cell: "BodyCell", body: Body, values: Callable[[Forms, int, int], tuple[Balls, Balls]]
) -> Iterator[tuple[Balls, Any]]:
    """Yield each impulse, then each memory, as a row over the unknowns and a known part.

    Parameters
    ----------
    cell : BodyCell
    body : Body
    values : callable
        ``values(forms, p, end)``: rows and known parts of forms at begin (0) or end (1) of a
        phase.
    """
    contacts, memory = cell.body.at.shape[1], len(cell.memory)
    velocity = body.forms(balls(np.eye(2 + 4 * contacts + memory)[places(contacts)[1]]))
    for p in range(len(cell.phases)):
        hit, mobility, factors, constants = impulses(cell, p)
        if hit:
            rows, offsets = values(velocity, p, 1)
            moved = (factors * offsets[hit] + constants)[:, None]
            right = np.hstack([factors[:, None] * rows[hit], moved])
            for *row, offset in solved(mobility.astype(object), right):
                yield np.array(row, dtype=object), offset
    for remembered in cell.memory:
        form = balls([[*remembered.value[: 2 + 4 * contacts], *([0.0] * memory)]])
        (row,), (offset,) = values(body.forms(form), remembered.phase, 0)
        yield row, offset
