"""Why there is no orbit is said once: a sentence, and below it what is known and was tried."""

import random

import pytest

from nonsmooth.cli.problems import MOST_TOLD, reasons
from nonsmooth.solver.no_orbit import NoOrbit

TOLD = ("solve", "stick-slip-damped", "--damping", 500)


def test_a_reason_that_holds_for_all_methods_is_said_once(run) -> None:
    status, _, err = run("solve", "impact", "--gap", 5)
    line, *below = err.splitlines()
    assert status == 1
    assert line.startswith("nonsmooth: impact: no such orbit exists")
    assert below == [
        "  the mass can move in flight for ever, without switches, |x| up to 0.444994 m",
        "  a simulation comes to a motion without switches",
    ]


def test_methods_without_an_orbit_for_the_same_reasons_are_named(run) -> None:
    status, _, err = run(*TOLD)
    first, *others = err.splitlines()
    assert status == 1
    assert first == "nonsmooth: stick-slip-damped, hb, N = 10: no admissible orbit was found"
    below = [line for line in others if line.startswith("  ")]
    assert below[0].startswith("  from equal durations: ck-tau, N = 5: ")
    assert others[len(below) :] == [
        f"nonsmooth: stick-slip-damped, {method}, N = 10: no orbit, for the same reasons"
        for method in ("hb-ck", "ck", "ck-tau")
    ]


@pytest.mark.parametrize("flag", ["-v", "--verbose"])
def test_all_that_was_tried_is_told_if_asked_for(run, flag: str) -> None:
    _, _, short = run(*TOLD, "--method", "ck")
    _, _, whole = run(*TOLD, "--method", "ck", flag)
    (left_out,) = (q for q in short.splitlines() if q.startswith("  ... and "))
    told = [q for q in short.splitlines() if q != left_out]
    assert "which --verbose shows" in left_out
    assert len(whole.splitlines()) == len(told) + int(left_out.split()[2])
    assert {*told} <= {*whole.splitlines()}


@pytest.mark.parametrize("command", ["tradeoff", "report"])
def test_every_command_tells_it_so(run, command: str, tmp_path) -> None:
    more = ("-o", tmp_path / "page") if command == "report" else ()
    status, out, err = run(command, "impact", "--gap", 5, *more)
    assert (status, out) == (1, "")
    first, *below = err.splitlines()
    assert first.startswith("nonsmooth: impact: no such orbit exists")
    assert below
    assert all(line.startswith("  ") for line in below)


def test_of_any_number_of_starts_a_handful_is_told() -> None:
    draw = random.Random(3)
    for _ in range(50):
        tried = tuple(f"start {i}" for i in range(draw.randrange(30)))
        found, known, *told = reasons(NoOrbit("none was found; it rests", False, tried))
        assert (found, known) == ("none was found", "it rests")
        assert len(told) <= MOST_TOLD + 1
        assert (told[0], told[-1]) == (tried[0], tried[-1]) if tried else not told
        named = [q for q in told if q in tried]
        (more,) = {*told} - {*named} or {"... and 0 more"}
        assert len(named) + int(more.split()[2]) == len(tried)


def test_a_sentence_is_one_line_whatever_the_scene() -> None:
    assert reasons(NoOrbit("none was found", False, ())) == ("none was found",)
    assert reasons(NoOrbit("both are known; none is one", True, ("by hand",))) == (
        "both are known; none is one",
        "by hand",
    )
