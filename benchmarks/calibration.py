"""The estimated error over the true one, on random orbits: the table of docs/tradeoff.md.

    python -m benchmarks.calibration

Only where the true error is above rounding; some minutes.
"""

import numpy as np

import nonsmooth as ns

CASES, SEED = 400, 3

#: Errors below this are rounding.
FLOOR = 1e-13


def main() -> None:
    """Solve, compare, print."""
    rng = np.random.default_rng(SEED)
    ratios: dict[str, list[float]] = {"period": [], "times": [], "discontinuous": []}
    orbits = 0
    for method in ("hb", "hb-c1", "c1"):
        for alpha in 10 ** rng.uniform(-3, 3, CASES):
            order = int(rng.integers(1, 41))
            belt = ns.StickSlip(
                mass=1, stiffness=1, belt_speed=1, mu_s=1, mu_k=0.5, normal_force=2 * alpha
            )
            try:
                orbit = ns.solve(belt, method, order)
            except ns.NoOrbit:
                continue
            orbits += 1
            assert orbit.errors is not None
            for name, seen in ratios.items():
                error = abs(getattr(orbit.errors, name))
                if error > FLOOR:
                    seen.append(getattr(orbit.estimate, name) / error)
    print(f"{orbits} orbits; estimate over error: least, median, 99 %, most")
    for name, seen in ratios.items():
        shown = "  ".join(f"{value:.3f}" for value in np.quantile(seen, [0, 0.5, 0.99, 1]))
        print(f"{name:14}{len(seen):5d}  {shown}")


if __name__ == "__main__":
    main()
