"""What a sweep over a parameter computes, cut into chunks, and the computing of them."""

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import click
import numpy as np
import numpy.typing as npt

from nonsmooth.files.shortcuts import points
from nonsmooth.solver.shortcuts.orbit.methods import METHODS, with_terms
from nonsmooth.solver.shortcuts.orbit.oscillator import StickSlip
from nonsmooth.solver.shortcuts.search import family, family_points, kernels

from ...progress import progress
from ...values.vary import Vary
from ...workers import in_order
from .family_store import Store, beside

Points = npt.NDArray[np.void]

#: Points that a process computes at once by a Fourier series, and by Section 3.3.
FOURIER_CHUNK, C1_CHUNK = 512, family.CHUNK


@dataclass(frozen=True)
class Job:
    """One sweep: the oscillator, the parameter, and the methods, whose points follow on."""

    belt: StickSlip
    vary: Vary
    methods: tuple[str, ...]
    order: int
    c1_terms: int

    def __len__(self) -> int:
        return len(self.methods) * self.vary.count

    def saved(self, store: Store) -> points.Points:
        """Return the points of the store as they are written to a file."""
        vary = self.vary
        fixed = (self.belt, vary.parameter, self.methods, self.order, self.c1_terms)
        return points.Points(points.Head(*fixed, vary.count), store.read)

    def families(self, found: Mapping[str, Points]) -> dict[str, family.Family]:
        """Return some of the points of each method as a family."""
        fixed = (self.belt, self.vary.parameter)
        return {
            name: family.Family(*fixed, name, self.order, self.c1_terms, points)
            for name, points in found.items()
        }

    def plan(self) -> dict[str, Any]:
        """Return all that the points depend on."""
        from nonsmooth import __version__  # noqa: PLC0415

        generated = [kernels.module(name).BODY for name in kernels.MODULES]
        return asdict(self) | {"version": __version__, "generated": generated}

    def chunks(self, size: int) -> "Iterator[Chunk]":
        """Yield all points in chunks of at most this size."""
        for method in self.methods:
            yield from self.chunks_of(method, size)

    def chunks_of(self, method: str, size: int) -> "Iterator[Chunk]":
        """Yield the points of one method in chunks of at most this size."""
        before = self.methods.index(method) * self.vary.count
        for start in range(0, self.vary.count, size):
            stop = min(start + size, self.vary.count)
            yield Chunk(self, method, start, stop, before + start)


@dataclass(frozen=True)
class Chunk:
    """Points of one method, from number `start` up to `stop`; the place of the first."""

    job: Job
    method: str
    start: int
    stop: int
    place: int

    def __len__(self) -> int:
        return self.stop - self.start

    def compute(self) -> Points:
        """Compute the points."""
        job = self.job
        terms = job.c1_terms if self.method == "hb-c1" else 1
        method = with_terms(METHODS[self.method], terms)
        values = job.vary.values(self.start, self.stop)
        return family_points.points(job.belt, job.vary.parameter, values, method, job.order)


def compute(job: Job, store: Store, target: Path | None) -> None:
    """Compute the points that the store does not hold."""
    done = min(store.sound(), len(job))
    todo = [
        chunk
        for method in job.methods
        for chunk in job.chunks_of(method, C1_CHUNK if method == "c1" else FOURIER_CHUNK)
        if chunk.place + len(chunk) > done
    ]
    if done:
        click.echo(f"going on after {done} of {len(job)} points", err=True)
    several = sum(chunk.method != "c1" for chunk in todo) > 1
    apply: Callable[..., Iterable[tuple[Chunk, Points]]] = in_order if several else _one_by_one
    with progress(len(todo), "sweep") as advance:
        try:
            for chunk, found in apply(Chunk.compute, todo):
                store.write(chunk.place, found)
                advance(f"{chunk.method}, {job.vary.flag} = {found['value'][-1]:g}")
        except KeyboardInterrupt:
            if target is not None:
                kept = f"{len(store)} of {len(job)} points are kept in {beside(target)}"
                click.echo(f"{kept}; the same command goes on after them", err=True)
            raise


def _one_by_one(
    work: Callable[[Chunk], Points], chunks: Iterable[Chunk]
) -> Iterator[tuple[Chunk, Points]]:
    for chunk in chunks:
        yield chunk, work(chunk)
