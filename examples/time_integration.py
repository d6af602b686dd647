"""The orbit against time integration: start in stick, integrate, and compare the cycles.

In stick the mass moves with the belt until the spring reaches the static limit: no integration
is needed.  In slip `scipy.integrate.solve_ivp` integrates equation (1), and an event stops it
where the velocity is the belt's again.  From the first slip on the motion is the limit cycle;
its period and its end of stick are those of the orbit.

Prints::

    cycle 1: stick 0.050000000 s, period 0.521238898 s
    cycle 2: stick 0.200000000 s, period 0.671238898 s
    cycle 3: stick 0.200000000 s, period 0.671238898 s
    ck-tau, N = 9: stick 0.200000000 s, period 0.671238898 s
"""

from scipy.integrate import solve_ivp

import nonsmooth as ns

belt = ns.StickSlip(
    mass=10, stiffness=1000, belt_speed=1, mu_s=0.5, mu_k=0.25, normal_force=400
)


def slip(t: float, state: list[float]) -> list[float]:
    """Return the velocity and, by (1) with kinetic friction, the acceleration."""
    x, velocity = state
    force = belt.mu_k * belt.normal_force - belt.stiffness * x
    return [velocity, force / belt.mass]


def caught(t: float, state: list[float]) -> float:
    """Return the velocity relative to the belt: zero where the mass sticks again."""
    return state[1] - belt.belt_speed


caught.terminal = True
caught.direction = 1

x = 0.15
limit = belt.mu_s * belt.normal_force / belt.stiffness
for cycle in (1, 2, 3):
    stick = (limit - x) / belt.belt_speed
    motion = solve_ivp(
        slip, (0, 10), [limit, belt.belt_speed], events=caught, rtol=1e-11, atol=1e-12
    )
    x = motion.y_events[0][0][0]
    print(f"cycle {cycle}: stick {stick:.9f} s, period {stick + motion.t[-1]:.9f} s")

orbit = ns.solve(belt, tol=1e-12)
print(f"{orbit.method}, N = {orbit.order}: stick {orbit.t1:.9f} s, period {orbit.period:.9f} s")
