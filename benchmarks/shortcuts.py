"""How many times quicker each shortcut is than the whole system that it is solved in place of.

Both are compiled, and run once before they are timed; of either the least of several rounds is
taken, side by side.  The program ends with 1 if a shortcut is not as quick as its table says.

    python -m benchmarks.shortcuts [--json FILE]
"""

import argparse
import json
import sys
import time
from collections.abc import Callable
from dataclasses import asdict, dataclass
from pathlib import Path

from nonsmooth.solver.case import registry
from nonsmooth.solver.shortcut import Shortcut, table

#: Rounds, cases of a round (as many normal forces about the default), and seconds of a round of
#: the whole system that are enough.
ROUNDS, CASES, ENOUGH = 5, 64, 0.2


@dataclass(frozen=True)
class Measured:
    """What one shortcut takes, and what the whole system does, in seconds for one orbit."""

    name: str
    order: int
    shortcut: float
    full: float
    factor: float
    stated: float

    @property
    def kept(self) -> bool:
        """Whether it is as quick as the table says."""
        return self.factor >= self.stated


def measure(shortcut: Shortcut) -> Measured:
    """Time a shortcut and the whole system over the same cases."""
    assert shortcut.full.times is not None
    assert shortcut.factor is not None
    scene, order = registry.load(shortcut.scene), shortcut.order
    functions = shortcut.functions[0] if shortcut.functions else None
    cases = [scene(normal_force=400 + i) for i in range(CASES)]
    by_full = shortcut.full.times

    def whole(some: int) -> None:
        for case in cases[:some]:
            if by_full(case, order, functions) is None:
                raise SystemExit(f"{shortcut.name}: the whole system does not converge")

    whole(1)
    shortcut.solve(cases, order, functions)
    some = max(1, min(CASES, int(ENOUGH / seconds(lambda: whole(1)))))
    quick = whole_one = float("inf")
    for _ in range(ROUNDS):
        quick = min(quick, seconds(lambda: shortcut.solve(cases, order, functions)) / CASES)
        whole_one = min(whole_one, seconds(lambda: whole(some)) / some)
    return Measured(shortcut.name, order, quick, whole_one, whole_one / quick, shortcut.factor)


def seconds(work: Callable[[], object]) -> float:
    """Return how long `work` takes."""
    begin = time.perf_counter()
    work()
    return time.perf_counter() - begin


def main() -> int:
    """Measure all shortcuts that are for speed, print a table of them; the exit status."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--json", type=Path, help="write the numbers to this file as well")
    target = parser.parse_args().json
    rows = []
    print(f"{'shortcut':32}{'N':>5}{'seconds':>10}{'whole':>10}{'factor':>8}{'stated':>8}")
    for shortcut in table():
        if shortcut.factor is None:
            continue
        row = measure(shortcut)
        rows.append(row)
        late = "" if row.kept else "  SLOWER THAN STATED"
        print(
            f"{row.name:32}{row.order:5d}{row.shortcut:10.1e}{row.full:10.1e}"
            f"{row.factor:8.1f}{row.stated:8.1f}{late}"
        )
    if target is not None:
        target.write_text(json.dumps([asdict(row) for row in rows], indent=1) + "\n", "utf-8")
    return 0 if all(row.kept for row in rows) else 1


if __name__ == "__main__":
    sys.exit(main())
