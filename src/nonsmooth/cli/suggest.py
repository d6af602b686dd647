"""What a flag that is not there may have been meant for."""

import click

from ..nearest import nearest
from .about import CommandAbout

#: Flags of earlier versions, and what is asked in their place.
RENAMED = {"--c1-terms": "--functions K, with --method hb-ck,"}


def no_such_option(error: click.NoSuchOption) -> str:
    """Return what to say of a flag that a command does not have."""
    if error.option_name in RENAMED:
        return f"{error.option_name}: expected {RENAMED[error.option_name]} in its place"
    command = error.ctx.command if error.ctx else click.Command(None)
    flags = [name for q in command.params for name in q.opts if name.startswith("--")]
    meant = nearest(error.option_name.replace("_", "-"), [*flags, "--help"])
    about = command if isinstance(command, CommandAbout) else None
    of_what = f"{about.about.name} has no {error.option_name}." if about else error.message
    if meant:
        *others, last = meant
        return f"{of_what} Did you mean {', '.join(others)}{' or ' * bool(others)}{last}?"
    return f"{of_what} It has {', '.join(about.flags)}." if about else of_what
