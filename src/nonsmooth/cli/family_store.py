"""The points of a long sweep on disk, in whole chunks, so that a run can be taken up again.

A file beside the target: one line of JSON that says what is being computed, then the points
as fixed-size records.  What a killed run left of a chunk is overwritten.
"""

import json
import os
import shutil
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import IO, Any

import numpy as np
import numpy.typing as npt

from nonsmooth.solver.family_points import POINT

from .problems import Problem

#: The first line is filled up to this many bytes, or a multiple.
LINE = 512

#: Bytes a point takes in the file that is written at the end; nothing in a picture.
WRITTEN = {".csv": 230, ".json": 310, ".nc": 67}


@dataclass(frozen=True)
class Store:
    """An open file of points, `offset` bytes after its start."""

    file: IO[bytes]
    offset: int

    def done(self) -> int:
        """Return how many whole points the file holds."""
        size = os.fstat(self.file.fileno()).st_size
        return (size - self.offset) // POINT.itemsize

    def write(self, start: int, points: npt.NDArray[np.void]) -> None:
        """Write points from number `start` on, and wait until they are on the disk."""
        self.file.seek(self.offset + start * POINT.itemsize)
        self.file.write(points.tobytes())
        self.file.flush()
        os.fsync(self.file.fileno())

    def read(self, start: int, stop: int) -> npt.NDArray[np.void]:
        """Return the points from number `start` up to, not including, number `stop`."""
        self.file.seek(self.offset + start * POINT.itemsize)
        content = self.file.read((stop - start) * POINT.itemsize)
        return np.frombuffer(content, dtype=POINT)


def check_room(target: Path | None, count: int) -> None:
    """Check that the disk has room for the points that are not there yet, and for the file.

    Raises
    ------
    Problem
        Naming the folder, what is needed and what there is.
    """
    folder = Path(tempfile.gettempdir()) if target is None else target.parent
    there = beside(target).stat().st_size if target and beside(target).exists() else 0
    each = POINT.itemsize + (WRITTEN.get(target.suffix.lower(), 0) if target else 0)
    needed, free = count * each - there, shutil.disk_usage(folder).free
    if needed > free:
        where = f"about {needed / 1e9:.3g} GB in {folder}, where {free / 1e9:.3g} GB are free"
        raise Problem(f"--vary: {count} points need {where}")


def beside(target: Path) -> Path:
    """Return the file that holds the points of an unfinished sweep."""
    return target.with_name(f"{target.name}.part")


@contextmanager
def opened(target: Path | None, plan: dict[str, Any]) -> Iterator[Store]:
    """Open the store of a sweep, new or begun; without a target, one that will vanish.

    Raises
    ------
    Problem
        If the file holds another sweep.
    """
    text = json.dumps(plan)
    line = text.encode().ljust(LINE * (len(text) // LINE + 1) - 1) + b"\n"
    if target is None:
        with tempfile.TemporaryFile() as file:
            yield Store(file, 0)
        return
    path = beside(target)
    with open(os.open(path, os.O_RDWR | os.O_CREAT, 0o666), "r+b") as file:
        begun = file.readline()
        if not line.startswith(begun):
            raise Problem(
                f"-o: {path} holds another sweep; finish it by its own command, or delete it"
            )
        if begun != line:
            file.seek(0)
            file.write(line)
            file.flush()
        yield Store(file, len(line))
