"""A convergence study for a paper: errors of period and acceleration of the three methods.

Solves every method at the orders 1 to 40, prints the rates measured over the upper half of
the orders, and writes the figure as ``convergence.pdf`` and its numbers as
``convergence.csv``.  An order at which a method has no orbit is a row without numbers.

Prints::

    120 rows, 120 of them orbits
    hb     period N^-0.932      acceleration N^-0.508
    hb-c1  period N^-2.791      acceleration N^-1.451
    c1     period 10^(-0.95 N)  acceleration 10^(-0.51 N)
"""

import csv

import matplotlib.pyplot as plt

import nonsmooth as ns

belt = ns.StickSlip(
    mass=10, stiffness=1000, belt_speed=1, mu_s=0.5, mu_k=0.25, normal_force=400
)
sweep = ns.sweep(belt, orders=range(1, 41))
orbits = [row for row in sweep.rows if row.errors is not None]
print(f"{len(sweep.rows)} rows, {len(orbits)} of them orbits")
for method, rate in sweep.rates().items():
    period, acceleration = rate.text("period"), rate.text("acceleration")
    print(f"{method:6} period {period:13} acceleration {acceleration}")

figure, (left, right) = plt.subplots(1, 2, figsize=(7, 3), layout="constrained")
for method, marker in (("hb", "D"), ("hb-c1", "s"), ("c1", "o")):
    rows = [row for row in orbits if row.method == method]
    N = [row.order for row in rows]
    style = {"marker": marker, "markersize": 3, "fillstyle": "none", "label": method}
    left.loglog(N, [abs(row.errors.period) for row in rows], **style)
    right.loglog(N, [row.errors.acceleration for row in rows], **style)
left.set(xlabel="N", ylabel="|T/T_exact - 1|")
right.set(xlabel="N", ylabel="acceleration error (22)", ylim=(3e-9, 1))  # below: rounding
right.legend()
figure.savefig("convergence.pdf")

with open("convergence.csv", "w", newline="", encoding="utf-8") as file:
    table = csv.writer(file)
    table.writerow(("method", "N", "period", "acceleration"))
    for row in sweep.rows:
        errors = (row.errors.period, row.errors.acceleration) if row.errors else ("", "")
        table.writerow((row.method, row.order, *errors))
