"""The SHA-256 behind the content of a netCDF file, which tells whether bytes were damaged."""

import hashlib
import warnings
from pathlib import Path

from .errors import FileWarning, damaged

#: Bytes that are read at once; what the seal starts with, and its length.
BLOCK = 1 << 24
SEAL = b"nonsmooth sha256 "
SEALED = len(SEAL) + 64


def seal_of(path: Path, size: int) -> bytes:
    """Return what stands behind the first `size` bytes of a file, which HDF5 does not read.

    A changed byte is found before HDF5 sees it: some would crash it.
    """
    digest = hashlib.sha256()
    with path.open("rb") as file:
        while size > 0 and (block := file.read(min(size, BLOCK))):
            digest.update(block)
            size -= len(block)
    return SEAL + digest.hexdigest().encode()


def has_seal(path: Path) -> bool:
    """Return whether a file is sealed, as no file is that another program wrote.

    Raises
    ------
    FileError
        If it is, and its bytes are others: to read it might crash.
    """
    size = path.stat().st_size - SEALED
    with path.open("rb") as file:
        file.seek(max(size, 0))
        found = file.read()
    if not found.startswith(SEAL):
        return False
    if found != seal_of(path, size):
        raise damaged(path, "its bytes are not those of its digest (sha256)")
    return True


def warn_without(path: Path) -> None:
    """Warn of a file without a digest."""
    words = "has no digest (sha256): whether it was changed cannot be told"
    warnings.warn(f"{path} {words}", FileWarning, stacklevel=2)
