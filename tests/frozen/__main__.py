"""Write the frozen numbers and equations anew, and say what has changed.

Usage: ``python -m frozen`` in ``tests/``.  Read the difference before you commit it.
"""

import json

from . import equations, grid, machine
from .compare import FOLDER, differences, largest_change


def main() -> None:
    """Write the files that change, with a line for each."""
    for name in grid.GRIDS:
        path, text = FOLDER / f"{name}.json", grid.text(name)
        old = path.read_text("utf-8") if path.exists() else None
        if old != text:
            path.write_text(text, "utf-8")
            print(f"{path.name}: {_changed(old, text)}")
    folder = FOLDER / "equations"
    folder.mkdir(exist_ok=True)
    for name, text in equations.shown():
        path = folder / name
        if not path.exists() or path.read_text("utf-8") != text:
            path.write_text(text, "utf-8")
            print(f"{path.name}: written")
    (FOLDER / "machine.json").write_text(machine.text(), "utf-8")


def _changed(old: str | None, new: str) -> str:
    if old is None:
        return "new"
    rows, others = json.loads(old), json.loads(new)
    count = len(differences(rows, others, exactly=True))
    return f"{count} values differ, times by at most {largest_change(rows, others):.1e}"


main()
