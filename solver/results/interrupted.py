"""Ctrl-C in what takes long: what was found before is not lost."""

from typing import Any


class Interrupted(KeyboardInterrupt):
    """Ctrl-C while many orbits were computed.

    Parameters
    ----------
    done : Family, Chart or list of Branch
        What was found before.
    words : str
        How much that is: ``"3 of 40 values are done"``.
    """

    def __init__(self, done: Any, words: str) -> None:
        super().__init__(words)
        self.done = done
