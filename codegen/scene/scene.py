"""A scene: an oscillator as data, checked when it is made."""

from dataclasses import dataclass

from .checks.whole import check
from .data import SceneData


@dataclass(frozen=True)
class Scene(SceneData):
    """An oscillator: its parameters, the phases of its motion in order, its forcing.

    Parameters
    ----------
    name, title : str
        Name of lower-case letters, digits and dashes; description in a few words.
    parameters : tuple of Parameter
        All symbols of the equations.
    phases : tuple of Phase
        One cell of the motion, from the first switch.  The last is followed by the first.
    source : str
        Reference for the model.
    frequency : Symbol, optional
        Angular frequency of the forcing; without it the oscillator is autonomous.
    half_period : bool
        Whether the cell is half a period, and ``x(t + T/2) = -x(t)``.
    requires : mapping of str to Expr
        Expressions in the parameters that must not be negative, by words.
    scales : mapping of str to Expr
        ``"mass"``, ``"time"`` and ``"length"`` that make the equations dimensionless, in the
        parameters or as numbers in SI units; those left out are worked out.
    guess : tuple of Expr
        Rough durations of the phases, in the parameters; without it they are worked out.
        For several motions, a mapping from some of their names to such tuples.
    motions : mapping of str to tuple of Phase
        Several orders of phases, by name, in place of `phases`; any of them may occur.
    memory : tuple of Memory
        Constants that switches set.
    start : mapping of Symbol to Expr
        ``{x: ...}`` or ``{v: ...}``: the state in which the first phase of the exact orbit
        begins, if that is known.  Functions that begin at switches impose it in place of the
        event that ends the first phase, as the paper does in (9).
    extremes : mapping of str to mapping of Symbol to Expr
        Cases in which digits are easily lost, by words: the parameters that differ from those
        of a given case, in its parameters or as numbers in SI units.  ``nonsmooth digits``
        measures there.
    motion : str
        Which of several motions these `phases` are; see `of_motion`.
    body : Body, optional
        The body that moves, if it is not one mass; the equations of the phases are then the
        laws of its contacts.

    Raises
    ------
    SceneError
        Naming the field that is wrong, what was found and what was expected.
    """

    def __post_init__(self) -> None:
        check(self)
