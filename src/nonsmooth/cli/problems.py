"""A mistake of the user, or an orbit that is not there: one line and an exit status."""

import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from typing import TextIO

import click


class Problem(Exception):  # noqa: N818  (its text is what the user reads)
    """What `main` prints on stderr.

    Parameters
    ----------
    message : str
        One line: the argument, the value, what was expected.
    status : int
        Exit status: 2 for bad input, 1 for an orbit that is not there, 130 after Ctrl-C.
    """

    def __init__(self, message: str, status: int = 2) -> None:
        super().__init__(" ".join(message.split("\n")))
        self.status = status


def about_option(error: ValueError) -> Problem:
    """Return the problem of a wrong order or number of C1 functions, naming its option."""
    text = str(error)
    if text.startswith("c1_terms"):
        return Problem("--c1-terms" + text.removeprefix("c1_terms"))
    return Problem(f"--orders: {text}")


@contextmanager
def as_problems(*, plural: bool = False) -> Iterator[None]:
    """Turn a wrong argument into the problem of the option of its name, or of its plural."""
    try:
        yield
    except ValueError as error:
        name, _, rest = str(error).partition(": ")
        option = f"{name}s" if plural and name in {"method", "order"} else name
        raise Problem(f"--{option}: {rest}") from error


def print_warnings() -> None:
    """Let warnings of this package be one line each on stderr, and others what they are."""
    others = warnings.showwarning

    def show(
        message: Warning | str, category: type[Warning], filename: str, lineno: int,
        file: TextIO | None = None, line: str | None = None,
    ) -> None:  # fmt: skip
        if category.__module__.partition(".")[0] == __package__.partition(".")[0]:
            click.echo(f"nonsmooth: {message}", err=True)
        else:
            others(message, category, filename, lineno, file, line)

    warnings.showwarning = show
