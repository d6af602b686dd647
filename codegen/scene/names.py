"""The names in a scene, and those that have a meaning of their own in its equations."""

import keyword
import re
from collections.abc import Iterable

from .error import SceneError

#: Names that flags of the command line have.
TAKEN = frozenset(
    (
        *("all", "attractors", "budget", "case", "cycles", "digits", "figure", "format"),
        *("forcing_phase", "fragment", "from_orbit", "functions", "grid", "help", "json"),
        *("log", "method", "methods", "motion", "order", "orders", "output", "phases"),
        *("quick", "state", "time", "tol", "transient", "vary", "verbose", "version"),
    )
)

#: Names that commands have; a scene of such a name would be taken for one.
COMMANDS = frozenset(
    (
        *("digits", "equations", "generate", "modes", "report", "roots", "scenes", "simulate"),
        *("branch", "map", "solve", "stability", "sweep", "tradeoff"),
    )
)

#: How scenes and their motions are called, on the command line too.
_CALLED = re.compile(r"[a-z][a-z0-9-]*")

#: The short ones of the names that equations use themselves.
SHORT = ("N", "R", "J", "T", "z", "p", "u", "l", "n", "j", "t", "x", "v", "a", "b", "a0", "phi")

#: All of them: unknowns, indices, times of switches, functions.
_RESERVED = re.compile(
    rf"({'|'.join(SHORT)}|t\d+|omega_0|forcing|angle|cycles|pi|cos|sin|sqrt|exp|abs)"
)

#: What stands before the name of a phase in the names of its unknowns and integrals.
_OF_A_PHASE = r"(s|x|v|d|J|C|S|c\d+|tau\d*|mu|nu|beta|G\d+)_{0}(_\w+)?"


def check_name(field: str, name: str) -> None:
    """Check that a name can be one in Python; a `SceneError` if it cannot."""
    if keyword.iskeyword(name):
        raise SceneError(f"{field}: got {name!r}, a word of Python")
    if not name.isidentifier():
        raise SceneError(f"{field}: got {name!r}, expected letters, digits and underscores")


def check_called(field: str, name: str) -> None:
    """Check that a scene or a motion can be called so on the command line.

    A `SceneError` is raised if it cannot.
    """
    if not _CALLED.fullmatch(name):
        expected = "lower-case letters, digits and dashes, beginning with a letter"
        raise SceneError(f"{field}: got {name!r:.60}, expected {expected}")
    check_name(field, name.replace("-", "_"))


def check_meaning(field: str, name: str, phases: Iterable[str]) -> None:
    """Check that a name has no other meaning in the equations.

    A `SceneError` is raised if it has, with the names that are taken.
    """
    if reserved(name, phases):
        raise SceneError(
            f"{field}: {name} has a meaning of its own in the equations, as have "
            f"{', '.join(SHORT)}, the names of functions and those that begin with s_, x_, v_ "
            "and the like before the name of a phase; expected another name"
        )


def reserved(name: str, phases: Iterable[str]) -> bool:
    """Whether equations use a name themselves, in a scene with phases of these names."""
    patterns = (_OF_A_PHASE.format(re.escape(phase)) for phase in phases)
    return bool(_RESERVED.fullmatch(name)) or any(re.fullmatch(q, name) for q in patterns)
