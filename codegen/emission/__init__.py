"""The last symbolic stage: emission of Python modules.

Input: a scene, or the closed forms of an expansion.  Output: the text of readable modules,
which does not depend on place or time.
"""
