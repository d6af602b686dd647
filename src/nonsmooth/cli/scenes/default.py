"""The scene of a command without one, and that of examples: the one place that chooses."""

DEFAULT = "stick-slip"

#: A scene, a parameter of it and a value, for the help of a command that takes any.
EXAMPLE = {"scene": "impact", "flag": "--gap", "value": 0.2}
