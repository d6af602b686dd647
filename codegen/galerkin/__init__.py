"""Scene by expansion: the conditions that a motion with unknown switching times satisfies.

Input: a `Scene` and an expansion's functions on each phase.  Output: a `GalerkinConditions`,
the rows in closed form with symbolic indices: orthogonality, continuity at the switches,
events, period.  Every row is linear in the coefficients; derivatives by the unknown times
come from one chain rule.
"""

from .condition import Block, Condition, GalerkinConditions
from .tables import Table
from .times import Times, cycles

__all__ = ["Block", "Condition", "GalerkinConditions", "Table", "Times", "cycles"]
