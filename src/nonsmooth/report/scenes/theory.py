"""How fast the errors should fall: from the class of the motion and the functions beside it.

With K functions at a switch of class C^k the first K derivatives that jump are taken from the
series, and its harmonics fall like n^-(k + K + 2).  What is left out at the switch itself,
where the times are found from the derivative r of the event (0: a displacement, 1: a velocity),
sums to N^-(q - 1), q = k + K + 2 - r; terms of odd q are sines there and cancel: one power
more.  The derivative that jumps falls like its own harmonics, or as slowly as the times.
"""

import math

from nonsmooth.solver.scenes.case import Case


def rate_of_times(case: Case, functions: int) -> int:
    """Return the power of 1/N with which the times of a series with K functions converge.

    The least over the switches, each with its own class; `functions` is 0 of a plain Fourier
    series.
    """
    found, phases = [], case.cell.phases
    for p, phase in enumerate(phases):
        k = case.scene.classes[(p + 1) % len(phases)]
        by_displacement = phase.event[0] != 0
        smooth = phase.rho == 1 and phase.d == 0
        r = 0 if by_displacement and smooth else 1
        q = k + functions + 2 - r
        found.append(2 * math.ceil(q / 2) - 1)
    return int(min(found))


def rate_of_jump(case: Case, functions: int) -> float:
    """Return the power of 1/N with which the derivative that jumps converges in L2."""
    return min(functions + 0.5, float(rate_of_times(case, functions)))
