"""What needs high precision says how to install it."""

from importlib.util import find_spec

from .problems import Problem


def need_flint(flag: str) -> None:
    """Check that high precision is there.

    Raises
    ------
    Problem
        Saying how to install what is missing.
    """
    if find_spec("flint") is None:
        raise Problem(f"{flag} needs python-flint: pip install 'nonsmooth[precise]'")
