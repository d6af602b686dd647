"""``python -m nonsmooth`` and the ``nonsmooth`` command."""

import os
import sys
from typing import NoReturn

from .interrupt import end_on_interrupt


def main() -> NoReturn:
    """Run the command line as a program of its own."""
    for name in ("stdout", "stderr"):
        if getattr(sys, name) is None:  # closed by the shell: >&-
            setattr(sys, name, open(os.devnull, "w", encoding="utf-8"))  # noqa: SIM115
    end_on_interrupt(_command_line)


def _command_line() -> NoReturn:
    from .cli import main as command_line  # noqa: PLC0415  (within the reach of Ctrl-C)

    command_line()


if __name__ == "__main__":
    main()
