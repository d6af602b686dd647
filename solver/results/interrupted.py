"""Ctrl-C during long computations, with the results found before."""

from typing import Any


class Interrupted(KeyboardInterrupt):
    """Ctrl-C while many orbits were computed.

    Parameters
    ----------
    done : Family, Chart or list of Branch
        The results found before.
    words : str
        How much was done: ``"3 of 40 values are done"``.
    """

    def __init__(self, done: Any, words: str) -> None:
        super().__init__(words)
        self.done = done
