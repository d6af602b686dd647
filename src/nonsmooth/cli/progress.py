"""Progress on stderr: a bar on a terminal, else a plain line now and then."""

import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from datetime import timedelta

import click

MINUTE = 60.0


@contextmanager
def progress(total: int, task: str) -> Iterator[Callable[[str], None]]:
    """Yield a callback that takes what has just been done, in words; `total` of them.

    Where that is one, it says nothing.
    """
    if total == 1:
        yield lambda done: None
        return
    from rich.console import Console  # noqa: PLC0415
    from rich.progress import Progress  # noqa: PLC0415

    console = Console(stderr=True)
    if not console.is_terminal:
        yield _counter(total, task)
        return
    with Progress(console=console, transient=True) as bar:
        job = bar.add_task(task, total=total)
        yield lambda done: bar.update(job, advance=1, description=f"{task}: {done}")


@contextmanager
def busy(task: str) -> Iterator[None]:
    """Show on a terminal that something takes a few seconds; elsewhere nothing."""
    if not sys.stderr.isatty():
        yield
        return
    from rich.console import Console  # noqa: PLC0415

    with Console(stderr=True).status(task):
        yield


def _counter(total: int, task: str) -> Callable[[str], None]:
    """Return a callback that writes a line, with the time left, each tenth and each minute."""
    count, begin, last = 0, time.monotonic(), time.monotonic()

    def advance(done: str) -> None:
        nonlocal count, last
        count += 1
        now = time.monotonic()
        if count * 10 // total > (count - 1) * 10 // total or now - last >= MINUTE:
            left, last = (now - begin) / count * (total - count), now
            ahead = f", about {timedelta(seconds=round(left))} left" if left >= 1 else ""
            click.echo(f"{task}: {count} of {total} done ({done}){ahead}", err=True)

    return advance
