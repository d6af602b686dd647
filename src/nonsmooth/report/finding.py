"""A claim, its parts that are true or false of an oscillator, and the verdict on it."""

from collections.abc import Callable
from dataclasses import dataclass

from nonsmooth.solver.no_orbit import NoOrbit

from .case import Case


@dataclass(frozen=True)
class Finding:
    """Whether something holds, and the numbers that say so.

    Parameters
    ----------
    holds : bool
    numbers : str
        What was measured, in words.
    """

    holds: bool
    numbers: str


@dataclass(frozen=True)
class Part:
    """One statement that is true or false of an oscillator.

    Parameters
    ----------
    words : str
        The statement, precise enough to be computed.
    check : callable
        From a `Case` to a `Finding`; it may raise `NoOrbit`.
    counts : bool
        Whether the verdict depends on it; False for another way to read the claim.
    ours : str
        The threshold, where the paper gives none: the number is ours.
    """

    words: str
    check: Callable[[Case], Finding]
    counts: bool = True
    ours: str = ""

    def of(self, case: Case) -> Finding:
        """Return the finding; an orbit that is missing counts against the statement."""
        try:
            return self.check(case)
        except NoOrbit as missing:
            return Finding(False, missing.reason)


@dataclass(frozen=True)
class Claim:
    """A claim of the paper.

    Parameters
    ----------
    name : str
        For links, and for the tests.
    title : str
        A few words.
    words : str
        What the paper says, in our words.
    where : str
        Where it says so.
    parts : tuple of Part
        What has to be true.
    note : str
        Why it is so, where that is not plain.
    """

    name: str
    title: str
    words: str
    where: str
    parts: tuple[Part, ...]
    note: str = ""


#: From all parts that count to none.
VERDICTS = ("holds", "holds in part", "does not hold")


def verdict(claim: Claim, findings: tuple[Finding, ...]) -> str:
    """Return the verdict on a claim from the findings on its parts."""
    counted = [f.holds for part, f in zip(claim.parts, findings, strict=True) if part.counts]
    return VERDICTS[0] if all(counted) else VERDICTS[1] if any(counted) else VERDICTS[2]
