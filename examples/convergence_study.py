"""A convergence study for a paper: errors of the times and of the acceleration, three methods.

Solves every method at the orders 1 to 40, prints the rates fitted over the orders, and writes
the figure as ``convergence.pdf`` and its numbers as ``convergence.csv``.  An order at which a
method has no orbit is a row without numbers.

Prints::

    <sweep of stick-slip by hb, hb-c1, c1: 120 rows, 120 orbits>
    hb     times N^-0.913      acceleration N^-0.507
    hb-c1  times N^-2.739      acceleration N^-1.430
    c1     times 10^(-0.82 N)  acceleration 10^(-0.81 N)
"""

import matplotlib.pyplot as plt

import nonsmooth as ns

belt = ns.StickSlip(
    mass=10, stiffness=1000, belt_speed=1, mu_s=0.5, mu_k=0.25, normal_force=400
)
sweep = ns.sweep(belt, methods=["hb", "hb-c1", "c1"], orders=range(1, 41))
print(repr(sweep))
for method, rate in sweep.rates().items():
    times, acceleration = rate.text("times"), rate.text("discontinuous")
    print(f"{belt.called(method):6} times {times:13} acceleration {acceleration}")

figure, (left, right) = plt.subplots(1, 2, figsize=(7, 3), layout="constrained")
sweep.plot(left, "times", markersize=3)
sweep.plot(right, "discontinuous", markersize=3)
left.set_xscale("log")
right.set_xscale("log")
figure.legend(*right.get_legend_handles_labels(), loc="outside upper center", ncols=3)
figure.savefig("convergence.pdf")

ns.save(sweep, "convergence.csv")
