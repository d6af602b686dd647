"""What a flag that is not there may have been meant for."""

from collections.abc import Sequence
from difflib import get_close_matches

import click

#: Flags of earlier versions, and what is asked in their place.
RENAMED = {"--c1-terms": "--functions K, with --method hb-ck,"}


def suggested(given: str, flags: Sequence[str]) -> list[str]:
    """Return the flags that begin with what was typed; else the closest, if one is close.

    Examples
    --------
    >>> suggested("--freq", ["--force", "--frequency", "--mu-s", "--mu-k"])
    ['--frequency']
    >>> suggested("--mu", ["--force", "--frequency", "--mu-s", "--mu-k"])
    ['--mu-s', '--mu-k']
    >>> suggested("--farce", ["--force", "--frequency"])
    ['--force']
    """
    typed = given.lower().replace("_", "-")
    return [flag for flag in flags if flag.startswith(typed)] or get_close_matches(
        typed, flags, 1
    )


def no_such_option(error: click.NoSuchOption) -> str:
    """Return what to say of a flag that a command does not have."""
    if error.option_name in RENAMED:
        return f"{error.option_name}: expected {RENAMED[error.option_name]} in its place"
    command = error.ctx.command if error.ctx else click.Command(None)
    flags = [name for q in command.params for name in q.opts if name.startswith("--")]
    meant = suggested(error.option_name, [*flags, "--help"])
    scene = getattr(command, "scene", None)
    of_what = f"{scene.name} has no {error.option_name}." if scene else error.message
    if meant:
        *others, last = meant
        return f"{of_what} Did you mean {', '.join(others)}{' or ' * bool(others)}{last}?"
    if scene is None:
        return of_what
    names = (f"--{q.name.replace('_', '-')}" for q in scene.parameters)
    return f"{of_what} It has {', '.join(names)}."
