"""A body of several degrees of freedom in an expansion of its contact forces.

Input: a `Scene` of a body.  Output: a `BodyConditions`: the laws of the contacts, tested, with
what the poles of the body answer, events, impulses, memory, period; and the tables that these
look up.  No matrix of the body is in it: it is poles, and what the contacts see of them.
"""
