"""Functions of class C^1 where a scene is smoother: the same kernel, with other rows."""

import sympy as sp

from ..galerkin import GalerkinConditions
from .functions import function
from .loops import per_order, start_of


def functions(system: GalerkinConditions) -> list[str]:
    """Return the functions of the same order for class C^1, where the conditions say how."""
    places, row = [], sp.Integer(0)
    for condition in system.conditions:
        if condition.once is not None:
            family, index = condition.once.base.label, condition.once.indices[0]
            unknown = sp.expand(start_of(system, str(family)) + index)
            places.append(f"({sp.expand(row)}, {unknown}),")
        row += condition.count
    if not places:
        return []
    slope, rest = per_order(system)
    rows = [
        f"N = (size - {rest})//{slope}",
        "return (",
        *("    " + pair for pair in places),
        ")",
    ]
    residual = ["residual(case, z, R)", "for row, unknown in once(len(z)):"]
    jacobian = ["jacobian(case, z, J)", "for row, unknown in once(len(z)):"]
    return [
        function(
            "once(size)", "Return rows of x'' and beyond, and what is zero instead.", rows
        ),
        function(
            "residual_once(case, z, R)",
            "Fill R for functions of class C^1: their accelerations have degree N.",
            [*residual, "    R[row] = z[unknown]"],
        ),
        function(
            "jacobian_once(case, z, J)",
            "Fill J with the derivatives of that.",
            [*jacobian, "    J[row, :] = 0.0", "    J[row, unknown] = 1.0"],
        ),
    ]
