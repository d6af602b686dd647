"""The three methods of the paper as data: section, evaluation, coefficients, tolerance."""

import operator
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from types import MappingProxyType

from ...arrays import Vector
from ...case.parameters import ParameterError
from ..polynomials import polynomial
from ..series import fourier
from .oscillator import StickSlip, check_type


@dataclass(frozen=True)
class Method:
    """One expansion of the paper.

    Parameters
    ----------
    name, section, title : str
        ``"hb"``, ``"3.1"`` and what a table calls it.
    evaluate : callable
        ``evaluate(z, order, t, derivative, alpha)``, dimensionless, ``t`` in ``[0, T)``.
    coefficients : callable
        ``coefficients(z, order, belt)``, the paper's, in SI units.
    highest_order : int
        Where the equations still fit into memory and the digits of float64.
    c1_terms : int or None
        C1 functions beside the Fourier series; None where there is no such series.
    """

    name: str
    section: str
    title: str
    evaluate: Callable[[Vector, int, Vector, int, float], Vector]
    coefficients: Callable[[Vector, int, StickSlip], dict[str, object]]
    highest_order: int
    c1_terms: int | None


METHODS: Mapping[str, Method] = MappingProxyType(
    {
        method.name: method
        for method in (
            Method(
                "hb",
                "3.1",
                "Fourier series",
                fourier.evaluate_hb,
                fourier.coefficients_hb,
                1_000_000,
                0,
            ),
            Method(
                "hb-c1",
                "3.2",
                "Fourier series + one C1 function",
                fourier.evaluate_hb_c1,
                fourier.coefficients_hb_c1,
                1_000_000,
                1,
            ),
            Method(
                "c1",
                "3.3",
                "C1 functions",
                polynomial.evaluate,
                polynomial.coefficients,
                400,
                None,
            ),
        )
    }
)


#: Most C1 functions beside a Fourier series, and harmonics with more than one of them.
MOST_TERMS, MOST_HARMONICS_BESIDE = 6, 200


def _whole(value: object) -> int:
    """Return a whole number as an int, and 0 for all else; a bool is none."""
    try:
        return 0 if isinstance(value, bool) else operator.index(value)  # type: ignore[arg-type]
    except TypeError:
        return 0


def with_terms(method: Method, terms: object) -> Method:
    """Return Section 3.2 with `terms` C1 functions; any other method as it is for 1.

    Raises
    ------
    ValueError
        If it is not a whole number from 1 to 6, or another method is to have several.
    """
    number = _whole(terms)
    if not 1 <= number <= MOST_TERMS:
        expected = f"a whole number from 1 to {MOST_TERMS}"
        raise ValueError(f"c1_terms: got {terms!r}, expected {expected}")
    if number == 1:
        return method
    if method.name != "hb-c1":
        raise ValueError(f"c1_terms: got {terms!r}, expected 1 for method {method.name}")
    title = f"Fourier series + {number} C1 functions"
    return replace(method, title=title, c1_terms=number, highest_order=MOST_HARMONICS_BESIDE)


def name_with_terms(method: str, c1_terms: int) -> str:
    """Return how a method is called, with the number of its C1 functions if not the paper's.

    Examples
    --------
    >>> name_with_terms("hb-c1", 1), name_with_terms("hb-c1", 3)
    ('hb-c1', 'hb-c1(3)')
    """
    return method if c1_terms == 1 else f"{method}({c1_terms})"


def check_method(name: object) -> Method:
    """Return the method of this name.

    Raises
    ------
    ValueError
        If there is none.
    """
    if not isinstance(name, str) or name not in METHODS:
        raise ValueError(f"method: got {name!r}, expected one of {', '.join(METHODS)}")
    return METHODS[name]


#: Beyond, the durations of stick and slip differ by so much that float64 cannot hold both.
SMALLEST_ALPHA, LARGEST_ALPHA = 1e-8, 1e8


def check_alpha(alpha: float) -> float:
    """Return `alpha`.

    Raises
    ------
    ParameterError
        If stick or slip is too short a part of the period for float64.
    """
    if not SMALLEST_ALPHA <= alpha <= LARGEST_ALPHA:
        message = (
            f"parameters: their alpha is {alpha!r}, expected {SMALLEST_ALPHA:g} to "
            f"{LARGEST_ALPHA:g}; beyond, stick or slip is too short a part of the period"
        )
        raise ParameterError([message])
    return alpha


def check_belt(belt: StickSlip) -> None:
    """Check that `belt` is an oscillator whose orbit can be computed.

    Raises
    ------
    TypeError
        If it is not a `StickSlip`.
    ParameterError
        If its ``alpha`` is beyond what float64 can hold.
    """
    check_type(belt)
    check_alpha(belt.alpha)


def check_order(order: object, method: Method) -> int:
    """Return the order as an int.

    Raises
    ------
    ValueError
        If it is not a whole number from 1 to the method's highest.
    """
    number = _whole(order)
    if not 1 <= number <= method.highest_order:
        raise ValueError(
            f"order: got {order!r}, expected a whole number from 1 to {method.highest_order} "
            f"for method {method.name}"
        )
    return number
