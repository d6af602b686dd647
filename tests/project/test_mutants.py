"""The catalogue of deliberate mistakes fits the project as it stands."""

import pytest
from mutants.catalogue import areas
from mutants.mutant import Mutant
from shown import ROOT

MUTANTS = [(area, mutant) for area, mutants in areas().items() for mutant in mutants]


@pytest.mark.parametrize(("area", "mutant"), MUTANTS, ids=lambda q: getattr(q, "what", q))
def test_a_mistake_can_be_made_and_its_tests_are_there(area: str, mutant: Mutant) -> None:
    assert (ROOT / mutant.file).read_text("utf-8").count(mutant.old) == 1, area
    assert mutant.new != mutant.old
    assert mutant.tests
    for test in mutant.tests:
        file, _, name = test.partition("::")
        assert f"def {name.partition('[')[0]}" in (ROOT / file).read_text("utf-8"), test


def test_there_are_enough_of_them() -> None:
    assert len(MUTANTS) >= 70
    assert len({mutant.what for _, mutant in MUTANTS}) == len(MUTANTS)
