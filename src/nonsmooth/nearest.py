"""Names: what an unknown one may have been meant for, and numbers behind those that repeat."""

from collections.abc import Iterable, Sequence
from difflib import get_close_matches
from itertools import count


def nearest(name: object, known: Iterable[str]) -> list[str]:
    """Return the names that begin with what was typed; else the most alike, if one is.

    Examples
    --------
    >>> nearest("freq", ["force", "frequency", "mu_s", "mu_k"])
    ['frequency']
    >>> nearest("--mu", ["--force", "--mu-s", "--mu-k"])
    ['--mu-s', '--mu-k']
    >>> nearest("farce", ["force", "frequency"]), nearest(3, ["force"])
    (['force'], [])
    """
    if not isinstance(name, str) or not name:
        return []
    names, typed = [*known], name.lower()
    begun = [each for each in names if each.startswith(typed)]
    return begun or get_close_matches(typed, names, 1)


def one_of(name: object, known: Iterable[str]) -> str:
    """Return in words which names there are, and which of them may be meant.

    Examples
    --------
    >>> one_of("impakt", ["backlash", "impact"])
    'one of backlash, impact; did you mean impact?'
    >>> one_of("impakt", [])
    'one of (none)'
    """
    names = [*known]
    meant = nearest(name, names)
    hint = f"; did you mean {' or '.join(meant)}?" if meant else ""
    return f"one of {', '.join(names) or '(none)'}{hint}"


def numbered(names: Sequence[str]) -> list[str]:
    """Return names with a number behind those that occurred before; no two are the same.

    Examples
    --------
    >>> numbered(["slide", "stop", "slide"])
    ['slide', 'stop', 'slide_2']
    >>> numbered(["slide", "slide", "slide_2"])
    ['slide', 'slide_3', 'slide_2']
    """
    found: list[str] = []
    for i, name in enumerate(names):
        others = (f"{name}_{n}" for n in count(names[: i + 1].count(name)))
        free = (other for other in others if other not in names and other not in found)
        found.append(next(free) if name in names[:i] else name)
    return found
