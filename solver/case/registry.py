"""Find a scene's folder of generated modules, by the scene's name or by its path."""

import hashlib
import importlib
import types
from collections.abc import Iterable
from difflib import get_close_matches
from pathlib import Path
from typing import TYPE_CHECKING

from . import sealed
from .modules import module_of
from .names import generic, with_class_one, without_class
from .numbers import SCENE, SceneNumbers
from .sealed import Kept

if TYPE_CHECKING:
    from .kernel import Kernel

_GENERATED = f"{__package__.rpartition('.solver')[0]}.generated"


class UnknownScene(ValueError):  # noqa: N818  (named like the other errors of the package)
    """There is no scene, or no method of a scene, of the name that was given."""


def names() -> tuple[str, ...]:
    """Return the names of the shipped scenes: the folders of ``generated/`` that hold one."""
    folders = importlib.import_module(_GENERATED).__path__
    found = (path for folder in folders for path in Path(folder).glob(f"*/{SCENE}.py"))
    return tuple(sorted({path.parent.name.replace("_", "-") for path in found}))


def load(name: str) -> SceneNumbers:
    """Return a shipped scene.

    Parameters
    ----------
    name : str
        As `names` has it; with underscores for dashes as well.

    Raises
    ------
    UnknownScene
        If there is no such scene.
    """
    known = names()
    wanted = name.replace("_", "-") if isinstance(name, str) else ""
    if wanted not in known:
        raise UnknownScene(_unknown("scene", name, known))
    module = importlib.import_module(f"{_GENERATED}.{wanted.replace('-', '_')}.{SCENE}")
    return SceneNumbers(module, _folder(module))


def load_folder(folder: str | Path, kept: Kept | None = None) -> SceneNumbers:
    """Return the scene whose generated modules lie in `folder`, anywhere.

    Parameters
    ----------
    folder : str or Path
    kept : mapping of str to bytes, optional
        What was read of it; without it, a folder that is sealed is read and checked here.

    Raises
    ------
    UnknownScene
        If there is no ``scene.py`` in it.
    Damaged, NotPrivate
        See `sealed.read`.
    """
    path = Path(folder).resolve() / f"{SCENE}.py"
    found = sealed.read_any(path.parent) if kept is None else kept
    if not (path.is_file() if found is None else path.name in found):
        raise UnknownScene(f"scene: no {SCENE}.py in {str(folder)!r}")
    return SceneNumbers(module_of(path, found), path.parent, found)


def of_motion(scene: SceneNumbers, name: object) -> SceneNumbers:
    """Return a scene with one of its motions alone.

    Raises
    ------
    UnknownScene
        If it has no motion of this name; a scene of one motion has none.
    """
    if scene.motion is not None and name == scene.motion:
        return scene
    wanted = name.replace("_", "-") if isinstance(name, str) else name
    known = {motion.replace("_", "-"): motion for motion in scene.motions}
    if not scene.motions:
        raise UnknownScene(f"motion: got {name!r}, but {scene.label} has only one")
    if wanted not in known:
        raise UnknownScene(_unknown("motion", name, scene.motions))
    folder = known[str(wanted)].replace("-", "_")
    kept = None if scene.kept is None else sealed.below(scene.kept, folder)
    return load_folder(scene.folder / folder, kept)


def methods(scene: SceneNumbers) -> tuple[str, ...]:
    """Return the methods that have a kernel for a scene."""
    return tuple(sorted({method for method, _ in scene.files}))


def functions(scene: SceneNumbers, method: str) -> tuple[int, ...]:
    """Return how many functions beside the harmonics a method may have; empty if it has none.

    One kernel a number: ``<method>_<number>.py``.
    """
    found = (number for name, number in scene.files if name == method)
    return tuple(sorted(number for number in found if number is not None))


