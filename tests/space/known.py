"""References to 30 digits, and what several tests of modes share.

`references.json` has 210 structures: exact eigenvalues (bisection at 60 digits of the
characteristic equation), Ritz values at 38 digits.  One of these is left out, of beam-spring at
1/2 with strength 1e6 and two forced modes: a root was missed there.  It is computed anew in
`test_space_matrices`.
"""

import json
import math
import random
from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import Any

import mpmath as mp
import numpy as np

from nonsmooth.solver.space.attached import Attached
from nonsmooth.solver.space.structure import load, names

NAMES = names()

#: Those whose modes without a forced mode are felt.
FELT = tuple(name for name in NAMES if name != "beam-crack")


#: Those whose attachment may have a negative stiffness.
SPRINGS = ("beam-rotational-spring", "beam-spring", "string-spring")


@cache
def references() -> tuple[dict[str, Any], ...]:
    text = (Path(__file__).parent / "references.json").read_text("utf-8")
    return tuple(json.loads(text))


@cache
def attached(name: str, position: str = "3/10", strength: float = 10.0) -> Attached:
    """Return a structure whose parameters are 1: what is attached is the strength."""
    structure = load(name)
    values = {q.name: 1.0 for q in structure.parameters}
    values[structure.attached.name] = float(strength)
    return Attached(structure, values, Fraction(position))


def of(reference: dict[str, Any]) -> Attached:
    try:
        Fraction(reference["position"])
        place = reference["position"]
    except ValueError:
        place = reference["position_30"]
    return attached(reference["structure"], place, float(reference["strength"]))


def exact_values(reference: dict[str, Any]) -> "np.ndarray[Any, Any]":
    return np.array([float(value) for value in reference["exact"]])


def place(one: Attached) -> Any:
    """Return the place of the attachment in the digits of mpmath."""
    return mp.mpf(one.a.numerator) / one.a.denominator


def felt(one: Attached, n: int) -> Any:
    """Return what is felt of a mode of the bare structure, in the digits of mpmath."""
    j = one.structure.felt
    return mp.sqrt(2) * (n * mp.pi) ** j * mp.sin(n * mp.pi * place(one) + j * mp.pi / 2)


def law(one: Attached, eigenvalue: float) -> float:
    """Return the jump of the broken derivative over the felt one."""
    factor = {"stiffness": -one.s, "inertia": one.s * eigenvalue, "compliance": one.s}
    return one.structure.jump * factor[one.structure.kind]


def quadrature(one: Attached, points: int) -> "tuple[np.ndarray[Any, Any], ...]":
    """Return places as parts of the length, and weights: Gauss rules beside the attachment."""
    nodes, weights = np.polynomial.legendre.leggauss(points)
    a = float(one.a)
    x = np.concatenate([a * (nodes + 1) / 2, a + (1 - a) * (nodes + 1) / 2])
    return x, np.concatenate([a * weights / 2, (1 - a) * weights / 2])


def receptance(one: Attached, k: Any) -> Any:
    """Return the sum of ``r_n^2/(mu_n - k^(2m))`` in the digits of mpmath, from textbooks.

    Of a crack that of the mass at its place, which has the same eigenvalues.
    """
    a, sine = place(one), mp.sin(k)
    b = 1 - a
    if one.structure.m == 1:
        return mp.sin(k * a) * mp.sin(k * b) / (k * sine)
    if one.structure.felt == 1:
        turning = mp.cosh(k * a) * mp.cosh(k * b) / mp.sinh(k)
        return (turning - mp.cos(k * a) * mp.cos(k * b) / sine) / (2 * k)
    pushing = mp.sinh(k * a) * mp.sinh(k * b) / mp.sinh(k)
    return (mp.sin(k * a) * mp.sin(k * b) / sine - pushing) / (2 * k**3)


def lower(one: Attached, value: Any) -> int:
    """Return how many exact eigenvalues are below a value: by inertia, no root is sought.

    Those of the bare structure, and of the attachment the sign of its dynamic stiffness
    (W. H. Wittrick, F. W. Williams, Q. J. Mech. Appl. Math. 24 (1971) 263-284).
    """
    with mp.workdps(50):
        lam, s = mp.mpf(value), mp.mpf(one.s)
        k = mp.root(lam, 2 * one.structure.m)
        found, G = int(mp.floor(k / mp.pi)), receptance(one, k)
        if one.structure.kind == "stiffness":
            return found + int(1 / s + G > 0) - int(s > 0)
        return found + int(1 / (s * lam) < G)


def drawn(seed: int, *, negative: bool = False) -> Attached:
    """Return a random structure: any place, also beside either end, and any strength.

    A negative one is down to the critical one, of which it leaves out from 1e-13 to 1.
    """
    rng = random.Random(seed)
    near = 10 ** rng.uniform(-4, math.log10(0.5))
    a = max(Fraction(repr(round(near, rng.choice((4, 6, 16))))), Fraction(1, 10_000))
    a, power = rng.choice((a, 1 - a)), rng.uniform(-8, 8)
    if not negative:
        return attached(rng.choice(NAMES), str(a), 10**power)
    name = rng.choice(SPRINGS)
    return attached(name, str(a), float(critical(name, a)) * (1 - 10 ** rng.uniform(-13, 0)))


def critical(name: str, a: Fraction) -> Fraction:
    """Return the strength of a spring that takes all static stiffness, from textbooks."""
    stiffness = {
        "beam-spring": 3 / (a * (1 - a)) ** 2,
        "beam-rotational-spring": 3 / (3 * a**2 - 3 * a + 1),
        "string-spring": 1 / (a * (1 - a)),
    }
    return -stiffness[name]


def expansion(seed: int) -> tuple[str, int, int]:
    """Return a random method, order and number of forced modes."""
    rng = random.Random(seed)
    method = rng.choice(("ritz", "ritz-ck", "ritz-ck", "ck"))
    order = rng.choice((1, 2, 5, 8, 16, 32, 64, 100))
    return method, order, rng.choice((1, 2, 3)) if method == "ritz-ck" else 0
