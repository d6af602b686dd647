"""The equations of a body in ball arithmetic, written apart from ``solver/bodies``.

The numbers of its modes and of the laws of its contacts stand for their exact binary values.
"""

from ...scenes.methods import EXACT, about
from ..balls import Residual
from . import exact, force_series, harmonics


def residual(method: str) -> Residual:
    """Return the left sides of the equations of a method at given times, over balls."""
    if method == EXACT:
        return exact.residual
    return harmonics.residual if about(method).is_series else force_series.residual
