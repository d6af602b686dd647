"""Documents of results: the version of what their keys mean, and numbers that JSON has."""

import math
from typing import Any

#: Version of documents: what a reader may expect of their keys.
SCHEMA = 2


def finite(value: Any) -> Any:
    """Return a document with None for numbers that JSON has no word for.

    Examples
    --------
    >>> finite({"orbits": [1.0, float("nan")]})
    {'orbits': [1.0, None]}
    """
    if isinstance(value, dict):
        return {name: finite(part) for name, part in value.items()}
    if isinstance(value, list | tuple):
        return [finite(part) for part in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value
