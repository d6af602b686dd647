"""Progress where stderr is no terminal: a line a tenth of the way, and a line a minute."""

import pytest

from nonsmooth.cli.progress import progress


def lines(monkeypatch, capsys, total: int, seconds: float) -> list[str]:
    clock = iter(range(10**6))
    monkeypatch.setattr("time.monotonic", lambda: next(clock) * seconds)
    with progress(total, "sweep") as advance:
        for step in range(total):
            advance(f"point {step}")
    return capsys.readouterr().err.splitlines()


@pytest.mark.parametrize(("total", "expected"), [(1, 0), (5, 5), (10, 10), (1000, 10)])
def test_a_line_at_every_tenth(monkeypatch, capsys, total: int, expected: int) -> None:
    assert len(lines(monkeypatch, capsys, total, 1e-6)) == expected


def test_a_line_a_minute_where_a_tenth_takes_longer(monkeypatch, capsys) -> None:
    written = lines(monkeypatch, capsys, 1000, 1.0)
    assert 1000 / 60 <= len(written) <= 1000 / 60 + 11
    assert "done (point" in written[0]
    assert ", about 0:15:" in written[0]  # a second each
    assert "left" not in written[-1]
