"""Beams and strings with an attachment: every expansion beside finite elements.

    python -m benchmarks.space

prints rates in 60 digits, errors at equal numbers of unknowns, what further forced modes do
(footnote 2 of the paper), what a wrong class does, shapes, Gibbs overshoot and bounds.  The
columns of finite elements need scikit-fem (the extra ``bench``) and are empty without it.
"""

from importlib.util import find_spec

import numpy as np

from nonsmooth.solver.space.attached import Attached, attach
from nonsmooth.solver.space.convergence import Line, convergence
from nonsmooth.solver.space.eigenvalues import bounds, secular
from nonsmooth.solver.space.eigenvalues.exact import exact_modes
from nonsmooth.solver.space.expansions.bare import BareModes
from nonsmooth.solver.space.expansions.forced import ritz_forced
from nonsmooth.solver.space.expansions.pieces import piecewise
from nonsmooth.solver.space.modes import at_order
from nonsmooth.solver.space.structure import load

from .space_digits import ManyDigits

NAMES = ("beam-rotational-spring", "beam-spring", "beam-mass", "beam-crack", "string-mass")
ONE, TWO, THREE = (1,), (1, 2), (1, 2, 3)

#: Orders over which rates are fitted, and places.
ORDERS = (16, 24, 32, 48, 64)
PLACES = ("0.3", "0.318309886183790671537767526745", "0.5")


def off(one: Attached, bare: BareModes, number: int = 1) -> float:
    """Return the relative error of an eigenvalue."""
    roots = secular.eigenvalues(bare, one, number)
    return exact_modes(one, number).error(roots, number - 1)


def rates() -> None:
    """Print the rates of each structure by forced modes."""
    print(
        "Power of N in the error of the lowest felt eigenvalue, N = 16..64, a = 3/10, 1/pi, 1/2"
    )
    for name in NAMES:
        cells = []
        for K in range(4):
            if name == "beam-crack" and K == 0:
                cells.append("never")
                continue
            found = []
            for place in PLACES:
                one = attach(load(name), place[:20])
                exact = exact_modes(one, 3)
                near = exact.eigenvalues[~exact.untouched][0]
                found.append(ManyDigits(name, place, 10).rate(K, ORDERS, near))
            expected = load(name).rates[K]
            cells.append("  ".join(f"{rate:.2f}" for rate in found) + f" (-{expected})")
        print(f"{name:24}", *(f"{cell:28}" for cell in cells))


def errors(number: int = 1) -> None:
    """Print errors by every expansion, and by finite elements, at few and many unknowns."""
    print(f"\nRelative error of eigenvalue {number} (unknowns), a = 3/10, s = 10")
    names = ("ritz 16", "ritz 64", "g_1, N = 8", "g_1 g_2, N = 8", "ck, N = 4", "ck, N = 6",
             "elements, node at a: 8, 128", "no node at a: 8, 128")  # fmt: skip
    print(f"{'':24}", *(f"{name:18}" for name in names))
    for name in NAMES:
        one = attach(load(name))
        found = [
            ritz_forced(one, 16, ()), ritz_forced(one, 64, ()), ritz_forced(one, 8, ONE),
            ritz_forced(one, 8, TWO), piecewise(one, 4), piecewise(one, 6),
        ]  # fmt: skip
        cells = [f"{off(one, bare, number):.1e} ({bare.unknowns})" for bare in found]
        cells += [elements(one, node, number) for node in (True, False)]
        print(f"{name:24}", *(f"{cell:18}" for cell in cells))


def elements(one: Attached, node: bool, number: int) -> str:
    """Return errors and unknowns of finite elements."""
    if find_spec("skfem") is None or number != 1:
        return "-"
    if one.structure.kind == "compliance" and not node:
        return "cannot be built"
    from .space_rivals import finite_elements

    exact = float(exact_modes(one, 1).eigenvalues[0])
    found = [finite_elements(one, count, node) for count in (8, 128)]
    return "  ".join(
        f"{rival.eigenvalue / exact - 1:.1e} ({rival.unknowns})" for rival in found
    )


