"""What only the paper's own rooms have: the one door through which the report reaches them."""

import nonsmooth as ns
from nonsmooth.codegen.shortcuts.document import equations_html
from nonsmooth.solver.shortcuts.orbit.oscillator import DEFAULT
from nonsmooth.solver.shortcuts.polynomials import c1_roots
from nonsmooth.solver.shortcuts.search.kernels import module

__all__ = ["DEFAULT", "METHODS", "all_times", "equations_html", "mathematics"]

#: The three methods: their sections and what a table calls them.
METHODS = {
    "hb": ("3.1", "Fourier series"),
    "hb-c1": ("3.2", "Fourier series + one C¹ function"),
    "c1": ("3.3", "C¹ functions"),
}


def all_times(belt: ns.StickSlip, order: int) -> list[tuple[float, float]]:
    """Return ``t1`` and ``T`` in s of all real solutions of (18) to (20), orbits or not."""
    found = c1_roots.solutions(order, belt.alpha)
    return [(float(z[-2]) * belt.time_unit, float(z[-1]) * belt.time_unit) for z in found]


def mathematics(method: str) -> str:
    """Return the beginning of the hash of the symbolic expressions behind a method."""
    return str(module(method).MATHEMATICS)[:16]
