"""Messages on bad input and on orbits that do not exist: one sentence, and lines below it."""

import warnings
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from types import MappingProxyType
from typing import TextIO

import click

from nonsmooth.solver.no_orbit import NoOrbit

#: The options of a command that takes several methods, and orders.
PLURAL = {"method": "methods", "order": "orders"}

#: Most starts of a search that are told without ``--verbose``: as many first as last ones.
MOST_TOLD = 4

#: What is wrong on the whole: there is no such option.
NO_OPTIONS = "body", "parameters"


class Problem(Exception):  # noqa: N818  (its text is what the user reads)
    """What `main` prints on stderr.

    Parameters
    ----------
    message : str
        One line: the argument, the value, what was expected.
    status : int
        Exit status: 2 for bad input, 1 for an orbit that is not there, 130 after Ctrl-C.
    below : sequence of str
        What is printed below it, a line each: further mistakes, or what was tried.
    """

    def __init__(self, message: str, status: int = 2, below: Sequence[str] = ()) -> None:
        super().__init__(" ".join(message.split("\n")))
        self.status, self.below = status, below


def say(message: str, below: Iterable[str] = ()) -> None:
    """Print a sentence on stderr, and lines below it."""
    click.echo("\n  ".join((f"nonsmooth: {message}", *below)), err=True)


class Verbose(click.Option):
    """``--verbose``, which any command may have: `is_verbose` says whether it was given."""

    def __init__(self) -> None:
        super().__init__(
            ["-v", "--verbose"], is_flag=True, expose_value=False,
            callback=lambda ctx, _, given: ctx.meta.update({__name__: given}),
            help="If no orbit is found, list all that was tried.",
        )  # fmt: skip


def is_verbose() -> bool:
    """Whether the command that runs was given ``--verbose``."""
    context = click.get_current_context(silent=True)
    return context is not None and bool(context.meta.get(__name__))


def reasons(finding: NoOrbit) -> tuple[str, ...]:
    """Return why there is no orbit: one sentence, then further findings and what was tried."""
    sentence, *further = [finding.reason] if finding.proven else finding.reason.split("; ")
    return sentence, *further, *_shortened(finding.tried)


def _shortened(tried: Sequence[str]) -> Iterator[str]:
    """Yield the first and last lines of what was tried, and how many are left out."""
    left_out = 0 if is_verbose() else len(tried) - MOST_TOLD
    if left_out <= 1:  # a line that says so would be as long
        yield from tried
        return
    yield from tried[: MOST_TOLD // 2]
    yield f"... and {left_out} more starts, which --verbose shows ..."
    yield from tried[-MOST_TOLD // 2 :]


def tell(finding: NoOrbit, said: set[str] | None = None) -> None:
    """Say on stderr why there is no orbit: what was found, and below it what was tried.

    What is in `said`, but for the method in front, is not said at length again; it is added.
    """
    sentence, *below = reasons(finding)
    of_what, _, why = sentence.partition(": ")
    message, cause = "; ".join((sentence, *below)), "; ".join((why, *below))
    said = set() if said is None else said
    if message not in said and cause in said:
        say(f"{of_what}: no orbit, for the same reasons")
    elif message not in said:
        say(sentence, below)
    said.update((message, cause))


def tell_none(messages: Sequence[str]) -> None:
    """Say on stderr why the first row of a table has no orbit, if all rows have a message."""
    if all(messages):
        sentence, *below = messages[0].split("; ")
        say(f"no row has an orbit, the first for this reason: {sentence}", _shortened(below))


@contextmanager
def as_problems(
    names: Mapping[str, str] = MappingProxyType({}), of: str | None = None
) -> Iterator[None]:
    """Turn a `ValueError` on an argument into a `Problem` of the option; `names` maps them.

    Where no option gives the parameters that are wrong, `of` says where they are from.
    """
    try:
        yield
    except ValueError as error:
        from nonsmooth.solver.bodies.systems import BodyError
        from nonsmooth.solver.scenes.parameter_error import ParameterError

        if of is not None and isinstance(error, ParameterError):
            raise Problem(f"{of}{error}") from error
        if isinstance(error, BodyError):  # what is wrong shows in its phases, not in an option
            raise Problem(f"body: {error}") from error
        name, _, message = str(error).partition(": ")
        if name in NO_OPTIONS:
            raise Problem(str(error)) from error
        raise Problem(f"--{names.get(name, name).replace('_', '-')}: {message}") from error


def print_warnings() -> None:
    """Print warnings of this package as one line on stderr; leave others as they are."""
    usual = warnings.showwarning

    def show(
        message: Warning | str, category: type[Warning], filename: str, lineno: int,
        file: TextIO | None = None, line: str | None = None,
    ) -> None:  # fmt: skip
        if category.__module__.partition(".")[0] == __package__.partition(".")[0]:
            say(str(message))
        else:
            usual(message, category, filename, lineno, file, line)

    warnings.showwarning = show
