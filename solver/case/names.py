"""What methods are called where people read them: with the class of the scene."""

from collections.abc import Iterable

from .numbers import SceneNumbers

#: The methods in the order in which they are told; any other comes after them.
ORDER = ("hb", "hb-ck", "ck", "ck-tau")


def shown(scene: SceneNumbers, method: str) -> str:
    """Return the name of a method with the class of a scene: ``c0-tau`` for ``ck-tau``."""
    return method.replace("ck", f"c{scene.k}")


def in_order(methods: Iterable[str]) -> tuple[str, ...]:
    """Return methods in the order in which they are told.

    Examples
    --------
    >>> in_order(["ck", "other", "hb"])
    ('hb', 'ck', 'other')
    """
    return tuple(sorted(methods, key=lambda m: (ORDER.index(m) if m in ORDER else 99, m)))
