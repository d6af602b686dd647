"""A body in balls: its poles, what its contacts see of them, and the laws as forms of these."""

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
    """Forms as ``Re sum poles z + Re(turn e^(i theta)) + constant + memory + direct force``.

    Parameters
    ----------
    poles : ndarray of acb, shape (k, m)
    turn : ndarray of acb, shape (k,)
    constant : ndarray of arb, shape (k,)
    memory : ndarray of arb, shape (k, M)
    direct : ndarray of arb, shape (k, c)
        By the contact forces.
    """

    poles: Balls
    turn: Balls
    constant: Balls
    memory: Balls
    direct: Balls

    def less(self, weights: Balls, others: "Forms") -> "Forms":
        """Return these forms less combinations of others."""
        return Forms(*(a - weights @ b for a, b in zip(self, others, strict=True)))


def balls(values: Any) -> Balls:
    """Return an array of the exact values of float64 numbers."""
    values = np.asarray(values)
    make = acb if values.dtype == complex else arb
    return np.array([make(q) for q in values.ravel().tolist()], dtype=object).reshape(
        values.shape
    )


def real(values: Balls) -> Balls:
    """Return the real parts of an array."""
    flat = [acb(q).real for q in values.ravel()]
    return np.array(flat, dtype=object).reshape(values.shape)


def solved(A: Balls, right: Balls) -> Balls:
    """Return the solution of a linear system, real or complex.

    Not numbers if the matrix may be singular: in more digits it may not.
    """
    real = all(isinstance(q, arb) for q in (*A.flat, *right.flat))
    matrix: Any = arb_mat if real else acb_mat
    try:
        found = matrix(A.tolist()).solve(matrix(right.tolist()))
    except ZeroDivisionError:
        return np.full(right.shape, arb("nan"))
    return np.array(found.tolist(), dtype=object).reshape(right.shape)


class Body:
    """The poles of the body of a cell, of each pair the one above the real axis.

    Parameters
    ----------
    cell : BodyCell
    held : Held, optional
        Springs and dampers that hold it at its contacts: then its poles are of both, and a
        contact force has what they take from it added.
    """

    def __init__(self, cell: "BodyCell", held: "Held | None" = None) -> None:
        self.modal, self.held = cell.body, held
        self.omega: Any = arb(cell.omega)
        self.turns = 2 * arb.pi() * cell.cycles / cell.cells  # of the forcing in the cell

    @property
    def duration(self) -> Any:
        """That of the cell, by its forcing."""
        return self.turns / self.omega

    @cached_property
    def poles(self) -> tuple[Balls, Balls, Balls]:
        """The poles, shape (m,); by the forces, (m, c); displacements by them, (m, c).

        ``z' = s z + b force``, and ``x = Re sum c z``.
        """
        proportional = self.modal.is_proportional and self.held is None
        return self._of_modes() if proportional else self._of_states()

    def _of_modes(self) -> tuple[Balls, Balls, Balls]:
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
        count, at = len(self.modal.squares), balls(self.modal.at)
        A = balls(np.zeros((2 * count, 2 * count)))
        A[:count, count:] = balls(np.eye(count))
        A[count:, :count] = balls(np.diag(-self.modal.squares))
        A[count:, count:] = balls(-self.modal.damping)
        for part, held in zip((slice(count), slice(count, None)), self._holding, strict=True):
            A[count:, part] = A[count:, part] - held
        try:
            s, basis = acb_mat(A.tolist()).eig(right=True)
        except ValueError:
            raise PrecisionError("the poles of the body are not told apart") from None
        basis = np.array(basis.tolist(), dtype=object)
        forced = np.concatenate([balls(np.zeros(at.shape)), at])
        b, c = solved(basis, forced), basis[:count].T @ at
        real = np.array([q.imag.contains(0) for q in s])
        kept = real | np.array([bool(q.imag > 0) for q in s])
        for i, row in enumerate(c):  # a place that nothing holds or sees has a pole at 0
            kept[i] &= not all(q.contains(0) for q in (s[i], *row))
        double = np.where(real, 1, 2)[kept, None]
        return np.array(s, dtype=object)[kept], b[kept], c[kept] * double

    @cached_property
    def response(self) -> Balls:
        """The complex amplitudes of the contacts in the answer to the forcing."""
        body, turn = self.modal, acb(0, 1) * self.omega
        squares, damping = balls(np.diag(body.squares)), balls(body.damping)
        springs, dampers = self._holding
        A = squares + springs + turn * (damping + dampers)
        A = A + turn * turn * balls(np.eye(len(squares)))
        found = solved(A, balls(body.forcing.astype(complex))[:, None])[:, 0]
        return balls(body.at).T @ found + balls(body.beyond)

    @property
    def _holding(self) -> tuple[Balls, Balls]:
        """The stiffness and the damping that hold it, by its modes."""
        at, zero = balls(self.modal.at), np.zeros(self.modal.at.shape[1])
        held = (zero, zero) if self.held is None else (self.held.springs, self.held.dampers)
        springs, dampers = (at * balls(q) @ at.T for q in held)
        return springs, dampers

    def forms(self, rows: Balls) -> Forms:
        """Return linear forms of what is seen, given as a cell has them."""
        s, _, c = self.poles
        contacts = c.shape[1]
        width, rates = 2 + 4 * contacts, np.append(s, acb(0, 1) * self.omega)
        place, residual = np.column_stack([c.T, self.response]), balls(self.modal.residual)
        seen = balls(np.zeros((width, len(rates))))
        direct = balls(np.zeros((width, contacts)))
        x, v, force, a = places(contacts)
        for order, which in enumerate((x, v, a)):
            seen[which] = place * rates**order
        seen[2, -1] = arb(1)
        direct[x], direct[force] = residual, balls(np.eye(contacts))
        direct[a] = balls(self.modal.at).T @ balls(self.modal.at)
        if self.held is not None:  # of what is left out nothing is held
            springs, dampers = (
                balls(q)[:, None] for q in (self.held.springs, self.held.dampers)
            )
            place[:, -1] = place[:, -1] - balls(self.modal.beyond)
            taken = place * (springs + dampers * rates)
            seen[force], seen[x] = -taken, seen[x] - residual @ taken
        own, memory = rows[:, :width], rows[:, width:]
        found = own @ seen
        return Forms(found[:, :-1], found[:, -1], rows[:, 3], memory, own @ direct)

    def event(self, phase: "BodyPhase") -> Forms:
        """Return the event at the end of a phase, with the contact forces by their laws."""
        return closed(self.forms(balls([phase.event])), self.forms(laws(phase)))


