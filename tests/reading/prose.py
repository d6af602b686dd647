"""Words with mathematics in them, compared without the marks of their format."""

import re
import unicodedata

from .tokens import letter

_SAME = {"≤": "<=", "≠": "!=", "−": "-", r"\le ": "<=", r"\ne ": "!=", r"\ldots": "..."}
_SAME |= {"\N{LATIN SMALL LETTER DOTLESS I}": "i"}

#: What stands in words but is mathematics: signs, indices, single letters but the article.
_MATHEMATICS = re.compile(r"[=<>*_^\[\]{}\\]|(?<![-(\w'])(?!a\s+[a-z])[A-Za-z]\d?\b(?!-)")


def bare(text: str) -> str:
    """Return words in ASCII without spaces, braces and the signs of indices and powers."""
    for mark, plain in _SAME.items():
        text = text.replace(mark, plain)
    letters = (letter(c) if ord(c) > 127 else c for c in unicodedata.normalize("NFKC", text))
    return re.sub(r"[\\${}_^\[\]*`\s]", "", "".join(letters))


def mathematics_in(words: str) -> str:
    """Return what is left among the words that should be set as mathematics."""
    found = _MATHEMATICS.search(words)
    return found[0] if found else ""
