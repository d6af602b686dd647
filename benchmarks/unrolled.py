"""The kernel that a symbolic derivation gives first: every entry written out, for one N.

Section 3.3 in powers of ``u``, all integrals by SymPy, residual and Jacobian as flat
expressions through `lambdify` with common subexpressions, compiled by numba.  Derivation and
compilation, a minute from N of about ten on, are not in the times that are compared.
"""

import math

import numba
import numpy as np
import sympy as sp

from .rivals import Period


def unrolled(order: int) -> Period:
    """Return Newton with the unrolled kernel of one order."""
    residual, jacobian = _kernel(order)

    @numba.njit
    def period(alpha: float) -> float:
        z = np.empty(order + 3)
        # The start that our own solver has: rough times, and what is linear solved for them.
        z[: order + 1] = 0.0
        z[order + 1] = 2 * alpha
        z[order + 2] = math.pi + 2 / (alpha + 2 / math.pi)
        R = residual(alpha, z)
        A = np.ascontiguousarray(jacobian(alpha, z)[:, : order + 1])
        z[: order + 1] = np.linalg.lstsq(A, -R)[0]
        for _ in range(20):
            step = np.linalg.solve(jacobian(alpha, z), residual(alpha, z))
            z -= step
            if abs(step[order + 2]) < 1e-9 * z[order + 2]:
                break
        return z[order + 1] + z[order + 2]

    return period


def _kernel(order: int):
    """Return residual and Jacobian of (18), (19), (20), unrolled and compiled."""
    alpha, u, t1, s = sp.symbols("alpha u t1 s")
    d = sp.symbols(f"d0:{order + 1}")
    acceleration = sum(d[n] * u**n for n in range(order + 1))
    travel = sum(d[n] * u ** (n + 2) / ((n + 1) * (n + 2)) for n in range(order + 1))
    y = -alpha + t1 + s * u + s**2 * travel
    rows = [
        sp.integrate(sp.expand((acceleration + y) * u ** (k + 2)), (u, 0, 1))
        for k in range(order + 1)
    ]
    rows += [(y + alpha).subs(u, 1), (y.diff(u) - s).subs(u, 1)]
    unknowns = (*d, t1, s)
    jacobian = sp.Matrix(rows).jacobian(unknowns)
    size = range(order + 3)
    fill_R = _filled({f"R[{i}]": rows[i] for i in size})
    fill_J = _filled({f"J[{i}, {j}]": jacobian[i, j] for i in size for j in size})
    names = "\n".join(f"    {name} = z[{i}]" for i, name in enumerate(unknowns))
    text = f"def residual(alpha, z):\n{names}\n    R = np.empty({order + 3})\n{fill_R}"
    text += "    return R\n\n\n"
    text += f"def jacobian(alpha, z):\n{names}\n    J = np.empty({(order + 3,) * 2})\n{fill_J}"
    text += "    return J\n"
    namespace = {"np": np}
    exec(text, namespace)
    return numba.njit(namespace["residual"]), numba.njit(namespace["jacobian"])


def _filled(entries: dict[str, sp.Expr]) -> str:
    """Return assignments to `entries`, common subexpressions first."""
    replaced, values = sp.cse(list(entries.values()), sp.numbered_symbols("x_"))
    lines = [f"    {name} = {sp.pycode(value)}\n" for name, value in replaced]
    lines += [
        f"    {name} = {sp.pycode(value)}\n"
        for name, value in zip(entries, values, strict=True)
    ]
    return "".join(lines)
