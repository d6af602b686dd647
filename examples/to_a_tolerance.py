"""The lowest order within a tolerance, and what the program says where there is none.

Every orbit carries an estimate of its own errors that does not use the exact orbit; `solve`
with a tolerance takes the lowest order whose estimate is within it.  The last column is the
true error, which this oscillator lets us look up.

Prints::

      tol   N  estimate  true error
    1e-02   3   2.2e-04     2.2e-04
    1e-04   5   2.8e-07     2.8e-07
    1e-08   7   1.2e-10     1.2e-10
    1e-12   9   2.3e-14     1.9e-14
    refused: times to 1e-09; the best tried was 6.2e-03 by hb, N = 16; it would need N of about
    2e+08
"""

import nonsmooth as ns

belt = ns.StickSlip(
    mass=10, stiffness=1000, belt_speed=1, mu_s=0.5, mu_k=0.25, normal_force=400
)
print("  tol   N  estimate  true error")
for tol in (1e-2, 1e-4, 1e-8, 1e-12):
    orbit = ns.solve(belt, tol=tol)
    estimate, true = orbit.estimate.times, orbit.errors.times
    print(f"{tol:.0e} {orbit.order:3d}   {estimate:.1e}     {true:.1e}")

try:
    ns.solve(belt, method="hb", tol=1e-9)
except ns.NotCertified as refusal:
    print("refused:", refusal)