def high() -> None:
    """Print the errors of a high mode."""
    one = attach(load("beam-rotational-spring"))
    print("\nEigenvalue 7 of the rotational spring, the sixth that is felt (unknowns)")
    for words, bare in (
        ("g_1, N = 16", ritz_forced(one, 16, ONE)),
        ("g_1 g_2, N = 16", ritz_forced(one, 16, TWO)),
        *((f"c1, N = {N}", piecewise(one, N)) for N in (8, 10, 12)),
    ):
        print(f"{words:18} {off(one, bare, 7):.1e} ({bare.unknowns})")


def footnote() -> None:
    """Print what each forced mode does, and the second without the first."""
    one = attach(load("beam-rotational-spring"))
    print("\nFootnote 2: relative error of the lowest eigenvalue, rotational spring")
    for N in (1, 4, 8):
        cells = (
            f"{words} {off(one, ritz_forced(one, N, chosen)):.1e}"
            for words, chosen in (("sines", ()), ("g_2 alone", (2,)), ("g_1", ONE),
                                  ("g_1 g_2", TWO), ("g_1 g_2 g_3", THREE))
        )  # fmt: skip
        print(f"N = {N}:", "   ".join(cells))


def smoothness() -> None:
    """Print errors with pieces of the right class and of others."""
    print("\nClass of the pieces, and the error of the lowest eigenvalue (unknowns)")
    for name, strength in (("beam-rotational-spring", 10.0), ("beam-spring", 1000.0)):
        one = attach(load(name), stiffness=strength)
        found = {f"C{k}": piecewise(one, 10 - (k > 1), continuity=k) for k in (1, 2, 3)}
        cells = (f"{k}: {off(one, bare):.1e} ({bare.unknowns})" for k, bare in found.items())
        print(f"{name:24}", "   ".join(cells))


def shapes() -> None:
    """Print the errors of shape and moment."""
    print("\nRelative L2 errors of the first mode, rotational spring: u, u'', jump law")
    one = attach(load("beam-rotational-spring"))
    lines = [Line("ritz"), Line("ritz-ck", 1), Line("ck")]
    for row in convergence(one, lines, (4, 10, 16, 64)).rows:
        law = "no jump" if row.jump_mismatch == -1 else f"{row.jump_mismatch:.1e}"
        errors_ = f"{row.shape:.1e}  {row.discontinuous:.1e}"
        print(f"{row.method:8} N = {row.order:3}  {errors_}  {law}")


def gibbs() -> None:
    """Print by how much the moment swings beyond its jump."""
    print("\nOvershoot of the moment beside the spring, as a part of its jump (limit 8.95 %)")
    one = attach(load("beam-rotational-spring"))
    exact, a = exact_modes(one, 1), float(one.a)
    jump = np.diff(exact.shape(1, np.array([a - 1e-15, a + 1e-15]), 2))[0]
    middle = (np.arange(4000) + 0.5) / 4000
    u = exact.shape(1, middle, 0)
    for method, order, K in (
        ("ritz", 16, 0),
        ("ritz", 1024, 0),
        ("ritz-ck", 16, 1),
        ("ck", 10, 0),
    ):
        mode = at_order(one, method, order, K, 1)[0]
        scale = (u @ u) / (u @ mode.shape(middle))
        sides = []
        for side in (-1, 1):
            x = a + side * np.linspace(0.2, 3.0, 600) / order
            x = x[(x > 0) & (x < 1)]
            swing = (scale * mode.shape(x, 2) - exact.shape(1, x, 2)) * side
            sides.append(max((swing / jump).max(), 0))
        print(f"{method:8} N = {order:4}  left {sides[0]:.4%}  right {sides[1]:.4%}")


def proved() -> None:
    """Print bounds on both sides."""
    print("\nBounds, rotational spring, one forced mode, N = 8: above and below, relative")
    one = attach(load("beam-rotational-spring"))
    exact = exact_modes(one, 3).eigenvalues
    roots = secular.eigenvalues(ritz_forced(one, 8, ONE), one, 3)
    above, below = bounds.above(roots) / exact - 1, bounds.below(one, 8, 1, 3) / exact - 1
    for number in range(3):
        print(f"mode {number + 1}: +{above[number]:.1e} / {below[number]:.1e}")


def main() -> None:
    """Print all tables."""
    rates()
    errors()
    errors(3)
    high()
    footnote()
    smoothness()
    shapes()
    gibbs()
    proved()


if __name__ == "__main__":
    main()
