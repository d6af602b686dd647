"""A reader that has left, as that of ``| head -1``: status 0, and no message."""

import pytest
from refusals import refused


@pytest.mark.parametrize("command", ["equations", "solve", "simulate"])
def test_a_scene_of_no_letters_is_not_the_default(run, command: str) -> None:
    assert "got '', expected one of" in refused(run, command, "")
