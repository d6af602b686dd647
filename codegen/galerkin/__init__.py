"""The Galerkin conditions of a scene in an expansion, with unknown switching times.

Input: a `Scene` and the functions of an expansion on each phase.  Output: a
`GalerkinConditions`, rows in closed form with symbolic indices: orthogonality, continuity at
the switches, events, period.  Every row is linear in the coefficients.
"""

from .condition import Block, Condition, GalerkinConditions, Times, cycles

__all__ = ["Block", "Condition", "GalerkinConditions", "Times", "cycles"]
