"""What all contenders solve: a row of masses, an elastic stop, exact times, rough ones.

The row is a rod of unit length, mass and stiffness in n pieces, driven at the free end, which
meets a stop.  Times are the duration of the contact, that of the free phase, and the phase of
the forcing where the contact begins.
"""

import math
from dataclasses import dataclass
from functools import cache, cached_property

import flint
import numpy as np
import sympy as sp
from scipy.linalg import expm

import nonsmooth as ns
from nonsmooth.scene import Body, Event, Parameter, Phase, Scene
from nonsmooth.solver.scenes.case import Case

#: Stiffness of the stop, its distance, amplitude and frequency of the forcing.
STOP, GAP, FORCE, OMEGA = 10.0, 0.5, 0.4, 1.3

#: Parts of mass and stiffness in the damping.
OF_MASS, OF_STIFFNESS = 0.05, 0.002

#: How rough the times are from which all start: as in `every_scene`.
OFF, ANGLE_OFF = 0.1, 0.3

#: Bits of the reference, and of how many masses it is taken: of more it would take hours.
BITS, FEW = 160, 200


@dataclass(frozen=True)
class Row:
    """A row of n masses with a stop."""

    n: int

    @property
    def name(self) -> str:
        """Of its points."""
        return f"n = {self.n}"

    @property
    def period(self) -> float:
        """Of the forcing."""
        return 2 * math.pi / OMEGA

    @cached_property
    def matrices(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """M, C and K."""
        n = self.n
        K = n * (2 * np.eye(n) - np.eye(n, k=1) - np.eye(n, k=-1))
        K[-1, -1] = n
        M = np.eye(n) / n
        return M, OF_MASS * M + OF_STIFFNESS * K, K

    @cached_property
    def case(self) -> Case:
        """The case of its scene."""
        M, C, K = self.matrices
        end = np.eye(self.n)[-1]
        k, g, Omega = sp.symbols("k g Omega", positive=True)
        body = Body(M=M, C=C, K=K, forcing=FORCE * end, at={"end": end})
        x, force = body.at["end"].x, body.at["end"].force
        touch = Phase("touch", force + k * (x - g), Event(x - g), {"it presses": x - g})
        free = Phase("free", force, Event(x - g), {"it is before the stop": g - x})
        numbers = (
            ("stop", k, "N/m", STOP),
            ("gap", g, "m", GAP),
            ("drive", Omega, "rad/s", OMEGA),
        )
        parameters = tuple(Parameter(*q, q[0]) for q in numbers)
        scene = Scene(
            f"row-{self.n}",
            "a row of masses",
            parameters,
            (touch, free),
            frequency=Omega,
            body=body,
        )
        return ns.scene(scene)()

    @cached_property
    def orbit(self) -> ns.ExactOrbit:
        """Its exact orbit."""
        return ns.exact(self.case)

    def generator(self, pressed: bool) -> np.ndarray:
        """Return A of ``X' = A X`` for q, q', cos, sin, 1."""
        n, (M, C, K) = self.n, self.matrices
        end = np.eye(n)[-1]
        A = np.zeros((2 * n + 3, 2 * n + 3))
        A[:n, n : 2 * n] = np.eye(n)
        stiff = K + pressed * STOP * np.outer(end, end)
        more = [FORCE * end, 0 * end, pressed * STOP * GAP * end]
        A[n : 2 * n] = np.column_stack([-stiff, -C, *more]) / M[0, 0]
        A[-3, -2], A[-2, -3] = -OMEGA, OMEGA
        return A

    def off(self, touch: float, angle: float) -> np.ndarray:
        """Return how far the end is from the stop at both switches, by matrix exponentials."""
        first, second = (
            expm(self.generator(pressed) * s)
            for pressed, s in ((True, touch), (False, self.period - touch))
        )
        own, waves = slice(0, 2 * self.n), [math.cos(angle), math.sin(angle), 1.0]
        period = second @ first
        state = np.linalg.solve(np.eye(2 * self.n) - period[own, own], period[own, -3:] @ waves)
        met = first @ np.concatenate([state, waves])
        return np.array([state[self.n - 1] - GAP, met[self.n - 1] - GAP])

    def off_in_many_digits(self, touch: float, angle: float) -> np.ndarray:
        """Return the same, computed in ball arithmetic."""
        flint.ctx.prec = BITS
        period, size = 2 * flint.arb.pi() / flint.arb(OMEGA), 2 * self.n
        flows = [
            (flint.arb_mat(self.generator(pressed).tolist()) * s).exp()
            for pressed, s in ((True, flint.arb(touch)), (False, period - flint.arb(touch)))
        ]
        waves = flint.arb_mat([[flint.arb(angle).cos()], [flint.arb(angle).sin()], [1]])
        whole = (flows[1] * flows[0]).table()
        left = [[(i == j) - whole[i][j] for j in range(size)] for i in range(size)]
        right = flint.arb_mat([whole[i][size:] for i in range(size)]) * waves
        state = flint.arb_mat(left).solve(right)
        met = flows[0] * flint.arb_mat(state.table() + waves.table())
        return np.array([float(q[self.n - 1, 0] - flint.arb(GAP)) for q in (state, met)])

    @cached_property
    def times(self) -> np.ndarray:
        """The exact times: one step in many digits from those of matrix exponentials.

        Of many masses those of the exact orbit, which these leave where they are: see `off`.
        """
        z = np.array([self.orbit.phases[0].duration, self.orbit.forcing_phase])
        if self.n <= FEW:
            sides = [self.off(*(z + q)) - self.off(*(z - q)) for q in 1e-6 * np.eye(2)]
            slopes = np.array(sides).T / 2e-6
            z = z - np.linalg.solve(slopes, self.off_in_many_digits(*z))
        return np.array([z[0], self.period - z[0], z[1]])

    @property
    def rough(self) -> np.ndarray:
        """The times from which all start."""
        touch, free, angle = self.times * [1 + OFF, 1 - OFF, 1] + [0, 0, ANGLE_OFF]
        scale = self.period / (touch + free)
        return np.array([touch * scale, free * scale, angle])

    def error(self, times: np.ndarray) -> float:
        """Return the largest error of the times as a part of the period, angles over Omega."""
        turn = math.remainder(float(times[2] - self.times[2]), 2 * math.pi) / OMEGA
        return max(*np.abs(times[:2] - self.times[:2]), abs(turn)) / self.period


@cache
def row(n: int) -> Row:
    """Return the row of n masses."""
    return Row(n)
