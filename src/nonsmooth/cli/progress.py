"""Progress on stderr: a bar on a terminal, else a plain line now and then."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager

import click


@contextmanager
def progress(total: int, task: str) -> Iterator[Callable[[str], None]]:
    """Yield a callback that takes what has just been done, in words; `total` of them."""
    from rich.console import Console  # noqa: PLC0415
    from rich.progress import Progress  # noqa: PLC0415

    console = Console(stderr=True)
    if not console.is_terminal:
        yield _counter(total, task)
        return
    with Progress(console=console, transient=True) as bar:
        job = bar.add_task(task, total=total)
        yield lambda done: bar.update(job, advance=1, description=f"{task}: {done}")


def _counter(total: int, task: str) -> Callable[[str], None]:
    """Return a callback that writes a line at every tenth of the way."""
    count = 0

    def advance(done: str) -> None:
        nonlocal count
        count += 1
        if count * 10 // total > (count - 1) * 10 // total:
            click.echo(f"{task}: {count} of {total} done ({done})", err=True)

    return advance
