"""The version of what is in a file."""

from pathlib import Path

from .errors import FileError
from .json_text import SCHEMA


def check_schema(path: Path, schema: object) -> None:
    """Check that the file is of a schema known here.

    Raises
    ------
    FileError
        If it is not.
    """
    if isinstance(schema, int) and schema > SCHEMA:
        raise FileError(
            path, f"schema {schema} is from a newer nonsmooth; this one knows up to {SCHEMA}"
        )
    if schema != SCHEMA:
        raise FileError(path, "not a file of nonsmooth: it has no schema")
