"""Results in a notebook: a small table as HTML, and a plot as SVG."""

import io
from collections.abc import Callable, Mapping
from html import escape
from importlib.util import find_spec
from typing import Any

#: Width and height of a plot, in inches.
SIZE = (3.6, 2.7)

#: Number of rows of a long result that are shown at its beginning, and at its end.
MOST = 24


def facts(rows: Mapping[str, str]) -> str:
    """Return names and texts as a small table in HTML, without empty texts."""
    cells = (
        f"<tr><th>{escape(name)}</th><td>{escape(text)}</td></tr>"
        for name, text in rows.items()
        if text
    )
    return f"<table>{''.join(cells)}</table>"


def svg(draw: Callable[[Any], Any]) -> str:
    """Return the plot of a function of axes as SVG; an empty text without matplotlib."""
    if find_spec("matplotlib") is None:
        return ""
    from ...plots.axes import on_axes  # noqa: PLC0415  (an extra)

    target = io.StringIO()
    on_axes(draw, SIZE, target)
    text = target.getvalue()
    return text[text.index("<svg") :]


def of_rows(head: str, text: str, draw: Callable[[Any], Any]) -> str:
    """Return a result of many rows in HTML: a headline, its rows as text, and its plot."""
    lines = text.splitlines()
    if len(lines) > 2 * MOST + 2:
        left_out = f"... {len(lines) - 2 * MOST - 1} more"
        lines = [*lines[: MOST + 1], left_out, *lines[-MOST:]]
    rows = escape("\n".join(lines))
    return f"<p>{escape(head)}</p><pre>{rows}</pre>{svg(draw)}"