def generic_method(scene: SceneNumbers, method: object) -> str:
    """Return the generic name of a method: ``ck-tau`` where the class is in it (``c0-tau``).

    Where the scene is smoother, ``c1-tau`` is a method of its own: see `class_one`.

    Raises
    ------
    UnknownScene
        If the scene has no kernel of it.
    """
    known = methods(scene)
    wanted = generic(scene, method) if isinstance(method, str) else ""
    base = without_class(wanted)
    if wanted not in known and not (base in known and class_one(scene, base) == wanted):
        raise UnknownScene(_unknown("method", method, known))
    return wanted


def class_one(scene: SceneNumbers, method: str) -> str | None:
    """Return the name of a method with functions of class C^1 in place of smoother ones.

    None where it has no such conditions of its own, or the scene is not smoother.
    """
    from .kernel import once_continuous  # noqa: PLC0415  (NumPy: lists of scenes need none)

    if scene.k < 2 or (method, None) not in scene.files:
        return None
    if once_continuous(scene.kernel_module(method, None)) is None:
        return None
    return with_class_one(method)


def kernel(
    scene: SceneNumbers, method: str, number: int | None = None, *, compile_it: bool = False
) -> "Kernel":
    """Return the kernel of a method for a scene, as plain Python or compiled by numba.

    Parameters
    ----------
    scene, method : SceneNumbers, str
        See `generic_method`.
    number : int, optional
        Functions beside the harmonics, of a method that has them; see `functions`.
    compile_it : bool
        Whether numba is to compile it.

    Raises
    ------
    UnknownScene
        If the scene has no kernel of it.
    """
    from .kernel import compiled, plain  # noqa: PLC0415  (NumPy: lists of scenes need none)

    found = _module(scene, method, number)
    once = _once(scene, method, found)
    return once or (compiled(found) if compile_it else plain(found))


def quicker_kernel(
    scene: SceneNumbers, method: str, number: int | None = None, order: int = 0
) -> "Kernel":
    """Return the kernel in the form, plain or compiled, that is the better one by now.

    The same as `kernel`, which see; `order` is that for which it is wanted.
    """
    from .kernel import quicker  # noqa: PLC0415  (NumPy: lists of scenes need none)

    found = _module(scene, method, number)
    return _once(scene, method, found) or quicker(found, order)


def _once(scene: SceneNumbers, method: str, module: types.ModuleType) -> "Kernel | None":
    """Return the kernel of class C^1 if that is the method; else None."""
    from .kernel import once_continuous  # noqa: PLC0415  (NumPy: lists of scenes need none)

    name = generic_method(scene, method)
    return None if name in methods(scene) else once_continuous(module)


def _module(scene: SceneNumbers, method: str, number: int | None) -> types.ModuleType:
    """Return the generated module of a method.

    Raises
    ------
    UnknownScene
        If the scene has none.
    """
    name = without_class(generic_method(scene, method))
    if (name, number) not in scene.files:
        known = ", ".join(map(str, functions(scene, name))) or "none"
        raise UnknownScene(f"functions: got {number!r}, expected for {name}: {known}")
    return scene.kernel_module(name, number)


def mathematics(scene: SceneNumbers, chosen: Iterable[str]) -> str:
    """Return a hash of a scene and the conditions of these methods: 16 hexadecimal digits.

    The title of a scene, the defaults of its parameters and other words are not part of it.
    """
    wanted = {without_class(generic_method(scene, method)) for method in chosen}
    texts = [scene.module.MATHEMATICS]
    for motion in scene.each_motion:
        texts.append(motion.module.MATHEMATICS)
        by_path = sorted((path, key) for key, path in motion.files.items() if key[0] in wanted)
        texts += [motion.kernel_module(*key).MATHEMATICS for _, key in by_path]
    return hashlib.sha256("".join(texts).encode()).hexdigest()[:16]


def _unknown(what: str, found: object, known: tuple[str, ...]) -> str:
    close = get_close_matches(found, known, 1) if isinstance(found, str) else []
    hint = f"; did you mean {close[0]}?" if close else ""
    return f"{what}: got {found!r}, expected one of {', '.join(known) or '(none)'}{hint}"


def _folder(module: types.ModuleType) -> Path:
    return Path(str(module.__file__)).parent
