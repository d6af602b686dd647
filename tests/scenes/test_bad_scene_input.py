"""Every parameter of every scene: zero, negative, not finite, text; and what does not exist."""

import math

import numpy as np
import pytest
from refusals import refused

from nonsmooth.solver.kernels import registry, start
from nonsmooth.solver.scenes.parameter_error import ParameterError

PARAMETERS = [(name, q) for name in registry.names() for q in registry.load(name).parameters]


@pytest.mark.parametrize(("name", "q"), PARAMETERS, ids=lambda q: getattr(q, "name", q))
def test_a_parameter_out_of_its_bounds_is_one_line(name, q):
    scene = registry.load(name)
    wrong = [math.nan, math.inf, -math.inf, "1", None, True, 1j]
    wrong += [] if q.bound == "" else [-1.0, -1e-300]
    wrong += [0.0] if q.bound == "positive" else []
    wrong += [] if q.most is None else [q.most * 1.001]
    for value in wrong:
        with pytest.raises(ParameterError) as caught:
            scene(**{q.name: value})
        (line,) = caught.value.errors
        assert line == f"{q.name}: got {value!r}, expected {q.expected}"
    if q.bound == "nonnegative":
        assert scene(**{q.name: 0}).values[q.name] == 0


@pytest.mark.parametrize(
    ("name", "cycles", "words"),
    [
        ("impact", 0, "cycles: got 0, expected a whole number from 1 to 100"),
        ("impact", 1.5, "cycles: got 1.5, expected a whole number"),
        ("impact", True, "cycles: got True, expected a whole number"),
        ("impact", 101, "cycles: got 101, expected a whole number"),
        ("stick-slip", 2, "cycles: got 2, expected 1: nothing forces stick-slip"),
        (
            "backlash",
            2,
            "cycles: got 2, expected an odd number: x(t + T/2) = -x(t) in backlash",
        ),
    ],
)
def test_cycles_that_cannot_be(name, cycles, words):
    with pytest.raises(ParameterError) as caught:
        registry.load(name)(cycles=cycles)
    assert str(caught.value).startswith(words)


def test_whole_numbers_of_numpy_are_cycles() -> None:
    case = registry.load("impact")(cycles=np.int64(2))
    assert case == registry.load("impact")(cycles=2)
    assert type(case.cycles) is int


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("dry-friction", "--motion", "two-stop"), "--motion: got 'two-stop', expected one of"),
        (("dry-friction", "--motion", "two-stop"), "did you mean two-stops?"),
        (("impact", "--motion", "sliding"), "--motion: impact has one motion"),
        (("stick-slip-damped", "--cycles", 2), "--cycles: nothing forces stick-slip-damped"),
        (("backlash", "--cycles", 2), "--cycles: got 2, expected an odd number"),
    ],
)
def test_commands_say_so_in_one_line(run, arguments, words):
    assert words in refused(run, "solve", *arguments)


def test_where_no_motion_of_the_declared_orders_exists_the_reasons_are_said(run, monkeypatch):
    """A load that never overcomes the friction."""
    monkeypatch.setattr(start, "ANGLES", 1)
    monkeypatch.setattr(start, "UNEQUAL", ())
    status, _, err = run("solve", "dry-friction", "--force", 0.2, "--method", "ck-tau")
    assert status == 1
    assert "no admissible orbit of any motion (sliding, two-stops) was found" in err
    assert "sliding: " in err
