"""What the documentation shows: its files, and when two outputs are the same."""

from itertools import zip_longest
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent
README = (ROOT / "README.md").read_text("utf-8")

#: All pages of the documentation, by their place below the root.
PAGES = {
    str(path.relative_to(ROOT)): path.read_text("utf-8")
    for path in (ROOT / "README.md", ROOT / "CONTRIBUTING.md", *(ROOT / "docs").rglob("*.md"))
    if "_build" not in path.parts
}


def same(shown: str, printed: str) -> bool:
    """Whether two words are the same, or the same number to rounding."""
    if shown == printed:
        return True
    try:
        return float(printed) == pytest.approx(float(shown), rel=1e-2, abs=1e-13)
    except ValueError:
        return False


def differences(shown: str, printed: str) -> list[tuple[str, str]]:
    """Return the pairs of words in which two outputs differ."""
    pairs = zip_longest(shown.split(), printed.split(), fillvalue="")
    return [pair for pair in pairs if not same(*pair)]
