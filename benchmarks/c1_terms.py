"""Convergence of Section 3.2 with K C1 functions: the table of docs/tradeoff.md.

    python -m benchmarks.c1_terms

The largest period error among N and the three orders after it, at alpha = 1: it changes sign
with the order.  A dash where an order is not converged.
"""

import math

import nonsmooth as ns
from nonsmooth.solver.shortcuts.orbit.oscillator import DEFAULT

ORDERS = (8, 16, 32, 64, 128)


def worst(K: int, N: int) -> float:
    """Return the largest error, or NaN if an orbit is not converged."""
    errors = []
    for order in range(N, N + 4):
        method, terms = ("hb-c1", K) if K else ("hb", 1)
        try:
            orbit = ns.solve(DEFAULT, method, order, c1_terms=terms, many=True)
        except ns.NoOrbit:
            return math.nan
        errors.append(abs(orbit.errors.period))
    return max(errors)


def main() -> None:
    """Solve and print."""
    print("K  " + "".join(f"{f'N = {N}':>10}" for N in ORDERS) + "   order, N = 16 to 64")
    for K in range(7):
        row = {N: worst(K, N) for N in ORDERS}
        shown = "".join(f"{'-' if math.isnan(e) else f'{e:.1e}':>10}" for e in row.values())
        print(f"{K}  {shown}   {math.log2(row[16] / row[64]) / 2:.1f}")


if __name__ == "__main__":
    main()
