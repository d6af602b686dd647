"""What an orbit costs of CPU time: by `ns.solve`, and along a parameter by `ns.family`.

    python -m benchmarks.scene_families

Milliseconds an orbit, checks, estimates and extremes included, of each scene: its defaults with
the first parameter up to 5 % larger, kernels compiled before.  The least of some rounds.
"""

import time
from collections.abc import Callable

import numpy as np

import nonsmooth as ns

COUNT, ROUNDS, ORDER = 100, 3, 10


def least(run: Callable[[], object], orbits: int) -> float:
    """Return milliseconds of CPU time an orbit, after a first run."""
    times = []
    for _ in range(ROUNDS + 1):
        begin = time.process_time()
        run()
        times.append(time.process_time() - begin)
    return min(times[1:]) / orbits * 1e3


def measure(scene: str, count: int = COUNT) -> tuple[float, float]:
    """Return the cost of an orbit by itself, and of one along a parameter."""
    load = ns.scene(scene)
    name, value = next(iter(load().values.items()))
    values = value * np.linspace(1.0, 1.05, count)

    def each() -> None:
        for one in values:
            ns.solve(load(**{name: one}), order=ORDER)

    def along() -> None:
        ns.family(load(), name, values, order=ORDER)

    return least(each, count), least(along, count)


def main() -> None:
    """Measure and print."""
    print("ms of CPU an orbit    solve   family")
    for scene in ns.scenes():
        alone, along = measure(scene)
        print(f"{scene:20} {alone:6.2f}   {along:6.2f}")


if __name__ == "__main__":
    main()
