"""An independent check of an orbit: each of its phases by SciPy, to the event that ends it.

Of the impact oscillator here, and of every scene of the cookbook.  Prints::

    SciPy's switches are 2e-12 s from those of the orbit;
    a period later the state is 6e-16 m and 2e-12 m/s off
"""

from collections.abc import Callable
from typing import Any

import numpy as np
from scipy.integrate import solve_ivp

import nonsmooth as ns

#: Of a phase: acceleration and event as functions of t, x, v; what becomes of v at its end.
Law = tuple[Callable[..., Any], Callable[..., Any], Callable[[float], float]]


def compare(orbit: Any, *laws: Law) -> None:
    """Print how far an orbit is from SciPy's solution of its phases, a law each.

    That is by how much the times of its switches differ, and the state at the end of a period
    from that at its beginning.
    """
    first, t = orbit.phases[0], 0.0
    state, off = np.array([first.displacement, first.velocity]), 0.0
    for phase, (acceleration, event, jump) in zip(orbit.phases, laws, strict=True):

        def right_side(t: float, y: Any, acceleration: Any = acceleration) -> Any:
            return y[1], acceleration(t, *y)

        def ends(t: float, y: Any, event: Any = event) -> Any:
            return event(t, *y)

        ends.terminal = True  # type: ignore[attr-defined]
        end, options = t + phase.duration, {"method": "DOP853", "rtol": 1e-12, "atol": 1e-13}
        middle = (t + end) / 2  # its event is met anew, not where the phase begins
        half = solve_ivp(right_side, (t, middle), state, **options)
        rest = solve_ivp(
            right_side, (middle, 2 * end - middle), half.y[:, -1], events=ends, **options
        )
        t, state = rest.t[-1], rest.y[:, -1]
        off, state[1] = max(off, abs(t - end)), jump(state[1])
    back = np.abs(state - [first.displacement, first.velocity])
    print(f"SciPy's switches are {off:.0e} s from those of the orbit;")
    print(f"a period later the state is {back[0]:.0e} m and {back[1]:.0e} m/s off")


def main() -> None:
    """Compare the default orbit of the impact oscillator."""
    orbit = ns.solve(ns.scene("impact")(), tol=1e-12)
    turn = orbit.forcing_phase
    compare(
        orbit,
        (
            lambda t, x, v: np.cos(1.8 * t + turn) - 0.1 * v - x,
            lambda t, x, v: x - 0.1,
            lambda v: -0.6 * v,
        ),
    )


if __name__ == "__main__":
    main()
