"""``nonsmooth modes``, and ``sweep`` of a structure: modes of beams and strings in space."""
