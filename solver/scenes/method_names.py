"""What methods are called where people read them: with the class of the scene."""

from typing import Any

from ...generated.methods import METHODS
from .loaded import LoadedScene

#: Stands for the class C^k in the generic name of a method.
CLASS = "ck"

#: What stands there of functions of class C^1, where the scene is smoother.
CLASS_ONE = CLASS.replace("k", "1")


def methods(scene: LoadedScene) -> tuple[str, ...]:
    """Return the methods that there are for a scene, by their generic names."""
    facts: dict[str, dict[str, Any]] = METHODS
    if scene.has_body:
        return tuple(sorted(q for q in facts if facts[q]["bodies"]))
    made_for_it = getattr(scene.module, "ALONE", ())
    return tuple(sorted(q for q in facts if not facts[q]["alone"] or q in made_for_it))


def shown(scene: LoadedScene, method: str) -> str:
    """Return the name of a method with the class of a scene: ``c0-tau`` for ``ck-tau``.

    The generic name where the scene has another method of that name: ``hb-ck`` beside the
    ``hb-c1`` of the paper.
    """
    name = method.replace(CLASS, f"c{scene.k}")
    return method if name in methods(scene) else name


def generic(scene: LoadedScene, name: str) -> str:
    """Return the generic name of a method that may be spelled with the class of a scene."""
    name = name.replace("_", "-")
    if name in methods(scene):
        return name
    return "-".join(CLASS if part == f"c{scene.k}" else part for part in name.split("-"))


def with_class_one(method: str) -> str:
    """Return the name of a method whose functions are C^1 though the scene is smoother."""
    return method.replace(CLASS, CLASS_ONE)


def without_class(method: str) -> str:
    """Return the generic name of a method that may be one with functions of class C^1.

    Examples
    --------
    >>> without_class(with_class_one("ck-tau")), without_class("hb-c1")
    ('ck-tau', 'hb-c1')
    """
    return method if method in METHODS else method.replace(CLASS_ONE, CLASS)
