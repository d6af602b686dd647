"""The limit cycle of one oscillator by one method, and its acceleration over a period.

Put the six parameters of your own oscillator in place of these, in SI units.  The orbit that
comes back is converged and admissible; where there is none, `ns.NoOrbit` says why.  The
picture goes to ``orbit.png``.

Prints::

    <stick-slip by c1, N = 7: T = 0.6712383809 s, t1 = 0.2000074538 s, stable, estimate 1.2e-05>
    errors: period -7.7e-07, times 1.2e-05, acceleration (22) 3.7e-03
"""

import nonsmooth as ns

belt = ns.StickSlip(
    mass=10, stiffness=1000, belt_speed=1, mu_s=0.5, mu_k=0.25, normal_force=400
)
orbit = ns.solve(belt, method="c1", order=7)
print(orbit)
errors = orbit.errors
print(
    f"errors: period {errors.period:.1e}, times {errors.times:.1e}, "
    f"acceleration (22) {errors.acceleration:.1e}"
)

axes = ns.plot([ns.exact(belt), orbit], quantity="acceleration")
axes.figure.savefig("orbit.png", dpi=200)
