"""Only what is used: assignments of a function without those that nothing after them reads."""

import re
from collections.abc import Sequence


def _targets(line: str) -> list[str]:
    return re.findall(r"\w+", line.partition(" = ")[0])


def with_used(assignments: Sequence[str], body: Sequence[str]) -> list[str]:
    """Return `body` behind those assignments that it needs, directly or by another."""
    kept = list(body)
    words = set(re.findall(r"\w+", "\n".join(kept)))
    for line in reversed(assignments):
        if words.intersection(_targets(line)):
            kept.insert(0, line)
            words.update(re.findall(r"\w+", line.partition(" = ")[2]))
    return kept
