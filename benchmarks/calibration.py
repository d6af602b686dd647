"""The estimated error over the true one, on random orbits: the table of docs/tradeoff.md.

    python -m benchmarks.calibration

Only where the true error is above rounding; half a minute.
"""

import math

import numpy as np

import nonsmooth as ns

CASES, SEED = 400, 3


def main() -> None:
    """Solve, compare, print."""
    rng = np.random.default_rng(SEED)
    ratios: dict[str, list[float]] = {"period": [], "t1": [], "acceleration": []}
    orbits = 0
    for method in ("hb", "hb-c1", "c1"):
        for alpha in 10 ** rng.uniform(-3, 3, CASES):
            few = method == "c1"
            order = int(rng.integers(1, 41)) if few else round(10 ** rng.uniform(0, 2.7))
            belt = ns.StickSlip(
                mass=1, stiffness=1, belt_speed=1, mu_s=1, mu_k=0.5, normal_force=2 * alpha
            )
            try:
                orbit = ns.solve(belt, method, order, many=True)
            except ns.NoOrbit:
                continue
            orbits += 1
            t1, T = orbit.unknowns[-2:]
            floors = 1e-14, 1e-14 * T / t1, 2e-7 * math.sqrt(T / (T - t1))
            for (name, seen), floor in zip(ratios.items(), floors, strict=True):
                error = abs(getattr(orbit.errors, name))
                if error > floor:
                    seen.append(getattr(orbit.estimate, name) / error)
    print(f"{orbits} orbits; estimate over error: least, median, 99 %, most")
    for name, seen in ratios.items():
        shown = "  ".join(f"{value:.3f}" for value in np.quantile(seen, [0, 0.5, 0.99, 1]))
        print(f"{name:14}{len(seen):5d}  {shown}")


if __name__ == "__main__":
    main()
