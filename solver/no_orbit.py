"""What is raised where there is no orbit to return, and scenes with several motions."""

from collections.abc import Callable
from typing import TYPE_CHECKING, TypeVar

if TYPE_CHECKING:
    from .scenes.case import Case

#: Starts of which a message says how they ended: the first and the last.
MOST_TOLD = 6

# What is found for the case of one motion.
Found = TypeVar("Found")


class NoOrbit(Exception):  # noqa: N818  (a finding about the oscillator, not a fault)
    """There is no orbit of this method at this order, or none was found.

    Parameters
    ----------
    reason : str
        What was found, in words.
    proven : bool
        Whether it is shown that none exists; else the search was in vain.
    tried : tuple of str
        The starts that were tried, and how each ended.

    Attributes
    ----------
    iterations : int
        Jacobians factorised in the search.
    """

    def __init__(self, reason: str, proven: bool, tried: tuple[str, ...]) -> None:
        super().__init__(reason, proven, tried)
        self.reason = reason
        self.proven = proven
        self.tried = tried
        self.iterations = 0

    def __str__(self) -> str:
        shown, left_out = self.tried, len(self.tried) - MOST_TOLD
        if left_out > 1:  # a line that says so would be as long
            more = f"... and {left_out} more starts, in `tried` ..."
            shown = (*shown[: MOST_TOLD // 2], more, *shown[-MOST_TOLD // 2 :])
        return "; ".join((self.reason, *shown))

    @property
    def in_full(self) -> str:
        """The reason, and all that was tried."""
        return "; ".join((self.reason, *self.tried))

    @property
    def reasons(self) -> tuple[str, ...]:
        """What each start came to; the reason, where none was tried."""
        return self.tried or (self.reason,)

    @property
    def status(self) -> str:
        """``"no-orbit"`` if that is shown, else ``"not-converged"``."""
        return "no-orbit" if self.proven else "not-converged"


def of_any_motion(case: "Case", find: "Callable[[Case], Found]") -> Found:
    """Return what is found for the first motion of a case for which there is something.

    Raises
    ------
    NoOrbit
        If there is nothing for any; with the reasons of each.
    """
    tried: list[str] = []
    iterations, proven = 0, True
    for each in case.each_motion:
        try:
            return find(each)
        except NoOrbit as finding:
            if not case.scene.motions:
                raise
            tried += [f"{each.scene.motion}: {why}" for why in finding.reasons]
            iterations += finding.iterations
            proven = proven and finding.proven
    motions = ", ".join(case.scene.motions)
    error = NoOrbit(
        f"{case.scene.name}: no admissible orbit of any motion ({motions}) was found",
        proven,
        tuple(tried),
    )
    error.iterations = iterations
    raise error
