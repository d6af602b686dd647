"""The last symbolic stage: records as the text of Python modules.

Input: a scene, or a Galerkin system of one.  Output: self-contained modules, readable, with
nothing in them that depends on where or when they were written.
"""
