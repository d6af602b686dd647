"""``nonsmooth modes``, and ``sweep`` of a structure: modes of beams and strings in space.

`commands` has their help and options; `modes` and `sweep` are what runs.
"""
