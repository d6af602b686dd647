"""What is raised where there is no orbit to return."""


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
        return "; ".join((self.reason, *self.tried))

    @property
    def reasons(self) -> tuple[str, ...]:
        """What each start came to; the reason, where none was tried."""
        return self.tried or (self.reason,)

    @property
    def status(self) -> str:
        """``"no-orbit"`` if that is shown, else ``"not-converged"``."""
        return "no-orbit" if self.proven else "not-converged"
