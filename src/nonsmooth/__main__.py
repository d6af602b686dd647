"""``python -m nonsmooth`` and the ``nonsmooth`` command."""

from typing import NoReturn

from .interrupt import end_on_interrupt


def main() -> NoReturn:
    """Run the command line as a program of its own."""
    end_on_interrupt(_command_line)


def _command_line() -> NoReturn:
    from .cli import main as command_line  # noqa: PLC0415  (within the reach of Ctrl-C)

    command_line()


if __name__ == "__main__":
    main()
