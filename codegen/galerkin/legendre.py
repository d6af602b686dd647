"""A phase in shifted Legendre polynomials: acceleration, velocity and displacement.

On a phase of duration s, with ``u = (t - t_p)/s`` from 0 to 1, the acceleration is
``sum d_n P_n*(u)``; velocity and displacement are integrated from the state at its begin.  The
coefficients of integrals follow from one identity,

    int_0^u P_n* = (P_(n+1)* - P_(n-1)*)/(2 (2 n + 1)),     P_(-1)* = -P_0*,

so the coefficient of ``P_l*`` in each is a combination of at most three of the ``d_n``.

The forcing has the moments

    ``mu_l(kappa, theta) = int_0^1 P_l*(u) cos(kappa u + theta) du``
    ``= Re[i^l exp(i (theta + kappa/2))] j_l(kappa/2)``

with the spherical Bessel function j_l.  Their derivatives are moments again: with
``nu_l(kappa, theta) = mu_l(kappa, theta + pi/2)``,

    ``d mu_l/d theta = nu_l``
    ``d mu_l/d kappa = [nu_l + ((l + 1) nu_(l+1) + l nu_(l-1))/(2 l + 1)]/2``.
"""

from collections.abc import Callable
from dataclasses import dataclass

import sympy as sp

from ..scene import LinearPhase

#: The degree of a trial function, and of a test.
n, l = sp.symbols("n l", integer=True, nonnegative=True)

Coefficient = Callable[[sp.Expr], sp.Expr]


def integrated(series: Coefficient, l: sp.Expr) -> sp.Expr:
    """Return the coefficient of ``P_l*`` in the integral from 0 of a series."""
    below = -series(sp.Integer(0)) if l == 0 else series(l - 1)
    return below / (2 * (2 * l - 1)) - series(l + 1) / (2 * (2 * l + 3))


def repeated_integral(l: sp.Expr, times: int) -> dict[sp.Expr, sp.Expr]:
    """Return the repeated integral of ``P_l*`` from 0, as weights of Legendre polynomials."""
    series: dict[sp.Expr, sp.Expr] = {l: sp.Integer(1)}
    for _ in range(times):
        integral: dict[sp.Expr, sp.Expr] = {}
        for degree, weight in series.items():
            half = weight / (2 * (2 * degree + 1))
            sign, lower = (-1, degree - 1) if degree != 0 else (1, sp.Integer(0))
            for index, part in ((degree + 1, half), (lower, sign * half)):
                integral[index] = sp.factor(integral.get(index, sp.Integer(0)) + part)
        series = integral
    return series


def in_legendre(polynomial: sp.Expr, u: sp.Symbol) -> tuple[sp.Expr, ...]:
    """Return the coefficients of a polynomial in shifted Legendre polynomials, by degree."""
    remainder = sp.Poly(polynomial, u)
    coefficients = []
    for l in reversed(range(len(remainder.all_coeffs()))):
        shifted = sp.Poly(sp.expand(sp.legendre(l, 2 * u - 1)), u)
        coefficient = remainder.coeff_monomial(u**l) / shifted.coeff_monomial(u**l)
        remainder = remainder - shifted * coefficient
        coefficients.append(sp.expand(coefficient))
    return tuple(reversed(coefficients))


@dataclass(frozen=True)
class PhaseSeries:
    """The trial function on one phase.

    Parameters
    ----------
    duration, displacement, velocity : Symbol
        Duration, and the state at the begin of the phase.
    acceleration : IndexedBase or None
        The ``d_n``; None if a constraint holds the velocity.
    count : Expr
        Number of the ``d_n``, as an expression in the order.
    """

    duration: sp.Symbol
    displacement: sp.Symbol
    velocity: sp.Symbol
    acceleration: sp.IndexedBase | None
    count: sp.Expr

    def a(self, l: sp.Expr) -> sp.Expr:
        """Return the coefficient of ``P_l*`` in the acceleration."""
        if self.acceleration is None or sp.expand(l - self.count).is_nonnegative:
            return sp.Integer(0)
        return self.acceleration[l]

    def v(self, l: sp.Expr) -> sp.Expr:
        """Return the coefficient of ``P_l*`` in the velocity."""
        start = self.velocity if l == 0 else 0
        return start + self.duration * integrated(self.a, l)

    def x(self, l: sp.Expr) -> sp.Expr:
        """Return the coefficient of ``P_l*`` in the displacement."""
        start = self.displacement if l == 0 else 0
        return start + self.duration * integrated(self.v, l)

    def residual(self, phase: LinearPhase, l: sp.Expr, forcing: sp.Expr) -> sp.Expr:
        """Return the coefficient of ``P_l*`` in the residual of the equation of motion.

        `forcing` is the moment of the forcing with ``P_l*``.
        """
        constant = phase.f if l == 0 else sp.Integer(0)
        force = constant + phase.g * (2 * l + 1) * forcing
        return phase.m * self.a(l) + phase.c * self.v(l) + phase.k * self.x(l) - force

    def at_start(self, order: int) -> sp.Expr:
        """Return a derivative of the displacement where the phase begins."""
        if order < 2:
            return (self.displacement, self.velocity)[order]
        return self._derivative(order - 2, at_end=False)

    def at_end(self, order: sp.Expr) -> sp.Expr:
        """Return a derivative of the displacement where the phase ends."""
        s = self.duration
        if order == 0:  # int_0^1 Q_n'' twice: 1/2, -1/6 and nothing beyond
            twice = self.a(sp.Integer(0)) / 2 - self.a(sp.Integer(1)) / 6
            return self.displacement + s * self.velocity + s**2 * twice
        if order == 1:
            return self.velocity + s * self.a(sp.Integer(0))
        return self._derivative(order - 2, at_end=True)

    def _derivative(self, q: sp.Expr, at_end: bool) -> sp.Expr:
        """Return the q-th derivative of the acceleration at an end of the phase.

        That of ``P_n*`` by u is ``(n + q)!/(q! (n - q)!)`` at 1, and ``(-1)^(n + q)`` times
        this at 0.
        """
        if self.acceleration is None:
            return sp.Integer(0)
        rising = sp.rf(n - q + 1, 2 * q) / sp.factorial(q)
        sign = sp.Integer(1) if at_end else (-1) ** (n + q)
        term = sign * rising * self.acceleration[n] / self.duration**q
        return sp.Sum(term, (n, 0, self.count - 1))


@dataclass(frozen=True)
class Moments:
    """The moments of the forcing on one phase, with symbols for them.

    Parameters
    ----------
    symbol, turned : IndexedBase
        The moments ``mu_l``, and ``nu_l`` with ``theta + pi/2``.
    kappa, theta : Expr
        The change of the angle of the forcing in the phase, and the angle at its begin.
    """

    symbol: sp.IndexedBase
    turned: sp.IndexedBase
    kappa: sp.Expr
    theta: sp.Expr

    def rate(self, time: sp.Symbol) -> sp.Expr:
        """Return the derivative of ``mu_l`` by a time that `kappa` and `theta` depend on."""
        turned = self.turned
        neighbours = (l + 1) * turned[l + 1] + l * turned[l - 1]
        stretch = (turned[l] + neighbours / (2 * l + 1)) / 2
        return sp.diff(self.kappa, time) * stretch + sp.diff(self.theta, time) * turned[l]
