"""JSON documents as text, with the SHA-256 of their content at the end.

The digest is of what the text says and not of the text: another order of keys, other spaces or
``1`` for ``1.0`` leave it as it is.
"""

import hashlib
import json
import warnings
from collections.abc import Mapping
from numbers import Integral
from pathlib import Path
from typing import Any

from nonsmooth.solver.presentation.documents import SCHEMA, finite

from .file_errors import FileError, FileWarning, damaged

#: The key of the digest, and that of the rows, which are digested one by one.
DIGEST, ROWS = "sha256", "rows"

#: Whole numbers above are not all numbers of float64.
MOST_EXACT = 2**53


def as_json(document: dict[str, Any]) -> str:
    """Return a JSON document with its schema version; what is not finite is null."""
    return json.dumps(finite({"schema": SCHEMA} | document), indent=2, allow_nan=False)


def sealed(document: dict[str, Any]) -> str:
    """Return a JSON document that ends with the digest of its content."""
    content = finite({"schema": SCHEMA} | document)
    return as_json(content | {DIGEST: digest(content)}) + "\n"


def digest(document: Mapping[str, Any]) -> str:
    """Return the digest of a document as JSON has it.

    Examples
    --------
    >>> digest({"a": 1, "b": [0.5]}) == digest({"b": [0.5], "a": 1.0, "sha256": "any"})
    True
    """
    head = {key: value for key, value in document.items() if key not in (DIGEST, ROWS)}
    rows = document.get(ROWS)
    sha = hashlib.sha256(_canonical(head))
    for row in rows if isinstance(rows, list) else [rows]:
        sha.update(_canonical(row))
    return sha.hexdigest()


def parsed(path: Path, text: bytes | str) -> dict[str, Any]:
    """Return the document that is the text of a file, or stands in it.

    A `FileError` is raised if it is not the text of a document, or of one of a schema that is
    not known here.
    """
    try:
        document = json.loads(text if isinstance(text, str) else text.decode("utf-8"))
    except (ValueError, RecursionError) as error:  # of the encoding, or of the JSON
        raise damaged(path, f"not JSON: {error}") from error
    if not isinstance(document, dict):
        raise FileError(path, "not a file of nonsmooth")
    check_schema(path, document.get("schema"))
    return document


def check_schema(path: Path, schema: object) -> None:
    """Check that a file has a schema version that this version reads; else a `FileError`."""
    if isinstance(schema, Integral) and int(schema) > SCHEMA:
        newer = f"schema {schema} is from a newer nonsmooth"
        raise FileError(path, f"{newer}; this one knows up to {SCHEMA}")
    if not (isinstance(schema, Integral) and int(schema) >= 1):
        raise FileError(path, "not a file of nonsmooth: it has no schema")


def check_digest(path: Path, document: Mapping[str, Any]) -> None:
    """Warn of a document that has no digest, or another than that of its content."""
    stated = document.get(DIGEST)
    if stated is None:
        problem = "has no digest (sha256): whether it was changed cannot be told"
    elif stated != digest(document):
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
