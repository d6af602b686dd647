"""One orbit of a case by one method, or the reason why there is none."""

import operator
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from itertools import product

import numpy as np

from .arrays import Vector
from .case import registry
from .case.case import Case
from .case.kernel import SceneKernel
from .case.methods import FIRST
from .flow.exact import exact_orbit
from .flow.existence import (
    infinitely_many,
    is_in_vain,
    scanned,
    shown_to_be_none,
    without_switches,
)
from .iteration.attempt import attempt
from .iteration.singular import is_reversible, is_singular
from .iteration.start import PATIENCE, rough_times
from .motions import of_any_motion
from .no_orbit import NoOrbit
from .orbit.orbit import SceneOrbit
from .simulation.settle import rough_times_by_simulation

#: Orders of the method from whose times every other starts: it converges from rough times at
#: the first, and where a motion has too many waves for that, at the second.
COARSE = (5, 12)

#: Added to them for each further cycle of the forcing.
WAVES = 4

#: Most unknowns are dense: beyond, a system takes seconds and nothing is gained.
HIGHEST_ORDER = 400


def solve_case(
    case: Case,
    method: str = FIRST,
    order: int = 10,
    functions: int | None = None,
    motion: str | None = None,
) -> SceneOrbit:
    """Return the periodic orbit of a case, converged and admissible.

    Parameters
    ----------
    case : Case
        The oscillator.
    method : str
        One of `registry.methods`, by its generic name or with its class.
    order : int
        ``N``.
    functions : int, optional
        Functions beside the harmonics at each switch, where the method counts them; 1, or 2
        where the velocity jumps, if not given.
    motion : str, optional
        One of the motions of the scene, where it has several; else each is tried, in their
        order, until an orbit is found.

    Raises
    ------
    TypeError
        If `case` is not a `Case`.
    ValueError
        If the scene has no kernel of the method or no such motion, or a number is out of its
        range.
    NoOrbit
        If no start led to a converged and admissible orbit; with what each led to.

    Examples
    --------
    >>> from nonsmooth.solver.case import registry
    >>> case = registry.load(registry.names()[0])()
    >>> solve_case(case, order=12).admissible
    True
    """
    if not isinstance(case, Case):
        raise TypeError(f"case: got {case!r:.80}, expected a Case")
    method = registry.generic_method(case.scene, method)
    if motion is not None:
        case = case.of_motion(motion)
    if functions is None:
        functions = number_of_functions(case, method, None)
    if case.scene.motions:
        return of_any_motion(case, lambda each: _orbit(each, method, order, functions))
    return _orbit(case, method, order, functions)


def with_motion(case: Case) -> Case:
    """Return the case of the motion that occurs, where a scene has several; else the case.

    Raises
    ------
    NoOrbit
        If none has an orbit; with the reasons of each.
    """
    return solve_case(case).case if case.scene.motions else case


def _orbit(case: Case, method: str, order: int, functions: int | None) -> SceneOrbit:
    """Return the orbit of a case of one motion."""
    kernel = registry.kernel(case.scene, method, functions)
    order = check_order(kernel, order)
    kernel = registry.quicker_kernel(case.scene, method, functions, order)
    search = _Search(case, kernel)
    for times in search.starts():
        found = search.note(attempt(kernel, case, order, times, functions))
        if not (found.converged and found.admissible):
            found = search.less_smooth(found, times)
        if found.converged and found.admissible:
            return replace(found, iterations=search.iterations)
    reason = f"{case.scene.label}, {kernel.method}, N = {order}: no admissible orbit was found"
    reasons = [reason, *_what_else(case, search)]
    tried = tuple(dict.fromkeys(search.tried))
    error = shown_to_be_none(case, tried) or NoOrbit("; ".join(reasons), False, tried)
    error.iterations = search.iterations
    raise error


