"""Times as they are typed: ``200us``, ``1.5 ms``, ``2s``."""

import re

from ..problems import Problem

UNITS = {"us": 1e-6, "ms": 1e-3, "s": 1.0}


def parse_seconds(text: str) -> float:
    """Return a time in seconds; a `Problem` if it is not a positive number and a unit.

    Examples
    --------
    >>> parse_seconds("250us"), parse_seconds("1.5 ms"), parse_seconds("2s")
    (0.00025, 0.0015, 2.0)
    """
    found = re.fullmatch(r"(\d+(?:\.\d*)?(?:e-?\d+)?)\s*(us|ms|s)", text.strip())
    value = float(found[1]) * UNITS[found[2]] if found else 0.0
    if not 0 < value < float("inf"):
        raise Problem(f"--budget: got {text!r}, expected a time like 200us, 1ms or 2s")
    return value
