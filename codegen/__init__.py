"""The symbolic stage: from the equation of motion to the text of the kernels.

Stages, a folder each, in the order in which a derivation runs through them:

1. `scene` and `scenes`: an oscillator as data, and what SymPy checks and deduces of it.
2. `expansions` and `galerkin`: the conditions of any scene in a set of functions, in closed
   form with symbolic indices.
3. `emission` writes the conditions as a module of kernels; `generate` puts the modules into
   ``generated/``.
4. `show` makes the conditions records for a reader, `printing` prints them as text, LaTeX and
   HTML.

`shortcuts` has the paper's own Sections 3.1, 3.2 and 3.3, each ending in a
`system.GalerkinSystem`, and what is solved in their place.

Nothing else in the package imports SymPy.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

from . import readers as readers  # the records are read by what it names
from .system import DerivationError, Equation, GalerkinSystem

if TYPE_CHECKING:
    from .scene import Scene
    from .shortcuts.methods import METHODS, SOLVED
    from .shortcuts.side_by_side import SideBySide

#: Public names of the paper's own methods, and where they live: imported when asked for.
_OF_THE_PAPER = {"METHODS": "methods", "SOLVED": "methods", "SideBySide": "side_by_side"}


def __getattr__(name: str) -> Any:
    """Return a public name that the paper's own methods have."""
    if name not in _OF_THE_PAPER:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(f".shortcuts.{_OF_THE_PAPER[name]}", __package__), name)


def derive(
    method: str, scene: "str | Scene | None" = None, functions: int | None = None
) -> GalerkinSystem:
    """Return the derived equations of a method.

    Parameters
    ----------
    method : {"hb", "hb-c1", "c1", "hb-symmetric", "c1-reduced"}
        Section 3.1, 3.2 or 3.3 of the paper; or what is solved in place of the first two,
        by the symmetry of the orbit, and of the third, as one scalar equation.  With a
        scene: ``"hb"``, ``"hb-ck"``, ``"ck"``, ``"ck-tau"``, or spelled with its class.
    scene : str or Scene, optional
        Another oscillator than the paper's: its name, the path of its file, or itself.
    functions : int, optional
        With a scene and ``"hb-ck"``: functions with a break at each switch.

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
    >>> derive("c1").equation("16").sides[1]  # doctest: +ELLIPSIS
    e_0*t + e_1 + ...
    >>> derive("ck-tau", scene="impact").title
    'functions of class `C^0`, tested with Legendre polynomials'
    """
    if scene is None:
        from .shortcuts.methods import of_the_paper  # noqa: PLC0415  (left out, scenes still are)

        return of_the_paper(method)
    from .show import derive_scene  # noqa: PLC0415  (its sections are those of this package)

    return derive_scene(scene, method, functions)


def derive_scene(
    name_or_scene: "str | Scene", method: str, functions: int | None = None
) -> GalerkinSystem:
    """Return the equations of a scene in an expansion; see `show.derive_scene`."""
    return derive(method, name_or_scene, functions)


def side_by_side(method: str) -> "tuple[SideBySide, ...]":
    """Return each equation of a method with its LaTeX and its generated code.

    Parameters
    ----------
    method : {"hb", "hb-c1", "c1", "hb-symmetric", "c1-reduced"}
        As for `derive`.

    Returns
    -------
    tuple of SideBySide
        In the order of the record; only what the kernel computes.

    Raises
    ------
    ValueError
        If `method` is none of these.

    Examples
    --------
    >>> shown = {row.equation.number: row for row in side_by_side("c1")}
    >>> shown["20"].source.splitlines()[0]
    'def velocity_gain(p0, s):'
    """
    from .shortcuts.side_by_side import side_by_side as alongside  # noqa: PLC0415

    return alongside(derive(method))


__all__ = [
    "METHODS",
    "SOLVED",
    "DerivationError",
    "Equation",
    "GalerkinSystem",
    "SideBySide",
    "derive",
    "derive_scene",
    "side_by_side",
]
