"""What the report takes of the paper's oscillator beside its orbits."""

from nonsmooth.all_solutions import solutions
from nonsmooth.codegen.equations import sections
from nonsmooth.codegen.printing.html import fragment_of
from nonsmooth.kim_perkins import METHODS, SCENE, SECTION_4, StickSlip
from nonsmooth.solver.kernels import registry

__all__ = ["DEFAULT", "METHODS", "all_times", "equations_html", "mathematics"]

#: The oscillator of Section 4.
DEFAULT = StickSlip(**SECTION_4)


def equations_html() -> str:
    """Return the equations of Sections 3.1 to 3.3 as a fragment of a page.

    Equation (14) has the anchor ``eq-14``; the second of the same number, in another phase or
    method, ``eq-14-2``.
    """
    return fragment_of(sections(SCENE, METHODS))


def all_times(belt: StickSlip, order: int) -> list[tuple[float, float]]:
    """Return ``t1`` and ``T`` in s of all real solutions of (18) to (20), orbits or not."""
    return [(found.t1, found.period) for found in solutions(belt, order)]


def mathematics(method: str) -> str:
    """Return the beginning of the hash of the symbolic expressions behind a method."""
    return registry.mathematics(registry.load(SCENE), [method])
