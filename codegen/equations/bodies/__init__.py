"""Bodies of several degrees of freedom for a reader: their equations, and those of a method.

Input: a `Scene` of a body, and its `BodyConditions`.  Output: equations, as of one mass.
"""

from .forces import Forces
from .of_body import body_equations

__all__ = ["Forces", "body_equations"]
