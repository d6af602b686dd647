"""Harmonics of contact forces: the response of a pole, ``z' = s z + f``, to a wave.

The amplitude of the response to ``f = e^(i omega t)`` also gives the integral of z with a wave,
by parts:

    ``int e^(-i omega t) z = (int e^(-i omega t) f - [e^(-i omega t) z])/(i omega - s)``.

A function whose derivative of order n - 1 jumps by 1 has the harmonics of a unit impulse,
integrated n times.
"""

from collections.abc import Iterator

import sympy as sp

from .force_series import Formula

omega, s = sp.symbols("omega s")
n = sp.Symbol("n", integer=True, nonnegative=True)


def formulas() -> Iterator[Formula]:
    """Yield the closed forms.

    Examples
    --------
    >>> [formula.value for formula in formulas()]
    [1/(I*omega - s), (I*omega)**(-n)]
    """
    z = sp.Symbol("z")
    (amplitude,) = sp.solve(sp.I * omega * z - s * z - 1, z)
    yield Formula("answer", (omega, s), "the amplitude of a pole in a wave", amplitude)
    words = "a harmonic of ``beta_n``, times that of an impulse where its break is"
    yield Formula("harmonic", (omega, n), words, (sp.I * omega) ** (-n))
