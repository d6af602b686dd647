"""A family of orbits along a parameter: two hundred belts, from slow to fast, in one call.

Period, amplitude and the part of the period that is stick, over the speed of the belt.  At
the default order the C1 series has converged to rounding; the last column of the family says
so, point by point.  The picture goes to ``family.png``.

Prints::

    200 of 200 are orbits
    largest estimated error of the period: 3e-15
    stick lasts half of the period at 0.49 m/s
"""

import matplotlib.pyplot as plt
import numpy as np

import nonsmooth as ns

belt = ns.StickSlip(
    mass=10, stiffness=1000, belt_speed=1, mu_s=0.5, mu_k=0.25, normal_force=400
)
speeds = np.geomspace(0.1, 10, 200)
family = ns.family(belt, "belt_speed", speeds)
found = family["status"] == 0
print(f"{found.sum()} of {len(family)} are orbits")
print(f"largest estimated error of the period: {family['estimate_period'][found].max():.0e}")
nearest = np.argmin(np.abs(family["stick_fraction"] - 0.5))
print(f"stick lasts half of the period at {speeds[nearest]:.2f} m/s")

figure, axes = plt.subplots(1, 3, figsize=(8, 2.6), layout="constrained")
for each, name in zip(axes, ("period", "amplitude", "stick_fraction"), strict=True):
    family.plot(each, name)
    each.set_xscale("log")
figure.savefig("family.png", dpi=200)
