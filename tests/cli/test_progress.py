"""Progress: nothing of what is quick, then a line a tenth of the way, and a line a minute."""

import time
from collections.abc import Iterator
from contextlib import contextmanager

import pytest

from nonsmooth.cli import progress as shown
from nonsmooth.cli.progress import busy, progress


def lines(monkeypatch, capsys, total: int, seconds: float) -> list[str]:
    """Return what is written where stderr is not a terminal and each step takes `seconds`."""
    clock = iter(range(10**6))
    monkeypatch.setattr("time.monotonic", lambda: next(clock) * seconds)
    with progress(total, "sweep") as advance:
        for step in range(total):
            advance(f"point {step}")
    return capsys.readouterr().err.splitlines()


@pytest.mark.parametrize(("total", "expected"), [(1, 0), (5, 5), (10, 10), (1000, 10)])
def test_a_line_at_every_tenth(monkeypatch, capsys, total: int, expected: int) -> None:
    """The first comes ten seconds after the start: here the clock begins there."""
    monkeypatch.setattr(shown, "QUIET", 0.0)
    assert len(lines(monkeypatch, capsys, total, 1e-6)) == expected


def test_a_line_a_minute_where_a_tenth_takes_longer(monkeypatch, capsys) -> None:
    written = lines(monkeypatch, capsys, 1000, 1.0)
    assert 1000 / 60 <= len(written) <= 1000 / 60 + 11
    assert "done (point" in written[0]
    assert ", about 0:15:" in written[0]  # a second each
    assert "left" not in written[-1]


@pytest.mark.parametrize(("seconds", "expected"), [(9.9, 0), (20.0, 6)])
def test_ten_seconds_pass_in_silence(
    monkeypatch, capsys, seconds: float, expected: int
) -> None:
    assert len(lines(monkeypatch, capsys, 10, seconds / 10)) == expected


def test_what_goes_on_for_long_is_said_once_and_again(monkeypatch, capsys) -> None:
    with busy("solving"):
        pass
    assert capsys.readouterr().err == ""
    wait = monkeypatch.setattr
    wait(shown, "QUIET", 0.01)
    wait(shown, "MINUTE", 0.01)
    written: list[str] = []
    with busy("solving") as say:
        say("N = 8")
        end = time.monotonic() + 60
        while len(written) < 2 and time.monotonic() < end:
            written += capsys.readouterr().err.splitlines()
    assert len(written) > 1
    assert written[0] == written[1] == "solving: N = 8 (0:00:00 so far)"


@pytest.mark.parametrize("soon", [0.0, 3600.0])
def test_a_terminal_has_a_bar_of_what_is_not_over_soon(monkeypatch, soon: float) -> None:
    calls: list[str] = []

    @contextmanager
    def bar() -> Iterator[None]:
        calls.append("shown")
        yield
        calls.append("gone")

    monkeypatch.setattr(shown, "SOON", soon)
    with shown._shown_later(bar()):
        end = time.monotonic() + 60
        while soon == 0.0 and not calls and time.monotonic() < end:
            pass
    assert calls == (["shown", "gone"] if soon == 0.0 else [])
