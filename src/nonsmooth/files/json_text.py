"""JSON documents as text, with the SHA-256 of their content at the end.

The digest is of what the text says and not of the text: another order of keys, other spaces or
``1`` for ``1.0`` leave it as it is.
"""

import hashlib
import json
import math
import warnings
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from .errors import FileWarning

#: Version of what is in the files; a file with a higher one is from a newer program.
SCHEMA = 1

#: The key of the digest, and that of the rows, which are digested one by one.
DIGEST, ROWS = "sha256", "rows"

#: Whole numbers above are not all numbers of float64.
MOST_EXACT = 2**53


def finite(value: Any) -> Any:
    """Return `value` with null for numbers that JSON has no word for."""
    if isinstance(value, dict):
        return {key: finite(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [finite(item) for item in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value


def as_json(document: dict[str, Any]) -> str:
    """Return a JSON document with its schema version; what is not finite is null."""
    return json.dumps(finite({"schema": SCHEMA} | document), indent=2, allow_nan=False)


class Digest:
    """The SHA-256 of a document that is written bit by bit.

    Parameters
    ----------
    head : mapping
        The document without its rows.
    """

    def __init__(self, head: Mapping[str, Any]) -> None:
        left = {key: value for key, value in head.items() if key not in (DIGEST, ROWS)}
        self._hash = hashlib.sha256(_canonical(left))

    def add(self, row: Any) -> None:
        """Add a row."""
        self._hash.update(_canonical(row))

    def hexdigest(self) -> str:
        """Return the digest of all so far."""
        return self._hash.hexdigest()


def digest(document: Mapping[str, Any]) -> str:
    """Return the digest of a document as JSON has it.

    Examples
    --------
    >>> digest({"a": 1, "b": [0.5]}) == digest({"b": [0.5], "a": 1.0, "sha256": "any"})
    True
    """
    found = Digest(document)
    rows = document.get(ROWS)
    for row in rows if isinstance(rows, list) else [rows]:
        found.add(row)
    return found.hexdigest()


def sealed(document: dict[str, Any]) -> str:
    """Return a JSON document that ends with the digest of its content."""
    content = finite({"schema": SCHEMA} | document)
    return end(as_json(document).removesuffix("\n}") + ",\n", digest(content))


def end(text: str, found: str) -> str:
    """Return a document whose text so far is `text`, ended with its digest."""
    return f'{text}  "{DIGEST}": "{found}"\n}}\n'


def check_digest(path: Path, document: Mapping[str, Any]) -> None:
    """Warn of a document that has no digest, or another than that of its content."""
    found = document.get(DIGEST)
    if found is None:
        problem = "has no digest (sha256): whether it was changed cannot be told"
    elif found != digest(document):
        problem = "was changed since it was written: its digest (sha256) is another"
    else:
        return
    warnings.warn(f"{path} {problem}", FileWarning, stacklevel=2)


def _canonical(value: Any) -> bytes:
    return json.dumps(_plain(value), sort_keys=True, separators=(",", ":")).encode()


def _plain(value: Any) -> Any:
    """Return `value` with every number as a float: ``1`` and ``1.0`` are the same."""
    if isinstance(value, Mapping):
        return {key: _plain(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [_plain(item) for item in value]
    if isinstance(value, float) or (type(value) is int and abs(value) <= MOST_EXACT):
        return value + 0.0  # of -0.0 as well
    return value
