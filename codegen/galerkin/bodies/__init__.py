"""A body of several degrees of freedom in an expansion of its contact forces.

Input: a `Scene` of a body.  Output: a `BodyConditions`: the Galerkin projection of the contact
laws, with the responses of the body's poles; events, impulses, memories, period; and the tables
that these use.  No matrix of the body occurs, only its poles and their shapes at the contacts.
"""
