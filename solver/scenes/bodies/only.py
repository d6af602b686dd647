"""What is computed for scenes of one mass alone."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from ..loaded import LoadedScene


class NotOfBodies(ValueError):  # noqa: N818  (named like the other errors of the package)
    """Something that is not computed for bodies of several degrees of freedom."""


def check_one_mass(scene: "LoadedScene", what: str) -> None:
    """Check that a scene is of one mass.

    Parameters
    ----------
    scene : LoadedScene
    what : str
        What is asked for.

    Raises
    ------
    NotOfBodies
        If it is of a body; with what there is for it.
    """
    if scene.has_body:
        raise NotOfBodies(
            f"{what}: not of {scene.name}, a body of several degrees of freedom; for bodies "
            "there are solve, sweep, tradeoff, branch, map, simulate, report, equations, scenes"
        )
