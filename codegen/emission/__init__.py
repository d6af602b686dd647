"""The last symbolic stage: records as the text of Python modules.

Input: a scene, or the closed forms of an expansion.  Output: modules, readable, with
nothing in them that depends on where or when they were written.
"""
