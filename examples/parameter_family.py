"""A family of orbits along a parameter: a hundred belts, from slow to fast, in one call.

Period, ends of the motion and durations of the phases over the speed of the belt.  At the
default order the orbits have converged to rounding; each row says so.  The picture goes to
``family.png``.

Prints::

    100 of 100 are orbits
    largest estimated error: 5e-15
    stick lasts half of the period at 0.49 m/s
"""

import matplotlib.pyplot as plt
import numpy as np

import nonsmooth as ns

belt = ns.StickSlip(
    mass=10, stiffness=1000, belt_speed=1, mu_s=0.5, mu_k=0.25, normal_force=400
)
family = ns.family(belt, "belt_speed", np.geomspace(0.1, 10, 100))
found = [row for row in family if row.status == "ok"]
print(f"{len(found)} of {len(family)} are orbits")
print(f"largest estimated error: {max(row.estimate.times for row in found):.0e}")
half = min(found, key=lambda row: abs(row.durations[0] / row.period - 0.5))
print(f"stick lasts half of the period at {half.value:.2f} m/s")

figure, axes = plt.subplots(1, 3, figsize=(8, 2.6), layout="constrained")
for each, quantity in zip(axes, ("period", "displacement", "times"), strict=True):
    family.plot(each, quantity)
    each.set_xscale("log")
figure.savefig("family.png", dpi=200)
