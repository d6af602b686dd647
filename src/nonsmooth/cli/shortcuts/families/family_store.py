"""The points of a long sweep on disk, in whole chunks, so that a run can be taken up again.

A file beside the target: one line of JSON that says what is being computed, then the points
as records of one size, each with a check sum.  What a killed run left of a chunk, or a power
cut of a record, is computed anew.
"""

import json
import os
import shutil
import stat
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import IO, Any

import numpy as np
import numpy.typing as npt

from nonsmooth.solver.shortcuts.search.family_points import POINT

from ...problems import Problem

#: The first line is filled up to this many bytes, or a multiple.
LINE = 512

#: Bytes a point takes in the file that is written at the end; nothing in a picture.
WRITTEN = {".csv": 230, ".json": 310, ".nc": 67}


#: A point in the store, and how many are looked at together.
RECORD = np.dtype([("point", POINT), ("check", "<u8")])
BLOCK = 1 << 16

#: Odd factors of the words of a point in its check sum: no change of one word goes unnoticed.
FACTORS = np.uint64(0x9E3779B97F4A7C15) * (2 * np.arange(POINT.itemsize // 8 + 1) + 1).astype(
    "<u8"
)


def check_sums(start: int, points: npt.NDArray[np.void]) -> npt.NDArray[np.uint64]:
    """Return the check sum of each point, which depends on its number as well."""
    words = np.ascontiguousarray(points).view("<u8").reshape(len(points), -1)
    numbers = np.arange(start + 1, start + 1 + len(points), dtype="<u8")
    return np.asarray(words @ FACTORS[1:] + numbers * FACTORS[0], dtype="<u8")


@dataclass(frozen=True)
class Store:
    """An open file of points, `offset` bytes after its start, and what it is called.

    Nothing is buffered: what cannot be written is said where it is, and not at the end again.
    """

    file: IO[bytes]
    offset: int
    name: str

    def __len__(self) -> int:
        """Return how many whole points the file holds."""
        size = os.fstat(self.file.fileno()).st_size
        return (size - self.offset) // RECORD.itemsize

    def sound(self) -> int:
        """Return how many points from the first on are as they were written."""
        for start in range(0, len(self), BLOCK):
            found = self._records(start, min(start + BLOCK, len(self)))
            wrong = np.flatnonzero(found["check"] != check_sums(start, found["point"]))
            if len(wrong):
                return start + int(wrong[0])
        return len(self)

    def write(self, start: int, points: npt.NDArray[np.void]) -> None:
        """Write points from number `start` on, and wait until they are on the disk.

        Raises
        ------
        Problem
            If the disk does not take them; it names the file.
        """
        records = np.empty(len(points), dtype=RECORD)
        records["point"], records["check"] = points, check_sums(start, points)
        with _named(self.name):
            _put(self.file, self.offset + start * RECORD.itemsize, records.tobytes())
            os.fsync(self.file.fileno())

    def read(self, start: int, stop: int) -> npt.NDArray[np.void]:
        """Return the points from number `start` up to, not including, number `stop`."""
        return np.ascontiguousarray(self._records(start, stop)["point"])

    def _records(self, start: int, stop: int) -> npt.NDArray[np.void]:
        self.file.seek(self.offset + start * RECORD.itemsize)
        content = self.file.read((stop - start) * RECORD.itemsize)
        return np.frombuffer(content, dtype=RECORD)


def check_room(target: Path | None, count: int) -> None:
    """Check that the disk has room for the points that are not there yet, and for the file.

    Raises
    ------
    Problem
        Naming the folder, what is needed and what there is.
    """
    folder = Path(tempfile.gettempdir()) if target is None else target.parent
    there = beside(target).stat().st_size if target and beside(target).exists() else 0
    each = RECORD.itemsize + (WRITTEN.get(target.suffix.lower(), 0) if target else 0)
    needed, free = count * each - there, shutil.disk_usage(folder).free
    if needed > free:
        where = f"about {needed / 1e9:.3g} GB in {folder}, where {free / 1e9:.3g} GB are free"
        raise Problem(f"--vary: {count} points need {where}")


def beside(target: Path) -> Path:
    """Return the file that holds the points of an unfinished sweep."""
    return target.with_name(f"{target.name}.part")


@contextmanager
def _named(name: object) -> Iterator[None]:
    """Turn an error of the disk into the problem of the file of this name."""
    try:
        yield
    except OSError as error:
        raise Problem(f"-o: cannot write {name}: {error.strerror or error}") from error


def _put(file: IO[bytes], place: int, content: bytes) -> None:
    """Write all of `content` at `place`: without a buffer a write may end early."""
    file.seek(place)
    rest = memoryview(content)
    while rest:
        rest = rest[file.write(rest) :]


def _descriptor(path: Path) -> int:
    """Open the file of the points, or make it.

    Raises
    ------
    Problem
        If it is a symbolic link, which may lead into another file, or not a file.
    """
    if path.is_symlink():
        raise Problem(f"-o: {path} is a symbolic link, expected a file or none")
    # Without waiting for the other end, should it be a pipe.
    only = getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_NONBLOCK", 0)
    with _named(path):
        found = os.open(path, os.O_RDWR | os.O_CREAT | only, 0o666)
    if not stat.S_ISREG(os.fstat(found).st_mode):
        os.close(found)
        raise Problem(f"-o: {path} is a device or a pipe, expected a file or none")
    return found


def _lock(file: IO[bytes], path: Path) -> None:
    """Keep other runs off the file until it is closed; the end of the process closes it."""
    try:
        import fcntl  # noqa: PLC0415
    except ImportError:  # not a POSIX system
        return
    try:
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError as error:
        raise Problem(f"-o: another run is writing {path}; wait for its end") from error


@contextmanager
def opened(target: Path | None, plan: dict[str, Any]) -> Iterator[Store]:
    """Open the store of a sweep, new or begun; without a target, one that will vanish.

    Raises
    ------
    Problem
        If the file holds another sweep, another run is writing it, or it is a link or a pipe.
    """
    text = json.dumps(plan)
    line = text.encode().ljust(LINE * (len(text) // LINE + 1) - 1) + b"\n"
    if target is None:
        with tempfile.TemporaryFile(buffering=0) as file:
            yield Store(file, 0, f"a temporary file in {tempfile.gettempdir()}")
        return
    path = beside(target)
    with open(_descriptor(path), "r+b", buffering=0) as file:
        _lock(file, path)
        begun = file.readline()
        if not line.startswith(begun):
            raise Problem(
                f"-o: {path} holds another sweep; finish it by its own command, or delete it"
            )
        if begun != line:
            with _named(path):
                _put(file, 0, line)
        yield Store(file, len(line), str(path))
