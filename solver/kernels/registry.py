"""Shipped scenes by name, and kernels by scene and method."""

import hashlib
import importlib
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import TYPE_CHECKING

from ...nearest import one_of
from ..scenes.loaded import SCENE, LoadedScene, UnknownScene
from ..scenes.methods import about, generic, module_of, with_class_one, without_class
from ..scenes.methods import methods as methods  # noqa: PLC0414  (its own, too)
from .account import PLAIN_ORDER, PLAIN_PHASES, Account

if TYPE_CHECKING:
    from .kernel import Kernel

_GENERATED = f"{__package__.rpartition('.solver')[0]}.generated"


def names() -> tuple[str, ...]:
    """Return the names of the shipped scenes: the folders of ``generated/`` that hold one."""
    folders = importlib.import_module(_GENERATED).__path__
    paths = (path for folder in folders for path in Path(folder).glob(f"*/{SCENE}.py"))
    return tuple(sorted({path.parent.name.replace("_", "-") for path in paths}))


def load(name: str) -> LoadedScene:
    """Return a shipped scene by its name, with hyphens or underscores.

    Raises
    ------
    UnknownScene
        If there is no such scene.
    """
    shipped = names()
    hyphenated = name.replace("_", "-") if isinstance(name, str) else ""
    if hyphenated not in shipped:
        raise UnknownScene(f"scene: got {name!r}, expected {one_of(name, shipped)}")
    module = importlib.import_module(f"{_GENERATED}.{hyphenated.replace('-', '_')}.{SCENE}")
    return LoadedScene(module, Path(str(module.__file__)).parent)


def functions(scene: LoadedScene, method: str) -> tuple[int, ...]:
    """Return the allowed numbers of functions added to harmonics; empty if not variable."""
    return about(method).functions if method in methods(scene) else ()


def generic_method(scene: LoadedScene, method: object) -> str:
    """Return the generic name of a method: ``ck-tau`` for ``c0-tau`` in a scene of class C^0.

    In a scene smoother than C^1, ``c1-tau`` is a method of its own: see `class_one`.

    Raises
    ------
    UnknownScene
        If the scene has no kernel of it.
    """
    valid = methods(scene)
    name = generic(scene, method) if isinstance(method, str) else ""
    base = without_class(name)
    if name not in valid and not (base in valid and class_one(scene, base) == name):
        expected = one_of(method, valid)
        if scene.has_body and about(base).kernel:
            expected = (
                f"{', '.join(valid)}, which expand the contact force: an expansion of a body's "
                "coordinates needs N > omega tau/2, omega of its fastest mode, tau of a phase"
            )
        raise UnknownScene(f"method: got {method!r}, expected {expected}")
    return name


def class_one(scene: LoadedScene, method: str) -> str | None:
    """Return the name of a method with functions of class C^1 in place of smoother ones.

    None if the scene is not smoother than C^1, or the method has no such variant.
    """
    facts = about(method)
    exists = not facts.is_series and not facts.unseen and scene.k > 1 and not scene.has_body
    return with_class_one(method) if exists else None


def kernel(
    scene: LoadedScene, method: str, number: int | None = None, *, compile_it: bool = False
) -> "Kernel":
    """Return the kernel of a method for a scene, as plain Python or compiled by numba.

    Parameters
    ----------
    scene, method : LoadedScene, str
        See `generic_method`.  Of several motions of a scene, the first is used.
    number : int, optional
        Number of functions added to the harmonics; one of `functions`.
    compile_it : bool
        Whether numba compiles it.

    Raises
    ------
    UnknownScene
        If the scene has no kernel of it.
    """
    return _kernel(scene, method, number, lambda spent: compile_it)


def quicker_kernel(
    scene: LoadedScene, method: str, number: int | None = None, order: int = 0
) -> "Kernel":
    """Return the `kernel`, compiled if that pays by now; see `compiling`.

    For a high `order`, or many phases, a kernel in numba's cache is compiled at its first use.
    """
    long = order > PLAIN_ORDER or len(scene.phases) > PLAIN_PHASES

    def pays(spent: Account) -> bool:
        return spent.pays() or (long and spent.is_cached())

    return _kernel(scene, method, number, pays)


def _kernel(
    scene: LoadedScene,
    method: str,
    number: int | None,
    compiles: Callable[[Account], bool],
) -> "Kernel":
    """Return the kernel of a method, compiled if ``compiles(account)``."""
    from . import polynomials, series  # noqa: PLC0415  (NumPy: lists of scenes need none)

    generic_name = generic_method(scene, method)
    name, facts = without_class(generic_name), about(generic_name)
    scene = scene.each_motion[0]
    allowed = facts.functions or (None,)
    if number not in allowed:
        expected = ", ".join(map(str, facts.functions)) or "none"
        raise UnknownScene(f"functions: got {number!r}, expected for {name}: {expected}")
    if scene.has_body:
        from . import bodies  # noqa: PLC0415  (SciPy)

        return bodies.kernel(scene, name, number, compiles)
    layout: polynomials.Layout | series.Layout
    if facts.is_series:
        layout = series.Layout(scene, name, number or 0)
    else:
        layout = polynomials.Layout(scene, name, generic_name != name)
    return layout.family.kernel(layout, compiles(layout.family.account(name)))


def mathematics(scene: LoadedScene, chosen: Iterable[str]) -> str:
    """Return a hash of a scene and the conditions of these methods: 16 hexadecimal digits.

    It does not depend on the title of the scene, on defaults of its parameters or on words.
    """
    generic_names = {without_class(generic_method(scene, method)) for method in chosen}
    texts = [scene.module.MATHEMATICS, *(q.module.MATHEMATICS for q in scene.each_motion)]
    texts += [f"{q} {module_of(q).MATHEMATICS}" for q in sorted(generic_names)]
    return hashlib.sha256("".join(texts).encode()).hexdigest()[:16]