def laws(phase: "BodyPhase") -> Balls:
    """Return the laws of a phase by row; of a held contact, that it has its speed as well."""
    found = balls(np.array(phase.laws, dtype=float))
    if phase.held:
        found[0, 1] += found[0, 5]
        found[0, 3] -= found[0, 5] * arb(phase.speed)
    return found


def closed(own: Forms, law: Forms) -> Forms:
    """Return forms with the contact forces by their laws."""
    return own.less(solved(law.direct.T, own.direct.T).T, law)


def impulses(cell: "BodyCell", p: int) -> tuple[list[int], Balls, Balls, Balls]:
    """Return ``mobility J = factors v + constants`` at the end of a phase.

    Returns
    -------
    hit : list of int
        The contacts that an impulse meets.
    mobility, factors, constants : ndarray of arb
        Of these contacts.
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
    """Return forms, without forces and memory, of states: rows over unknowns, what is known.

    `states`, of shape (m, U), are the poles by each unknown; `angle` is that of the forcing.
    """
    turned = (acb(0, 1) * angle).exp()
    return real(forms.poles @ states), real(forms.turn * turned) + forms.constant


def statements(
    cell: "BodyCell", body: Body, values: Callable[[Forms, int, int], tuple[Balls, Balls]]
) -> Iterator[tuple[Balls, Any]]:
    """Yield what each impulse is, then each memory: a row over the unknowns, what is known.

    Parameters
    ----------
    cell : BodyCell
    body : Body
    values : callable
        Returns rows of forms and what is known of them at an end, 0 or 1, of a phase.
    """
    contacts, memory = cell.body.at.shape[1], len(cell.memory)
    velocity = body.forms(balls(np.eye(2 + 4 * contacts + memory)[places(contacts)[1]]))
    for p in range(len(cell.phases)):
        hit, mobility, factors, constants = impulses(cell, p)
        if hit:
            rows, rest = values(velocity, p, 1)
            moved = (factors * rest[hit] + constants)[:, None]
            right = np.hstack([factors[:, None] * rows[hit], moved])
            for *row, known in solved(mobility.astype(object), right):
                yield np.array(row, dtype=object), known
    for each in cell.memory:
        form = balls([[*each.value[: 2 + 4 * contacts], *([0.0] * memory)]])
        (row,), (known,) = values(body.forms(form), each.phase, 0)
        yield row, known
