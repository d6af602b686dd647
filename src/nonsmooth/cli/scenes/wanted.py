"""What is to be solved on the command line, and the orbits that are found."""

from dataclasses import dataclass

from nonsmooth.solver.exact import ExactOrbit, exact_orbit
from nonsmooth.solver.kernels.registry import methods
from nonsmooth.solver.no_orbit import NoOrbit
from nonsmooth.solver.results.orbit import Orbit
from nonsmooth.solver.scenes.case import Case
from nonsmooth.solver.scenes.methods import FIRST, in_order
from nonsmooth.solver.solve import number_of_functions, solve_case, with_motion
from nonsmooth.solver.trade.budget import choose_within
from nonsmooth.solver.trade.choice import Choice, NotCertified, TooSlow
from nonsmooth.solver.trade.tolerance import choose_order

from ..aliases import check_one_method
from ..problems import Problem, as_problems, tell
from ..progress import busy
from .options import ORDER, generic_methods

#: What each method has found.
Found = dict[str, Orbit | NoOrbit]


@dataclass(frozen=True)
class Wanted:
    """What is to be solved, and by which methods; without any, by all."""

    methods: tuple[str, ...] = ()
    order: int | None = None
    functions: int | None = None
    tol: float | None = None
    budget: float | None = None

    @property
    def size(self) -> int:
        """N: the order that is wanted, or the default."""
        return ORDER if self.order is None else self.order

    @property
    def chosen_by(self) -> str:
        """The option that chooses an order, if one does."""
        if self.tol is not None:
            return "--tol"
        return "" if self.budget is None else "--budget"

    @property
    def one(self) -> bool:
        """Whether one orbit is wanted, and not that of every method."""
        return len(self.methods) == 1 or bool(self.chosen_by)


def search(case: Case, wanted: Wanted) -> tuple[Choice | None, Found]:
    """Return what a tolerance or a budget chose, and what was found by method.

    Where the scene has several motions, that which occurs is found first.  A `Problem` is
    raised if something wanted cannot be computed.
    """
    scene = case.scene
    with as_problems():
        chosen = generic_methods(scene, wanted.methods)
    if wanted.chosen_by:
        check_one_method(wanted.methods, wanted.chosen_by)
        return _choose(case, chosen[0] if chosen else None, wanted)
    names = chosen or in_order(methods(scene))
    outcomes: Found = {}
    try:
        with busy("looking for a motion"):
            case = with_motion(case, wanted.size)
    except NoOrbit as finding:
        tell(finding)
        return None, dict.fromkeys(names, finding)
    said: set[str] = set()
    for name in names:
        functions = wanted.functions
        if len(names) > 1:
            functions = number_of_functions(case, name, functions)
        try:
            with as_problems(), busy(f"{name}, N = {wanted.size}"):
                outcomes[name] = solve_case(case, name, wanted.size, functions)
        except NoOrbit as finding:
            tell(finding, said)
            outcomes[name] = finding
    return None, outcomes


def _choose(case: Case, method: str | None, wanted: Wanted) -> tuple[Choice | None, Found]:
    if wanted.order is not None:
        raise Problem(
            f"--order: got {wanted.order} beside {wanted.chosen_by}, which chooses it"
        )
    if wanted.tol is not None and wanted.budget is not None:
        raise Problem(f"--budget: got {wanted.budget:g} s beside --tol, expected one of them")
    name = method or FIRST
    try:
        if wanted.budget is not None:
            with as_problems(), busy(f"{method or 'all methods'} within {wanted.budget:g} s"):
                choice = choose_within(case, wanted.budget, method, wanted.functions)
        else:
            assert wanted.tol is not None
            with as_problems(), busy(f"{name} to {wanted.tol:g}"):
                choice = choose_order(case, wanted.tol, name, wanted.functions)
    except NotCertified as finding:
        raise Problem(f"no orbit is certified: {finding}", 1) from finding
    except TooSlow as finding:
        raise Problem(str(finding), 1) from finding
    except NoOrbit as finding:
        tell(finding)
        return None, {name: finding}
    return choice, {choice.orbit.method: choice.orbit}


def exact_near(case: Case, orbits: list[Orbit]) -> ExactOrbit | None:
    """Return the exact orbit next to the orbits, or any if there are none."""
    for orbit in orbits:
        if orbit.exact is not None:
            return orbit.exact
    if case.scene.motions:  # none has an orbit: all were tried
        return None
    try:
        return exact_orbit(case)
    except NoOrbit:
        return None
