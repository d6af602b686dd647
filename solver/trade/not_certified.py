"""No orbit is as accurate, or as quick, as asked for: what such findings have in common."""

#: Part of a tolerance that an estimate may use up; it is itself off by a few per cent.
MARGIN = 0.9


class NotCertified(Exception):  # noqa: N818  (a finding, not a fault)
    """No orbit in float64 is as accurate as asked for, as far as the estimate can say."""


class TooSlow(Exception):  # noqa: N818  (a finding, not a fault)
    """No orbit is computed within the budget.

    Parameters
    ----------
    budget, fastest : float
        Seconds.
    hint : str
        What to do instead, if something.
    """

    def __init__(self, budget: float, fastest: float, hint: str = "") -> None:
        super().__init__(budget, fastest, hint)
        self.budget = budget
        self.fastest = fastest
        self.hint = hint

    def __str__(self) -> str:
        found = f"a budget of {self.budget:.2g} s: the fastest orbit takes {self.fastest:.2g} s"
        return f"{found} here{self.hint and '; '}{self.hint}"
