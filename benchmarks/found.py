"""Whether an orbit is found, in random cases of Section 3.2 with K C1 functions.

    python -m benchmarks.found

K = 1 to 6, N up to 64, alpha from 1e-3 to 1e3, evenly in its logarithm.
"""

from collections import Counter
from dataclasses import replace

import numpy as np

import nonsmooth as ns
from nonsmooth.solver.shortcuts.orbit.methods import MOST_TERMS
from nonsmooth.solver.shortcuts.orbit.oscillator import DEFAULT

CASES, HIGHEST_ORDER, DECADES = 12_000, 64, 3.0


def outcome(K: int, order: int, alpha: float) -> str:
    """Return what `solve` finds."""
    belt = replace(DEFAULT, normal_force=DEFAULT.normal_force * alpha)
    try:
        ns.solve(belt, "hb-c1", order, c1_terms=K, many=True)
    except ns.NoOrbit as finding:
        inadmissible = any("that is not an orbit" in text for text in finding.tried)
        return "a solution that is not an orbit" if inadmissible else "nothing"
    return "an orbit"


def main() -> None:
    """Draw, solve and count."""
    rng = np.random.default_rng(1)
    found: Counter[tuple[int, str]] = Counter()
    for _ in range(CASES):
        K, order = int(rng.integers(1, MOST_TERMS + 1)), int(rng.integers(1, HIGHEST_ORDER + 1))
        alpha = 10 ** rng.uniform(-DECADES, DECADES)
        kind = outcome(K, order, alpha)
        found[K, kind] += 1
        if kind == "nothing":
            print(f"nothing found: K = {K}, N = {order}, alpha = {alpha:.5f}")
    for (K, kind), number in sorted(found.items()):
        print(f"K = {K}: {kind} in {number}")


if __name__ == "__main__":
    main()
