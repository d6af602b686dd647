"""One orbit of a case by one method, or the reason why there is none."""

from collections.abc import Sequence
from contextlib import suppress

from .exact import ExactOrbit, exact_orbit, settled_orbit, settled_orbits
from .existence.known import are_one, known, known_orbits, stable_first
from .in_order import cases_in_order
from .kernels import registry
from .no_orbit import NoOrbit, of_any_motion
from .results.orbit import Orbit
from .scenes.case import Case, check_case
from .scenes.methods import FIRST
from .search import COARSE, Search, search_of


def solve_case(
    case: Case,
    method: str = FIRST,
    order: int = 10,
    functions: int | None = None,
) -> Orbit:
    """Return the periodic orbit of a case, converged and admissible.

    The motions of a scene are tried in their order until an orbit is found.  If there is none,
    or it is unstable, the order of phases on which a simulation settles is tried as well.

    Parameters
    ----------
    case : Case
        The oscillator.
    method : str
        One of `registry.methods`, by its generic name or the one with the class.
    order : int
        ``N``.
    functions : int, optional
        Number of functions added to the harmonics at each switch, of methods that have them.
        Default: 1, or 2 where the velocity jumps.

    Raises
    ------
    TypeError
        If `case` is not a `Case`.
    ValueError
        If the scene has no kernel of the method, or a number is out of its range.
    NoOrbit
        If no start leads to a converged and admissible orbit; with the outcome of each.

    Examples
    --------
    >>> from nonsmooth.solver.kernels import registry
    >>> case = registry.load(registry.names()[0])()
    >>> solve_case(case, order=12).admissible
    True
    """
    check_case(case)
    method = registry.generic_method(case.scene, method)
    if functions is None:
        functions = number_of_functions(case, method, None)

    def search(each: Case) -> Search:
        return search_of(each, method, order, functions)

    def settled(*, beside: bool = False) -> Orbit | None:
        exact = settled_orbit(case, beside=beside)
        if exact is None or order < registry.kernel(exact.case.scene, method, functions).lowest:
            return None
        other = search(exact.case)
        return other.from_exact(exact) or other.run()

    declared = (search(exact.case).from_exact(exact) for exact in known_orbits(case))
    try:
        solution = next((orbit for orbit in declared if orbit is not None), None)
        solution = solution or of_any_motion(case, lambda each: search(each).run())
    except NoOrbit:
        other = settled()
        if other is None:
            raise
        return other
    if case.scene.motion is None and solution.stable is False:
        with suppress(NoOrbit):  # the method may not have the stable one
            return settled(beside=True) or solution
    return solution


def orbit_beside(
    exact: ExactOrbit, method: str, order: int, functions: int | None = None
) -> Orbit | None:
    """Return the orbit of a method next to an exact one, or None; see `solve_case`."""
    return Search(exact.case, method, order, functions).from_exact(exact)


def with_order(case: Case, phases: str | Sequence[str], cycles: int | None = None) -> Case:
    """Return the case of an order of phases; of several, one with a stable orbit or with any.

    Parameters
    ----------
    case, phases, cycles
        See `cases_in_order`.

    Raises
    ------
    UnknownScene
        A `ValueError`: if there is no such order.
    """
    candidates = cases_in_order(case, phases, cycles)
    if len(candidates) == 1:
        return candidates[0]
    cases: dict[ExactOrbit, Case] = {}
    for candidate in candidates:
        with suppress(NoOrbit):
            cases[exact_orbit(candidate)] = candidate
        if any(exact.stable for exact in cases):
            break
    return cases[stable_first(cases)[0]] if cases else candidates[0]


def with_motion(case: Case, order: int = COARSE[-1]) -> Case:
    """Return the case of one motion that has an orbit, a stable one if possible.

    Parameters
    ----------
    case : Case
        Returned itself if its scene has one motion only.
    order : int
        The order of the search, if no such orbit is listed.

    Raises
    ------
    NoOrbit
        If no motion has an orbit; with the reasons for each.
    """
    if not case.scene.motions:
        return case
    for exact in known_orbits(case):
        if exact.stable is not False:
            return exact.case
    return solve_case(case, order=max(order, COARSE[-1])).case


def orbits_of(
    case: Case, method: str = FIRST, order: int = 10, functions: int | None = None
) -> list[Orbit]:
    """Return all admissible orbits that are found of a case, stable ones first.

    If the exact orbits of a motion can be listed, they are those next to these; else it is the
    one that `solve_case` finds.  Others are those on which simulations settle, in any order of
    phases.

    Parameters
    ----------
    case, method, order, functions
        See `solve_case`.

    Raises
    ------
    NoOrbit
        If there is none.
    """
    method = registry.generic_method(case.scene, method)
    if functions is None:
        functions = number_of_functions(case, method, None)
    orbits: list[Orbit] = []
    for motion in case.each_motion:
        search = search_of(motion, method, order, functions)
        of_motion = [search.from_exact(exact) for exact in known(motion).orbits]
        orbits += [orbit for orbit in of_motion if orbit is not None]
        if not known(motion).complete and not of_motion:
            with suppress(NoOrbit):
                orbits.append(search.run())
    for exact in settled_orbits(case, as_declared=True):
        others = [orbit.exact for orbit in orbits if orbit.exact is not None]
        lowest = registry.kernel(exact.case.scene, method, functions).lowest
        if order >= lowest and not any(are_one(exact, other) for other in others):
            orbit = orbit_beside(exact, method, order, functions)
            orbits += [] if orbit is None else [orbit]
    if not orbits:
        return [solve_case(case, method, order, functions)]
    return sorted(orbits, key=lambda orbit: orbit.stable is not True)


def number_of_functions(case: Case, method: str, wanted: int | None) -> int | None:
    """Return the number of functions of a method at each switch: as wanted, or the default.

    None for a method without such a number; `wanted` is then meant for other methods.
    """
    if not registry.functions(case.scene, method):
        return None
    return (2 if case.scene.k == 0 else 1) if wanted is None else wanted
