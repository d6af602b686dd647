"""Make every mistake of the catalogue in a copy of the project and say which are caught.

Usage: ``python -m mutants [--area NAME] [--only WORDS] [--workers 2]`` in ``tests/``.
The exit status is 1 if a mistake survives.
"""

import argparse
import queue
import sys
from concurrent.futures import ThreadPoolExecutor

from .catalogue import areas
from .mutant import Mutant
from .workplace import CatalogueError, Workplace


def _chosen(area: str | None, words: str) -> list[tuple[str, Mutant]]:
    known = areas()
    if area is not None and area not in known:
        sys.exit(f"--area: got {area!r}, expected one of {', '.join(known)}")
    names = known if area is None else [area]
    return [(name, m) for name in names for m in known[name] if words in m.what]


def main() -> None:
    """Run the mutants and print a line for each, and a count."""
    parser = argparse.ArgumentParser(prog="python -m mutants", description=__doc__)
    parser.add_argument("--area", help="the mutants of one module of the catalogue")
    parser.add_argument("--only", default="", help="those whose words contain this")
    parser.add_argument("--workers", type=int, default=2, help="copies that run side by side")
    options = parser.parse_args()
    mutants = _chosen(options.area, options.only)
    places: queue.Queue[Workplace] = queue.Queue()
    for number in range(options.workers):
        places.put(Workplace(number))
    tests = tuple(sorted({test for _, m in mutants for test in m.tests}))
    place = places.get()
    status, output = place.pytest(tests, None)
    places.put(place)
    if status:
        sys.exit(f"without a mistake the tests already end with {status}:\n{output[-3000:]}")

    def one(item: tuple[str, Mutant]) -> bool:
        area, mutant = item
        place = places.get()
        try:
            by = place.caught_by(mutant)
        except CatalogueError as error:
            print(f"BROKEN   {area}: {mutant.what}: {error}", flush=True)
            return False
        finally:
            places.put(place)
        verdict = f"caught   {area}: {mutant.what}  {by}"
        print(verdict if by else f"SURVIVED {area}: {mutant.what}", flush=True)
        return bool(by)

    with ThreadPoolExecutor(options.workers) as pool:
        caught = list(pool.map(one, mutants))
    print(f"{len(mutants)} mutants, {caught.count(True)} caught")
    sys.exit(not all(caught))


main()
