"""The command line: ``nonsmooth scenes``, ``generate``, ``equations``, ``solve``, ``modes``.

Results go to stdout, progress and messages to stderr.  Exit status: 0 done, 1 no converged
and admissible orbit (or, for ``generate --check``, a difference), 2 bad input, 130
interrupted.

A command imports what it runs when it runs: help and completion need neither NumPy nor SymPy.
"""

import contextlib
import io
import os
import sys
from collections.abc import Iterator, Sequence
from typing import Any, NoReturn

import click

from ..extras import MissingExtra
from .about import no_such_option
from .commands.equations import equations
from .commands.generate import generate
from .commands.listing import modes, scenes
from .commands.version import show_version
from .named import SCENES, STRUCTURES, NamedCommand
from .output import discard_stdout
from .problems import Problem, print_warnings, say

EXAMPLES = """\b
Examples:
  nonsmooth solve --tol 1e-8
  nonsmooth solve --method c1 --order 7
  nonsmooth sweep --orders 1-40 -o convergence.png
  nonsmooth equations --format latex -o equations.tex
  nonsmooth scenes
  nonsmooth solve impact --gap 0.2
  nonsmooth modes beam-mass --position 1/3
"""


class _ReaderLeft(Exception):  # noqa: N818
    """The reader of stdout has closed the pipe: it has what it wanted."""


@contextlib.contextmanager
def _reader() -> Iterator[None]:
    """Raise `_ReaderLeft` in place of a broken pipe."""
    try:
        yield
    except BrokenPipeError as error:
        raise _ReaderLeft from error


class _Commands(click.Group):
    """Commands, some of which take a scene or a structure as their first argument.

    Click does not make their broken pipe an exit with 1: that is for no orbit.
    """

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        name, command, rest = super().resolve_command(ctx, args)
        if not isinstance(command, NamedCommand):
            return name, command, rest
        try:
            chosen, about, remaining = command.chosen(rest)
        except (click.UsageError, Problem):
            if ctx.resilient_parsing:  # for completion
                return name, command, rest
            raise
        return f"{name} {about}".strip(), chosen, remaining

    def make_context(self, *arguments: Any, **options: Any) -> click.Context:
        with _reader():  # of the version, or of help
            return super().make_context(*arguments, **options)

    def invoke(self, ctx: click.Context) -> Any:
        with _reader():
            return super().invoke(ctx)


@click.group(
    cls=_Commands, epilog=EXAMPLES, context_settings={"help_option_names": ["-h", "--help"]}
)
@click.option(
    "--version", is_flag=True, expose_value=False, is_eager=True, callback=show_version,
    help="Show version information and exit.",
)  # fmt: skip
def cli() -> None:
    """Periodic orbits of non-smooth oscillators by harmonic balance and Galerkin expansions.

    After W.-J. Kim and N. C. Perkins, J. Sound Vib. 261 (2003) 213-224. Most commands take a
    SCENE first: a name that 'nonsmooth scenes' lists, or the path of a scene file. Without one
    they are about the stick-slip oscillator of that paper. 'nonsmooth solve SCENE --help' has
    the parameters of a scene.
    """


#: The commands that take a scene, and without one are about the default scene.
VERBS = {
    "solve": "Compute periodic orbits, with error and stability.",
    "sweep": "Compare orders and methods, or vary a parameter.",
    "branch": "Follow an orbit along a parameter, through folds and flips.",
    "map": "Map motions, stable or not, over two parameters.",
    "simulate": "Simulate from a given state; bifurcation diagrams, basins.",
    "digits": "Measure how many digits float64 keeps.",
    "tradeoff": "Measure time against error of each method.",
    "report": "Write a page that recomputes the paper, or about a scene.",
}
for name, summary in VERBS.items():
    kinds = (SCENES, STRUCTURES) if name == "sweep" else (SCENES,)
    cli.add_command(NamedCommand(name, kinds=kinds, help=summary))
cli.add_command(
    NamedCommand("stability", hidden=True, help="The old name of `nonsmooth digits`.")
)
help_of_roots = "List all real solutions of the paper's C1 series."
cli.add_command(NamedCommand("roots", kinds=(), help=help_of_roots))
for command in (scenes, generate, equations, modes):
    cli.add_command(command)


def _fail(message: str, status: int, below: Sequence[str] = ()) -> NoReturn:
    say(message, below)
    sys.exit(status)


def _said(error: click.UsageError) -> str:
    if isinstance(error, click.NoSuchOption):
        return no_such_option(error)
    message = error.format_message()
    if message.startswith("Got unexpected extra argument"):
        message += "; what a command is about comes first, before all options"
    return message


def _print_what_can_be() -> None:
    """Print a question mark, not an error, for a character that a terminal does not have."""
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper) and stream.errors == "strict":
            stream.reconfigure(errors="replace")


def main(arguments: list[str] | None = None) -> NoReturn:
    """Run the command line; every mistake is one sentence and a status, never a traceback."""
    # For matrices as small as these threads cost more than they give: twice the time.
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    _print_what_can_be()
    print_warnings()
    context: dict[str, Any] = {"prog_name": "nonsmooth", "standalone_mode": False}
    try:
        status = cli.main(arguments, **context)
        sys.stdout.flush()
    except click.exceptions.NoArgsIsHelpError as help_:
        click.echo(help_.format_message())
        sys.exit(0)
    except click.UsageError as error:
        where = f" {error.ctx.command_path}" if error.ctx else ""
        _fail(f"{_said(error)} (see{where} --help)", 2)
    except click.ClickException as error:
        _fail(error.format_message(), 2)
    except Problem as problem:
        _fail(str(problem), problem.status, problem.below)
    except (click.Abort, KeyboardInterrupt):
        _fail("interrupted", 130)
    except (_ReaderLeft, BrokenPipeError):
        discard_stdout()
        sys.exit(0)
    except (MissingExtra, OSError) as error:
        _fail(str(error), 2)
    except MemoryError as error:
        _fail(f"not enough memory: {error}", 2)
    sys.exit(status if isinstance(status, int) else 0)
