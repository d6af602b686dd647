"""Functions that records name and do not evaluate: they are there to be printed."""

import sympy as sp


class ShiftedLegendre(sp.Function):  # type: ignore[misc]
    """``P_n*(u) = P_n(2 u - 1)``, unevaluated, for printing."""

    nargs = 2


class TwiceIntegrated(sp.Function):  # type: ignore[misc]
    """``Q_n(u)``, unevaluated, for printing."""

    nargs = 2
