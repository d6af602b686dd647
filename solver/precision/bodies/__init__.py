"""The equations of a body in ball arithmetic, independent of ``solver/bodies``.

Numbers of modes and of contact laws stand for their exact binary values.
"""
