"""Which of many similar cases every run of the tests tries; `make test-long` tries all."""

from collections.abc import Collection, Iterable
from typing import Any

import pytest


def tried(cases: Iterable[Any], *, every_run: Collection[Any]) -> list[Any]:
    """Return `cases` as pytest takes them, long but for those of `every_run`.

    Raises
    ------
    ValueError
        If `every_run` has a case that is not among `cases`: nothing would try it.
    """
    cases = list(cases)
    unknown = [case for case in every_run if case not in cases]
    if unknown:
        raise ValueError(f"every_run: got {unknown}, expected cases of {cases}")
    return [
        pytest.param(
            *(case if isinstance(case, tuple) else (case,)),
            marks=[] if case in every_run else pytest.mark.long,
        )
        for case in cases
    ]
