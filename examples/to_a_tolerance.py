"""The cheapest orbit within a tolerance, and what the program says where there is none.

Every orbit carries an estimate of its own error that does not use the exact orbit; `solve`
with a tolerance takes the first method and order whose estimate is within it.  The last
column is the true error, which this oscillator lets us look up.

Prints::

      tol  method   N  estimate  true error
    1e-02  c1       3   3.2e-03     3.2e-03
    1e-04  c1       5   5.5e-05     5.5e-05
    1e-08  c1       9   7.4e-09     7.4e-09
    1e-12  c1      13   2.9e-13     2.8e-13
    refused: period to 1e-09; the best tried was 2.2e-02 by hb, N = 1;
    hb would need N of about 2e+07
"""

import nonsmooth as ns

belt = ns.StickSlip(
    mass=10, stiffness=1000, belt_speed=1, mu_s=0.5, mu_k=0.25, normal_force=400
)
print("  tol  method   N  estimate  true error")
for tol in (1e-2, 1e-4, 1e-8, 1e-12):
    orbit = ns.solve(belt, tol=tol)
    estimate, true = orbit.estimate.period, abs(orbit.errors.period)
    print(f"{tol:.0e}  {orbit.method:6} {orbit.order:3d}   {estimate:.1e}     {true:.1e}")

try:
    ns.solve(belt, method="hb", tol=1e-9)
except ns.NotCertified as refusal:
    print("refused:", refusal)
