"""The limit cycle of one oscillator by one method, and its acceleration over a period.

Put the six parameters of your own oscillator in place of these, in SI units.  The orbit that
comes back is converged and admissible; where there is none, `ns.NoOrbit` says why.  The
picture goes to ``orbit.png``.

Prints::

    c1 (Section 3.3, C1 functions), N = 7
      T  = 0.6712383809 s   (T/T_exact - 1 = -7.705e-07)
      t1 = 0.2000074538 s   (t1/t1_exact - 1 = 3.727e-05)
      acceleration error (22) = 3.650e-03
        with phases aligned   = 9.666e-05
      transition mismatch     = 3.727e-05
      estimated error of T    = 7.7e-07
      residual 1.7e-16 after 5 iterations; admissible
"""

import nonsmooth as ns

belt = ns.StickSlip(
    mass=10, stiffness=1000, belt_speed=1, mu_s=0.5, mu_k=0.25, normal_force=400
)
orbit = ns.solve(belt, method="c1", order=7)
print(orbit)

axes = ns.plot([ns.exact(belt), orbit], quantity="acceleration")
axes.figure.savefig("orbit.png", dpi=200)
