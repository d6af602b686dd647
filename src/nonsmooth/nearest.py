"""Names: what an unknown one may have been meant for, and those that occur several times.

And what is counted, in words.
"""

import re
from collections.abc import Iterable, Sequence
from difflib import get_close_matches
from itertools import count, groupby

#: Letters of joined names that are printed in full.
LONG = 32


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


def counted(number: int, what: str) -> str:
    """Return a number and what is counted, in the plural unless there is one.

    Examples
    --------
    >>> counted(1, "orbit"), counted(0, "orbit")
    ('1 orbit', '0 orbits')
    """
    return f"{number} {what}" if number == 1 else f"{number} {what}s"


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


def in_short(names: str) -> str:
    """Return names that commas join; of many, how often each follows itself.

    Examples
    --------
    >>> in_short("slide,stop"), in_short("flight," * 7 + "rest,flight")
    ('slide,stop', '7 x flight, rest, flight')
    """
    if len(names) <= LONG:
        return names
    runs = ((name, len([*run])) for name, run in groupby(names.split(",")))
    return ", ".join(f"{times} x {name}" if times > 1 else name for name, times in runs)


def at_length(names: str) -> list[str]:
    """Return the names of a text in which they are joined by commas, in full or `in_short`.

    Examples
    --------
    >>> at_length("slide,stop"), at_length("3 x flight, rest")
    (['slide', 'stop'], ['flight', 'flight', 'flight', 'rest'])
    """
    found: list[str] = []
    for name in map(str.strip, names.split(",")):
        times = re.fullmatch(r"(\d{1,6}) x (.+)", name)
        found += [times[2]] * int(times[1]) if times else [name]
    return found
