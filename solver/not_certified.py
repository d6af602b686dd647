"""No orbit is as accurate as asked for: what every such finding has in common."""

#: Part of a tolerance that an estimate may use up; it is itself off by a few per cent.
MARGIN = 0.9


class NotCertified(Exception):  # noqa: N818  (a finding, not a fault)
    """No orbit in float64 is as accurate as asked for, as far as the estimate can say."""
