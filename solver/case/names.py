"""What methods are called where people read them: with the class of the scene."""

from .numbers import SceneNumbers

#: Stands for the class C^k in the generic name of a method.
CLASS = "ck"

#: What stands there of functions of class C^1, where the scene is smoother.
CLASS_ONE = CLASS.replace("k", "1")


def shown(scene: SceneNumbers, method: str) -> str:
    """Return the name of a method with the class of a scene: ``c0-tau`` for ``ck-tau``."""
    return method.replace(CLASS, f"c{scene.k}")


def generic(scene: SceneNumbers, name: str) -> str:
    """Return the generic name of a method that may be spelled with the class of a scene."""
    parts = name.replace("_", "-").split("-")
    return "-".join(CLASS if part == f"c{scene.k}" else part for part in parts)


def with_class_one(method: str) -> str:
    """Return the name of a method whose functions are C^1 though the scene is smoother."""
    return method.replace(CLASS, CLASS_ONE)


def without_class(method: str) -> str:
    """Return the generic name of a method that may be one with functions of class C^1.

    Examples
    --------
    >>> without_class(with_class_one("ck-tau")), without_class("hb")
    ('ck-tau', 'hb')
    """
    return method.replace(CLASS_ONE, CLASS)
