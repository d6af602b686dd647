"""What a document on a scene consists of: the oscillator, then each expansion."""

from collections.abc import Iterable

from ..printing.sections import Section
from ..scene import Scene
from .bodies import body_equations
from .method import ONE_CYCLE, method_equations, unknowns
from .notation import Notation
from .of_scene import scene_equations
from .registry import conditions, methods, motion_named, scene_named


def sections(
    scene: str | Scene,
    names: Iterable[str] = (),
    functions: int | None = None,
    motion: str | None = None,
) -> list[Section]:
    """Return the sections on a scene: what it is, and for each method equations and Jacobian.

    Of several motions, one after the other.

    Parameters
    ----------
    scene : str or Scene
    names : iterable of str
        Of methods; without any, all.
    functions : int, optional
        For methods that have functions with breaks; see `derive_scene`.
    motion : str, optional
        The one that is shown, of a scene with several.

    Raises
    ------
    ValueError
        If a name is unknown.
    """
    found = scene_named(scene)
    parts = found.each_motion if motion is None else (motion_named(found, motion),)
    listed = tuple(names)
    return [section for part in parts for section in _of_motion(part, listed, functions)]


def _of_motion(found: Scene, names: tuple[str, ...], functions: int | None) -> list[Section]:
    of_scene = scene_equations if found.body is None else body_equations
    shown = [Section(heading(found), of_scene(found), _parameters(found))]
    for name in names or tuple(methods(found)):
        record = conditions(found, name, functions)
        system = method_equations(record)
        section = f"Section {system.section}: " if system.section else ""
        title = f"{section}{system.title} ({system.method})"
        listed = "; ".join(f"`{q}`: {what}" for q, what in unknowns(record))
        shown.append(Section(title, system.equations, f"Unknowns: {listed}."))
        if system.jacobian:
            note = "The conditions are linear in the coefficients: their factors are the rest."
            shown.append(Section(f"Jacobian of {system.method}", system.jacobian, note))
    return shown


def heading(scene: Scene) -> str:
    """Return what a scene is, with its class."""
    return f"{scene.label} (`C^{Notation.of(scene).k}`): {scene.title}"


def _parameters(scene: Scene) -> str:
    listed = "; ".join(
        f"`{q.symbol}`: {q.what}{f' in {q.unit}' if q.unit else ''}" for q in scene.parameters
    )
    forced = f"  {ONE_CYCLE}" if scene.frequency is not None else ""
    source = f"  After {scene.source}." if scene.source else ""
    return f"Parameters: {listed}.{source}{forced}"
