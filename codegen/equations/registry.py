"""Scenes and expansions by their names: those of the folders, whatever is in them."""

from collections.abc import Mapping
from functools import cache
from importlib import import_module
from pathlib import Path
from pkgutil import iter_modules
from types import MappingProxyType, ModuleType

from ...nearest import one_of
from .. import expansions, scenes
from ..galerkin import GalerkinConditions
from ..scene import Scene, switches
from ..system import GalerkinSystem
from .method import method_equations, spelled


def derive_scene(
    scene: str | Scene, method: str, functions: int | None = None, motion: str | None = None
) -> GalerkinSystem:
    """Return the equations of a scene in an expansion, for showing.

    Parameters
    ----------
    scene : str or Scene
        A name of ``codegen/scenes``, the path of a scene file, or a scene.
    method : str
        A name of ``codegen/expansions``, generic or with the class of the scene.
    functions : int, optional
        How many functions with a break there are at each switch, for a method that has them;
        without it one, and two where the velocity jumps.
    motion : str, optional
        Of a scene with several motions, which; without it the first.

    Returns
    -------
    GalerkinSystem
        Derived once in a process for a scene of the folder.

    Raises
    ------
    ValueError
        Naming what is unknown, and the nearest name that is not.

    Examples
    --------
    >>> derive_scene("impact", "c0-tau").equations[2].text(unicode=False).splitlines()[0]
    '    -  expansion in flight; 0 <= t < T'
    """
    if isinstance(scene, Scene) or is_path(scene):
        return _derived(scene_named(scene), method, functions, motion)
    return _of_the_folder(scene, method, functions, motion)


@cache
def _of_the_folder(
    scene: str, method: str, functions: int | None, motion: str | None
) -> GalerkinSystem:
    return _derived(scene_named(scene), method, functions, motion)


def _derived(
    scene: Scene, method: str, functions: int | None, motion: str | None
) -> GalerkinSystem:
    one = scene.each_motion[0] if motion is None else motion_named(scene, motion)
    return method_equations(conditions(one, method, functions))


def motion_named(scene: Scene, motion: str) -> Scene:
    """Return a scene with one of its motions alone.

    A `ValueError` names the nearest motion that there is.
    """
    if motion not in scene.motions:
        known = list(scene.motions)
        expected = one_of(motion, known) if known else f"none: {scene.name} has only one"
        raise ValueError(f"motion: got {motion!r}, expected {expected}")
    return scene.of_motion(motion)


def conditions(scene: Scene, method: str, functions: int | None = None) -> GalerkinConditions:
    """Return the conditions of a scene in an expansion; see `derive_scene`."""
    expansion = _expansion(scene, method)
    derive = expansion.derive if scene.body is None else expansion.of_body
    if not hasattr(expansion, "FUNCTIONS"):
        if functions is not None:
            raise ValueError(f"functions: got {functions}, {method} has none with a break")
        found: GalerkinConditions = derive(scene)
        return found
    if functions is None:
        functions = 2 if _class(scene) == 0 else 1
    if not isinstance(functions, int) or functions < 1:
        raise ValueError(f"functions: got {functions!r}, expected a whole number from 1")
    with_breaks: GalerkinConditions = derive(scene, functions)
    return with_breaks


def _class(scene: Scene) -> int:
    return min(switch.k for switch in switches(scene))


@cache
def scene_files() -> Mapping[str, Scene]:
    """Return the scenes of the folder by their names."""
    found = (
        import_module(f"{scenes.__name__}.{q.name}") for q in iter_modules(scenes.__path__)
    )
    return MappingProxyType({module.SCENE.name: module.SCENE for module in found})


def methods(scene: Scene) -> Mapping[str, ModuleType]:
    """Return the expansions that there are for a scene by their generic names, as told."""
    made_for_it = (q for q in expansions.in_order() if expansions.applies(q, scene))
    return MappingProxyType({module.METHOD: module for module in made_for_it})


def is_path(name: str) -> bool:
    """Whether a scene is given by the path of its file."""
    return name.endswith(".py") or "/" in name


def scene_named(scene: str | Scene) -> Scene:
    """Return a scene by its name or the path of its file.

    A `ValueError` names the nearest scene that there is.
    """
    known = scene_files()
    if isinstance(scene, Scene):
        found = scene
    elif is_path(scene):
        found = _from_file(Path(scene))
    elif scene in known:
        found = known[scene]
    else:
        raise ValueError(f"scene: got {scene!r}, expected {one_of(scene, list(known))}")
    return found


def _from_file(path: Path) -> Scene:
    from ...scene_files.read import read_scene, text_of  # noqa: PLC0415  (read in one place)

    return read_scene(path, text_of(path))


def _expansion(scene: Scene, method: str) -> ModuleType:
    known = methods(scene)
    for name, module in known.items():
        if method in (name, spelled(name, scene)):
            return module
    names = [*dict.fromkeys(q for name in known for q in (name, spelled(name, scene)))]
    of = f"{scene.name} is C{_class(scene)}"
    if scene.body is not None:
        of = "of a body the contact forces are expanded, not the coordinates"
    raise ValueError(f"method: got {method!r}, expected {one_of(method, names)} ({of})")
