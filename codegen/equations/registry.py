"""Scenes and expansions by their names, and documents on them.

A document on a scene has its own equations, then equations and Jacobian of each expansion.
"""

from collections.abc import Callable, Iterable, Mapping
from functools import cache
from pathlib import Path
from types import MappingProxyType, ModuleType

from ...nearest import one_of
from ...scene_files.read import is_path, read_scene, text_of
from .. import expansions, scenes
from ..galerkin import GalerkinConditions
from ..scene import Scene, in_order
from ..scene.orders import IMAGE
from ..scene.smoothness import class_of
from ..system import GalerkinSystem, Section
from .method import ONE_CYCLE, method_equations, spelled, unknowns
from .of_scene import scene_equations


def derive_scene(
    scene: str | Scene, method: str, functions: int | None = None
) -> GalerkinSystem:
    """Return the equations of a scene in an expansion; see `nonsmooth.codegen.derive`.

    Of several motions, the first is used.

    Examples
    --------
    >>> derive_scene("impact", "c0-tau").equations[2].text(unicode=False).splitlines()[0]
    '    -  expansion in flight; 0 <= t < T'
    """
    return method_equations(conditions(scene_named(scene).each_motion[0], method, functions))


#: The same with a cache, for scenes given by name.
derived = cache(derive_scene)


def sections(
    scene: str | Scene,
    names: Iterable[str] = (),
    functions: int | None = None,
    motion: str | None = None,
    phases: str | None = None,
) -> list[Section]:
    """Return the sections on a scene: its equations, and those and the Jacobian of each method.

    Several motions follow one after the other.

    Parameters
    ----------
    scene : str or Scene
    names : iterable of str
        Names of methods; all by default.
    functions : int, optional
        For methods that have functions with breaks; see `nonsmooth.codegen.derive`.
    motion : str, optional
        The only motion to be shown, of a scene with several.
    phases : str, optional
        In place of a motion, an order of phases as in `in_order`, declared or not.

    Raises
    ------
    ValueError
        If a name is unknown.
    """
    shown = scene_named(scene)
    if phases is not None:
        shown = in_order(shown, phases)
    elif motion is not None:
        shown = _motion_named(shown, motion)
    listed = tuple(names)
    return [
        section for part in shown.each_motion for section in _of_motion(part, listed, functions)
    ]


def _of_motion(scene: Scene, names: tuple[str, ...], functions: int | None) -> list[Section]:
    """Return the sections on one motion of a scene."""
    heading = f"{scene.label} (`C^{class_of(scene)}`): {scene.title}"
    shown = [Section(heading, scene_equations(scene), _parameters(scene))]
    for name in names or tuple(methods(scene)):
        record = conditions(scene, name, functions)
        system = method_equations(record)
        section = f"Section {system.section}: " if system.section else ""
        title = f"{section}{system.title} ({system.method})"
        listed = "; ".join(f"`{q}`: {what}" for q, what in unknowns(record))
        shown.append(Section(title, system.equations, f"Unknowns: {listed}."))
        if system.jacobian:
            note = "The conditions are linear in the coefficients: their factors are the rest."
            shown.append(Section(f"Jacobian of {system.method}", system.jacobian, note))
    return shown


def _parameters(scene: Scene) -> str:
    """Return the note on the parameters of a scene."""
    listed = "; ".join(
        f"`{q.symbol}`: {q.what}{f' in {q.unit}' if q.unit else ''}" for q in scene.parameters
    )
    forced = f"  {ONE_CYCLE}" if scene.frequency is not None else ""
    source = f"  After {scene.source}." if scene.source else ""
    mirrored = ",-" in f",{scene.motion}"  # of an order of phases that is not declared
    image = f"  With `{IMAGE}` behind it a phase is mirrored." if mirrored else ""
    return f"Parameters: {listed}.{source}{forced}{image}"


def scene_named(scene: str | Path | Scene) -> Scene:
    """Return a scene by its name or the path of its file.

    A `ValueError` suggests the scenes with the nearest names.
    """
    if isinstance(scene, Scene):
        return scene
    if not isinstance(scene, str | Path):
        expected = "its name, the path of its file, or a Scene, which has its formulas"
        raise ValueError(f"scene: got {scene!r:.80}, expected {expected}")
    if is_path(str(scene)):
        return read_scene(Path(scene), text_of(Path(scene)))
    return scenes.load(str(scene))


def _motion_named(scene: Scene, motion: str) -> Scene:
    """Return one motion of a scene as a scene; a `ValueError` if it has none of this name."""
    if motion not in scene.declared:
        names = list(scene.declared)
        expected = one_of(motion, names) if names else f"none: {scene.name} has only one"
        raise ValueError(f"motion: got {motion!r}, expected {expected}")
    return scene.of_motion(motion)


def methods(scene: Scene) -> Mapping[str, ModuleType]:
    """Return the expansions available for a scene by generic name, in their order."""
    made_for_it = (q for q in expansions.in_order() if expansions.applies(q, scene))
    return MappingProxyType({module.METHOD: module for module in made_for_it})


def conditions(scene: Scene, method: str, functions: int | None = None) -> GalerkinConditions:
    """Return the conditions of a scene in an expansion; see `nonsmooth.codegen.derive`."""
    expansion = _expansion(scene, method)
    derive: Callable[..., GalerkinConditions]
    derive = expansion.derive if scene.body is None else expansion.of_body
    if not hasattr(expansion, "FUNCTIONS"):
        if functions is not None:
            raise ValueError(f"functions: got {functions}, {method} has none with a break")
        return derive(scene)
    if functions is None:
        functions = 2 if class_of(scene) == 0 else 1
    if type(functions) is not int or functions not in expansion.FUNCTIONS:
        allowed = ", ".join(map(str, expansion.FUNCTIONS))
        raise ValueError(f"functions: got {functions!r}, expected for {method}: {allowed}")
    return derive(scene, functions)


def _expansion(scene: Scene, method: str) -> ModuleType:
    """Return the module of a method, by its generic name or that with the class."""
    modules = methods(scene)
    for name, module in modules.items():
        if method in (name, spelled(name, scene)):
            return module
    names = [*dict.fromkeys(q for name in modules for q in (name, spelled(name, scene)))]
    reason = f"{scene.name} is C{class_of(scene)}"
    if scene.body is not None:
        reason = "of a body the contact forces are expanded, not the coordinates"
    expected = f"{one_of(method, names)} ({reason})"
    raise ValueError(f"method: got {method!r:.80}, expected {expected}")
