"""The equations of a body in ball arithmetic, written apart from ``solver/bodies``.

The numbers of its modes and of the laws of its contacts stand for their exact binary values.
"""
