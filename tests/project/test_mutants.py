"""The catalogue of deliberate mistakes fits the project as it stands."""

from mutants.catalogue import areas
from shown import ROOT

MUTANTS = [(area, mutant) for area, mutants in areas().items() for mutant in mutants]


def test_each_mistake_can_be_made_and_its_tests_are_there() -> None:
    for area, mutant in MUTANTS:
        found = (ROOT / mutant.file).read_text("utf-8").count(mutant.old)
        assert found == 1, f"{area}: {mutant.what}: {found} of {mutant.old!r}"
        assert mutant.new != mutant.old, mutant.what
        assert mutant.tests, mutant.what
        for test in mutant.tests:
            file, _, name = test.partition("::")
            assert f"def {name.partition('[')[0]}" in (ROOT / file).read_text("utf-8"), test


def test_there_are_enough_of_them() -> None:
    assert len(MUTANTS) >= 70
    assert len({mutant.what for _, mutant in MUTANTS}) == len(MUTANTS)
