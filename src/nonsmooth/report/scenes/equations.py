"""The derived equations of a scene, as a part of its page."""

from nonsmooth.codegen import equations
from nonsmooth.codegen.printing.html import fragment_of

from ..html import folded


def equations_of(source: str) -> str:
    """Return the equations of a scene in every expansion, as a fragment of a page.

    Parameters
    ----------
    source : str
        Name of the scene, or path of its file.
    """
    return folded(fragment_of(equations.sections(source, (), None)))
