"""JSON documents as text, with the SHA-256 of that text at the end."""

import hashlib
import json
import math
from typing import Any

#: Version of what is in the files; a file with a higher one is from a newer program.
SCHEMA = 1

DIGEST = '  "sha256": '


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


def sealed(document: dict[str, Any]) -> str:
    """Return a JSON document that ends with the digest of its text."""
    text = as_json(document).removesuffix("\n}") + ",\n"
    return text + seal(text)


def seal(text: str) -> str:
    """Return the end of a document whose text so far is `text`."""
    return f'{DIGEST}"{hashlib.sha256(text.encode()).hexdigest()}"\n}}\n'
