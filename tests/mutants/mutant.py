"""A deliberate mistake as data: what it is, where it goes, and the tests that must see it."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Mutant:
    """One mistake in one file.

    Parameters
    ----------
    what : str
        The mistake, in a few words.
    file : str
        The file it goes into, from the root of the project.
    old, new : str
        What stands there once, and what the mistake puts in its place.
    tests : tuple of str
        The test modules or tests concerned, as pytest takes them.
    regenerate : bool
        Whether ``generated/`` is to be written anew with the mistake.
    """

    what: str
    file: str
    old: str
    new: str
    tests: tuple[str, ...]
    regenerate: bool = False
