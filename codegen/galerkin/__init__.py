"""Scene by expansion: the conditions that a motion with unknown switching times satisfies.

Input: a `Scene` and an expansion's functions on each phase.  Output: a `GalerkinConditions`,
the rows in closed form with symbolic indices: orthogonality, continuity at the switches,
events, period.  Every row is linear in the coefficients.
"""

from .condition import Block, Condition, GalerkinConditions, Times, cycles

__all__ = ["Block", "Condition", "GalerkinConditions", "Times", "cycles"]
