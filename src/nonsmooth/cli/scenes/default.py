"""The scene of a command without one: the one place that chooses it."""

DEFAULT = "stick-slip"
