"""The symbolic stage: from the equation of motion to the text of the kernels.

Stages, a folder each, in the order in which a derivation runs through them:

1. `scene` and `scenes`: an oscillator as data, and what SymPy checks and deduces of it.
2. `expansions` and `galerkin`: the conditions of any scene in a set of functions, in closed
   form with symbolic indices.
3. `emission` writes their closed forms as a module; `generate` puts the modules into
   ``generated/``.
4. `equations` makes the conditions records for a reader, `printing` prints them as text,
   LaTeX and HTML.

Nothing else in the package imports SymPy.
"""

from typing import TYPE_CHECKING

from .system import DerivationError, Equation, GalerkinSystem

if TYPE_CHECKING:
    from .scene import Scene

#: The scene of the paper, which is meant where none is named.
OF_THE_PAPER = "stick-slip"


def derive(
    method: str, scene: "str | Scene" = OF_THE_PAPER, functions: int | None = None
) -> GalerkinSystem:
    """Return the derived equations of a scene in an expansion.

    Parameters
    ----------
    method : str
        ``"hb"``, ``"hb-ck"``, ``"ck"`` or ``"ck-tau"``; the class of the scene may stand in
        the name.  ``"hb"``, ``"hb-c1"`` and ``"c1"`` are Sections 3.1 to 3.3 of the paper.
    scene : str or Scene
        The name of a scene, the path of its file, or the scene itself; default: the paper's.
    functions : int, optional
        Functions of ``"hb-ck"`` with a break at each switch.

    Returns
    -------
    GalerkinSystem
        Derived once in a process.

    Raises
    ------
    ValueError
        If `method` or `scene` is none of these.

    Examples
    --------
    >>> derive("hb-c1").equation("14").title
    'residual, orthogonal to the function itself'
    >>> derive("ck-tau", scene="impact").title
    'functions of class `C^0`, tested with Legendre polynomials'
    """
    from ..scene_files.read import is_path  # noqa: PLC0415
    from .equations import registry  # noqa: PLC0415  (its sections are those of this package)

    named = isinstance(scene, str) and not is_path(scene) and isinstance(functions, int | None)
    return (registry.derived if named else registry.derive_scene)(scene, method, functions)


__all__ = ["DerivationError", "Equation", "GalerkinSystem", "derive"]
