"""A convergence study for a paper: errors of period and acceleration of the three methods.

Solves every method at the orders 1 to 40, prints the rates measured over the upper half of
the orders, and writes the figure as ``convergence.pdf`` and its numbers as
``convergence.csv``.  An order at which a method has no orbit is a row without numbers.

Prints::

    <sweep of stick-slip by hb, hb-c1, c1: 120 rows, 120 orbits>
    hb     period N^-0.932      acceleration N^-0.508
    hb-c1  period N^-2.791      acceleration N^-1.451
    c1     period 10^(-0.95 N)  acceleration 10^(-0.51 N)
"""

import matplotlib.pyplot as plt

import nonsmooth as ns

belt = ns.StickSlip(
    mass=10, stiffness=1000, belt_speed=1, mu_s=0.5, mu_k=0.25, normal_force=400
)
sweep = ns.sweep(belt, orders=range(1, 41))
print(repr(sweep))
for method, rate in sweep.rates().items():
    period, acceleration = rate.text("period"), rate.text("acceleration")
    print(f"{method:6} period {period:13} acceleration {acceleration}")

figure, (left, right) = plt.subplots(1, 2, figsize=(7, 3), layout="constrained")
sweep.plot(left, "period", markersize=3)
sweep.plot(right, "acceleration", markersize=3)
left.set_xscale("log")
right.set_xscale("log")
right.legend(fontsize="small")
figure.savefig("convergence.pdf")

ns.save(sweep, "convergence.csv")
