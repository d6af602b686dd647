"""JSON documents of results: the version of their schema, and numbers that JSON can hold."""

import math
from typing import Any

#: Version of the keys of documents, and of their meaning.
SCHEMA = 2


def finite(value: Any) -> Any:
    """Return a document with None for infinite numbers and NaN, which JSON does not have.

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
