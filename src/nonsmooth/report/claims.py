"""The claims of the paper, from `claims.toml`: each with its parts and the verdict."""

import tomllib
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from importlib import import_module
from pathlib import Path
from typing import Any

import nonsmooth as ns

from .case import Case
from .checks import Finding

#: Verdicts if all parts that count hold, if some do, if none does.
VERDICTS = ("holds", "holds in part", "does not hold")


@dataclass(frozen=True, eq=False)
class Part:
    """One statement of a claim, true or false for an oscillator; see `claims.toml`."""

    words: str
    check: Callable[[Case], Finding]
    counts: bool = True
    ours: str = ""

    def of(self, case: Case) -> Finding:
        """Return the result of the check; it fails if an orbit that it needs is missing."""
        try:
            return self.check(case)
        except ns.NoOrbit as missing:
            return Finding(False, missing.reason)


@dataclass(frozen=True, eq=False)
class Claim:
    """A claim of the paper; see `claims.toml`."""

    name: str
    title: str
    words: str
    where: str
    quoted: str
    source: str
    parts: tuple[Part, ...]
    note: str = ""

    def verdict(self, holds: Sequence[bool]) -> str:
        """Return the verdict, from whether each part holds."""
        counted = [yes for part, yes in zip(self.parts, holds, strict=True) if part.counts]
        return VERDICTS[0] if all(counted) else VERDICTS[1] if any(counted) else VERDICTS[2]


def table(name: str) -> Any:
    """Return a TOML file of this folder, with line breaks within texts as spaces."""
    return _joined(tomllib.loads(Path(__file__).with_name(name).read_text("utf-8")))


def _joined(entry: Any) -> Any:
    if isinstance(entry, dict):
        return {key: _joined(value) for key, value in entry.items()}
    if isinstance(entry, list):
        return [_joined(value) for value in entry]
    return " ".join(entry.split()) if isinstance(entry, str) else entry


def _claim(part: list[dict[str, Any]], **text: str) -> Claim:
    return Claim(**text, parts=tuple(_part(**row) for row in part))


def _part(check: str, given: dict[str, Any] | None = None, **told: Any) -> Part:
    module, name = check.split(".")
    function = getattr(import_module(f".checks.{module}", __package__), name)
    return Part(check=partial(function, **(given or {})), **told)


#: The claims by their headings, in the order of the paper's methods.
GROUPS: dict[str, list[Claim]] = {
    group["title"]: [_claim(**row) for row in group["claim"]]
    for group in table("claims.toml")["group"]
}

CLAIMS = [claim for group in GROUPS.values() for claim in group]
PARTS = [part for claim in CLAIMS for part in claim.parts]