def _what_else(case: Case, search: "_Search") -> Iterator[str]:
    """Yield what explains that no orbit was found, as far as that is known."""
    if search.exact:
        yield "there is an exact orbit, and from its times there is no way to one"
        return
    many = infinitely_many(case)
    if many:
        yield many
    yield from scanned(case)
    yield from without_switches(case)


def number_of_functions(case: Case, method: str, wanted: int | None) -> int | None:
    """Return the number of functions that a method has: as wanted, or as is usual.

    None where it does not count functions; there, what is wanted is meant for another method.
    """
    if not registry.functions(case.scene, method):
        return None
    return (2 if case.scene.k == 0 else 1) if wanted is None else wanted


@dataclass
class _Search:
    """The ways to an orbit, and what each came to."""

    case: Case
    kernel: SceneKernel
    words: str = ""
    iterations: int = 0
    exact: bool = False
    tried: list[str] = field(default_factory=list)

    def note(self, found: SceneOrbit) -> SceneOrbit:
        """Return a result, after its iterations and its failure, if it is one, were noted."""
        self.iterations += found.outcome.iterations
        why = "" if found.converged else found.outcome.reason
        why = why or "; ".join(found.violations)
        if why:
            self.tried.append(f"from {self.words}: {found.method}, N = {found.order}: {why}")
        return found

    def less_smooth(self, failed: SceneOrbit, times: Vector) -> SceneOrbit:
        """Return the orbit by functions of class C^1, if no smoother ones can be told apart.

        That is so where the conditions of the method are singular at that orbit.  In any other
        case what failed is returned.
        """
        name = registry.class_one(self.case.scene, failed.method)
        if name is None:
            return failed
        kernel = registry.kernel(self.case.scene, name)
        found = self.note(attempt(kernel, self.case, failed.order, times))
        there = kernel.times(found.unknowns)
        if found.converged and is_singular(self.kernel, self.case, failed.order, there):
            return found
        return failed

    def starts(self) -> Iterator[Vector]:
        """Yield times to start from: those of a coarse orbit, or rough ones if none can be.

        Then those on which a simulation settles, or why there are none; at last those of the
        exact orbit, which may be found where a coarse one is not.
        """
        scene = self.case.scene
        known = FIRST in registry.methods(scene)
        once = is_reversible(self.case.cell) and registry.class_one(scene, FIRST)
        coarse = registry.quicker_kernel(scene, once or FIRST) if known else None
        waves = WAVES * (self.case.cycles - 1)
        orders = [q + waves for q in COARSE] if coarse else COARSE[:1]
        ways = product(orders, rough_times(self.case.cell))
        vain = False
        for number, (order, rough) in enumerate(ways):
            vain = number == PATIENCE and is_in_vain(self.case)
            if vain:
                break
            self.words = rough.words
            angle = (rough.angle,) if self.kernel.forced else ()
            times = np.array([*rough.durations, *angle])
            if coarse is None:
                yield times
                continue
            found = self.note(attempt(coarse, self.case, order, times))
            if found.converged and found.admissible:
                yield coarse.times(found.unknowns)
        for settled in rough_times_by_simulation(self.case):
            self.words = settled.words
            if settled.times is None:
                self.tried.append(settled.words)
            else:
                angle = (settled.times.angle,) if self.kernel.forced else ()
                yield np.array([*settled.times.durations, *angle])
        if vain:
            return
        try:
            exact = exact_orbit(self.case)
        except NoOrbit:
            return
        self.exact, self.words = True, "the times of the exact orbit"
        yield exact.times


def check_order(kernel: SceneKernel, value: object) -> int:
    """Return an order as a whole number that the method can compute.

    Raises
    ------
    ValueError
        If it is not one.
    """
    try:
        number = -1 if isinstance(value, bool) else operator.index(value)  # type: ignore[arg-type]
    except TypeError:
        number = -1
    if not kernel.lowest <= number <= HIGHEST_ORDER:
        expected = f"a whole number from {kernel.lowest} to {HIGHEST_ORDER}"
        raise ValueError(f"order: got {value!r}, expected {expected} for {kernel.method}")
    return number
