"""What methods are called where people read them: with the class of the scene."""

from .numbers import SceneNumbers

#: Stands for the class in the generic name of a method.
CLASS = "ck"


def shown(scene: SceneNumbers, method: str) -> str:
    """Return the name of a method with the class of a scene: ``c0-tau`` for ``ck-tau``."""
    return method.replace(CLASS, f"c{scene.k}")


def generic(scene: SceneNumbers, name: str) -> str:
    """Return the generic name of a method that may be spelled with the class of a scene."""
    parts = name.replace("_", "-").split("-")
    return "-".join(CLASS if part == f"c{scene.k}" else part for part in parts)
