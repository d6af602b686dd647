"""Names in a scene, and names that are reserved for its equations and for commands."""

import keyword
import re
from collections.abc import Iterable

from ..error import SceneError

#: Names of flags of the command line.
TAKEN = frozenset(
    (
        *("all", "attractors", "budget", "case", "cycles", "digits", "figure", "format"),
        *("forcing_phase", "fragment", "from_orbit", "functions", "grid", "help", "json"),
        *("log", "method", "methods", "motion", "order", "orders", "output", "phases"),
        *("quick", "state", "time", "tol", "transient", "vary", "verbose", "version"),
    )
)

#: Names of columns of tables, in which parameters stand beside results.
_COLUMNS = re.compile(
    r"acceleration|attractor|displacement|durations|followed|iterations|message|multipliers|"
    r"parameter|period|phase|scene|seconds|stable|status|strobe|t|value|velocity|"
    r"(duration|strobe)_\d+|(error|estimate|largest|least)_\w+"
)

#: Names of commands, which scenes must not have.
COMMANDS = frozenset(
    (
        *("digits", "equations", "generate", "modes", "report", "roots", "scenes", "simulate"),
        *("branch", "map", "solve", "stability", "sweep", "tradeoff"),
    )
)

#: Names that scenes and their motions may have.
_CALLED = re.compile(r"[a-z][a-z0-9-]*")

#: Short names that are used in equations.
SHORT = ("N", "R", "J", "T", "z", "p", "u", "l", "n", "j", "t", "x", "v", "a", "b", "a0", "phi")

#: All names that are used in equations: unknowns, indices, times of switches, functions.
_RESERVED = re.compile(
    rf"({'|'.join(SHORT)}|t\d+|omega_0|forcing|angle|cycles|pi|cos|sin|sqrt|exp|abs)"
)

#: Names of unknowns and integrals of a phase, of which {0} is the name.
_OF_A_PHASE = r"(s|x|v|d|J|C|S|c\d+|tau\d*|mu|nu|beta|G\d+)_{0}(_\w+)?"


def check_name(field: str, name: str) -> None:
    """Check that a name is an identifier of Python; a `SceneError` if not."""
    if keyword.iskeyword(name):
        raise SceneError(f"{field}: got {name!r}, a word of Python")
    if not name.isidentifier():
        expected = "letters, digits and underscores, beginning with a letter"
        raise SceneError(f"{field}: got {name!r}, expected {expected}")


def check_free(field: str, name: str) -> None:
    """Check that a parameter has no name that options or results have; a `SceneError` if so."""
    if name in TAKEN:
        raise SceneError(f"{field}: the name is taken by an option of the command line")
    if _COLUMNS.fullmatch(name):
        raise SceneError(f"{field}: the name is taken by a column of tables of results")


def check_called(field: str, name: str) -> None:
    """Check that a scene or a motion may have a name; a `SceneError` if not."""
    if not _CALLED.fullmatch(name):
        expected = "lower-case letters, digits and dashes, beginning with a letter"
        raise SceneError(f"{field}: got {name!r:.60}, expected {expected}")
    check_name(field, name.replace("-", "_"))


def check_meaning(field: str, name: str, phases: Iterable[str]) -> None:
    """Check that a name has no other meaning in the equations; a `SceneError` if it has."""
    patterns = (_OF_A_PHASE.format(re.escape(phase)) for phase in phases)
    if _RESERVED.fullmatch(name) or any(re.fullmatch(q, name) for q in patterns):
        raise SceneError(
            f"{field}: {name} has a meaning of its own in the equations, as have "
            f"{', '.join(SHORT)}, the names of functions and those that begin with s_, x_, v_ "
            "and the like before the name of a phase; expected another name"
        )
