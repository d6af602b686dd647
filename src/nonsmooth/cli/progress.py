"""Progress on stderr: a bar on a terminal, else a plain line now and then.

Short tasks print nothing: a terminal shows a bar after `SOON` seconds, elsewhere the
first line comes after `QUIET` seconds.
"""

import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, ExitStack, contextmanager
from datetime import timedelta
from typing import TYPE_CHECKING

import click

if TYPE_CHECKING:
    from rich.console import Console

#: Seconds of silence at first: on a terminal, and elsewhere.
SOON, QUIET = 1.0, 10.0

#: Seconds between two lines where nothing else is to be said.
MINUTE = 60.0


@contextmanager
def progress(total: int, task: str) -> Iterator[Callable[[str], None]]:
    """Yield a callback to be called with words on each of `total` parts that is done.

    A single part shows no progress.
    """
    if total == 1:
        yield lambda done: None
        return
    console = _terminal()
    if console is None:
        yield _counter(total, task)
        return
    from rich.progress import Progress

    bar = Progress(console=console, transient=True)
    job = bar.add_task(task, total=total)
    with _shown_later(bar):
        yield lambda done: bar.update(job, advance=1, description=f"{task}: {done}")


@contextmanager
def busy(task: str) -> Iterator[Callable[[str], None]]:
    """Show that a task goes on; yield a callback to be called with what it does now."""
    console = _terminal()
    if console is None:
        with _lines(task) as say:
            yield say
        return
    status = console.status(task)
    with _shown_later(status):
        yield lambda now: status.update(f"{task}: {now}")


def _terminal() -> "Console | None":
    """Return a console on stderr; None where that is not a terminal."""
    if not sys.stderr.isatty():
        return None
    from rich.console import Console

    console = Console(stderr=True)
    return console if console.is_terminal else None


@contextmanager
def _shown_later(display: AbstractContextManager[object]) -> Iterator[None]:
    """Show a display after `SOON` seconds, and remove it in the end."""
    with ExitStack() as shown:
        timer = threading.Timer(SOON, shown.enter_context, [display])
        timer.daemon = True
        timer.start()
        try:
            yield
        finally:
            timer.cancel()
            timer.join()


@contextmanager
def _lines(task: str) -> Iterator[Callable[[str], None]]:
    """Print a line after `QUIET` seconds and every minute, with the words of the callback."""
    begin, finished, current = time.monotonic(), threading.Event(), [task]

    def write() -> None:
        pause = QUIET
        while not finished.wait(pause):
            pause = MINUTE
            passed = timedelta(seconds=round(time.monotonic() - begin))
            click.echo(f"{current[-1]} ({passed} so far)", err=True)

    def say(now: str) -> None:
        current[-1] = f"{task}: {now}"

    writer = threading.Thread(target=write, daemon=True)
    writer.start()
    try:
        yield say
    finally:
        finished.set()
        writer.join()


def _counter(total: int, task: str) -> Callable[[str], None]:
    """Return a callback that writes a line, with the time left, each tenth and each minute."""
    begin = time.monotonic()
    count, last = 0, begin

    def advance(done: str) -> None:
        nonlocal count, last
        count += 1
        now = time.monotonic()
        if now - begin < QUIET:
            return
        if count * 10 // total > (count - 1) * 10 // total or now - last >= MINUTE:
            left, last = (now - begin) / count * (total - count), now
            ahead = f", about {timedelta(seconds=round(left))} left" if left >= 1 else ""
            click.echo(f"{task}: {count} of {total} done ({done}){ahead}", err=True)

    return advance
