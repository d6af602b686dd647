"""Find a scene's folder of generated modules, by the scene's name or by its path."""

import hashlib
import importlib
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import TYPE_CHECKING

from ...nearest import one_of
from ..scenes.loaded import SCENE, LoadedScene, UnknownScene
from ..scenes.methods import about, generic, module_of, with_class_one, without_class
from ..scenes.methods import methods as methods  # noqa: PLC0414  (its own, too)
from .compiling import PLAIN_ORDER, Account

if TYPE_CHECKING:
    from .kernel import Kernel

_GENERATED = f"{__package__.rpartition('.solver')[0]}.generated"


def names() -> tuple[str, ...]:
    """Return the names of the shipped scenes: the folders of ``generated/`` that hold one."""
    folders = importlib.import_module(_GENERATED).__path__
    found = (path for folder in folders for path in Path(folder).glob(f"*/{SCENE}.py"))
    return tuple(sorted({path.parent.name.replace("_", "-") for path in found}))


def load(name: str) -> LoadedScene:
    """Return a shipped scene by its name, as `names` has it; also with underscores.

    Raises
    ------
    UnknownScene
        If there is no such scene.
    """
    known = names()
    wanted = name.replace("_", "-") if isinstance(name, str) else ""
    if wanted not in known:
        raise UnknownScene(f"scene: got {name!r}, expected {one_of(name, known)}")
    module = importlib.import_module(f"{_GENERATED}.{wanted.replace('-', '_')}.{SCENE}")
    return LoadedScene(module, Path(str(module.__file__)).parent)


def functions(scene: LoadedScene, method: str) -> tuple[int, ...]:
    """Return how many functions beside the harmonics a method may have; empty if none."""
    return about(method).functions if method in methods(scene) else ()


def generic_method(scene: LoadedScene, method: object) -> str:
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
        expected = one_of(method, known)
        if scene.has_body and about(base).kernel:
            expected = (
                f"{', '.join(known)}, which expand the contact force: an expansion of a body's "
                "coordinates needs N > omega tau/2, omega of its fastest mode, tau of a phase"
            )
        raise UnknownScene(f"method: got {method!r}, expected {expected}")
    return wanted


def class_one(scene: LoadedScene, method: str) -> str | None:
    """Return the name of a method with functions of class C^1 in place of smoother ones.

    None where it has no such conditions of its own, or the scene is not smoother.
    """
    found = about(method)
    smoother = not found.is_series and not found.unseen and scene.k > 1 and not scene.has_body
    return with_class_one(method) if smoother else None


def kernel(
    scene: LoadedScene, method: str, number: int | None = None, *, compile_it: bool = False
) -> "Kernel":
    """Return the kernel of a method for a scene, as plain Python or compiled by numba.

    Parameters
    ----------
    scene, method : LoadedScene, str
        See `generic_method`.  Of a scene with several motions it is that of the first.
    number : int, optional
        Functions beside the harmonics, of a method that has them; see `functions`.
    compile_it : bool
        Whether numba is to compile it.

    Raises
    ------
    UnknownScene
        If the scene has no kernel of it.
    """
    return _kernel(scene, method, number, lambda spent: compile_it)


def quicker_kernel(
    scene: LoadedScene, method: str, number: int | None = None, order: int = 0
) -> "Kernel":
    """Return the kernel in the form, plain or compiled, that is the better one by now.

    The same as `kernel`, which see; `order` is that for which it is wanted: for a high one it
    is compiled from the first, if it is in numba's cache.
    """

    def pays(spent: Account) -> bool:
        return spent.pays() or (order > PLAIN_ORDER and spent.is_cached())

    return _kernel(scene, method, number, pays)


def _kernel(
    scene: LoadedScene,
    method: str,
    number: int | None,
    compiles: Callable[[Account], bool],
) -> "Kernel":
    """Return the kernel of a method, compiled if that is to be by what it has cost."""
    from . import polynomials, series  # noqa: PLC0415  (NumPy: lists of scenes need none)

    wanted = generic_method(scene, method)
    name, found = without_class(wanted), about(wanted)
    scene = scene.each_motion[0]
    known = found.functions or (None,)
    if number not in known:
        expected = ", ".join(map(str, found.functions)) or "none"
        raise UnknownScene(f"functions: got {number!r}, expected for {name}: {expected}")
    if scene.has_body:
        from . import bodies  # noqa: PLC0415  (SciPy)

        return bodies.kernel(scene, name, number, compiles)
    layout: polynomials.Layout | series.Layout
    if found.is_series:
        layout = series.Layout(scene, name, number or 0)
    else:
        layout = polynomials.Layout(scene, name, wanted != name)
    return layout.family.kernel(layout, compiles(layout.family.account(name)))


def mathematics(scene: LoadedScene, chosen: Iterable[str]) -> str:
    """Return a hash of a scene and the conditions of these methods: 16 hexadecimal digits.

    The title of a scene, the defaults of its parameters and other words are not part of it.
    """
    wanted = {without_class(generic_method(scene, method)) for method in chosen}
    texts = [scene.module.MATHEMATICS, *(q.module.MATHEMATICS for q in scene.each_motion)]
    texts += [f"{q} {module_of(q).MATHEMATICS}" for q in sorted(wanted)]
    return hashlib.sha256("".join(texts).encode()).hexdigest()[:16]
