"""The expansion that is solved beside each orbit of a branch, from its times."""

from contextlib import suppress
from dataclasses import dataclass

from .branch.piece import Piece
from .branch.place import Place
from .kernels import registry
from .no_orbit import NoOrbit
from .results.family import Beside
from .scenes.case import Case
from .scenes.loaded import UnknownScene
from .scenes.methods import FIRST
from .scenes.parameter_error import whole_or_none
from .search import check_order
from .solve import number_of_functions, orbit_beside

#: Order of an expansion, where none is named.
ORDER = 10


@dataclass(frozen=True)
class Expansion:
    """An expansion that is solved beside each orbit of a branch; without an order, none."""

    method: str = "exact"
    order: int = 0
    functions: int | None = None

    @classmethod
    def checked(
        cls, case: Case, method: str | None, order: int | None, functions: int | None
    ) -> "Expansion":
        """Return what users ask for: nothing, without a method and an order.

        Raises
        ------
        ValueError
            If it cannot be computed.
        """
        if method is None and order is None:
            if functions is not None:
                raise ValueError(f"functions: got {functions!r}, expected beside a method")
            return cls()
        name = registry.generic_method(case.scene, FIRST if method is None else method)
        count = number_of_functions(case, name, whole_or_none("functions", functions))
        kernel = registry.kernel(case.scene, name, count)
        return cls(name, check_order(kernel, ORDER if order is None else order), count)

    def beside(self, piece: Piece, place: Place) -> Beside | None:
        """Return its orbit next to one of a branch; None without one."""
        exact = piece.orbit(place.y) if self.order else None
        if exact is None or not exact.outcome.converged:
            return None
        with suppress(ArithmeticError, UnknownScene, NoOrbit):
            orbit = orbit_beside(exact, self.method, self.order, self.functions)
            if orbit is not None and orbit.errors is not None:
                times = orbit.period, orbit.forcing_phase, orbit.durations
                return Beside(*times, orbit.errors)
        return None
