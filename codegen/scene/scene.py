"""A scene: an oscillator as data, checked when it is made."""

from dataclasses import dataclass

from .check import check
from .data import SceneData


@dataclass(frozen=True)
class Scene(SceneData):
    """An oscillator: its parameters, the phases of its motion in their order, its forcing.

    Parameters
    ----------
    name, title : str
        ``"impact"``, of lower-case letters, digits and dashes; and what it is in a few words.
    parameters : tuple of Parameter
        All symbols of the equations.
    phases : tuple of Phase
        One cell of the motion, from the first switch.  After the last comes the first again.
    source : str
        Where the model is from.
    frequency : Symbol, optional
        Angular frequency of the forcing; without it the oscillator is autonomous.
    half_period : bool
        The cell is half a period, and ``x(t + T/2) = -x(t)``.
    requires : mapping of str to Expr
        What must not be negative of the parameters, by the words that say so.
    scales : mapping of str to Expr
        ``"mass"``, ``"time"`` and ``"length"`` that make the equations dimensionless, in the
        parameters or as numbers in SI units; what is left out is worked out.
    guess : tuple of Expr
        Rough durations of the phases, in the parameters; without it they are worked out.
        Of several motions, a mapping from some of their names to such tuples.
    motions : mapping of str to tuple of Phase
        Several orders of phases, by name, in place of `phases`; any of them may occur.
    memory : tuple of Memory
        Constants that switches set.
    start : mapping of Symbol to Expr
        ``{x: ...}`` or ``{v: ...}``: what the state in which the first phase begins is on the
        exact orbit, if that is known.  Functions that begin at switches impose it in place of
        the event that ends the first phase, as the paper does in (9).
    extremes : mapping of str to mapping of Symbol to Expr
        Where digits are easily lost, by words: the parameters that differ there from those of
        a case, in its parameters or as numbers in SI units.  ``nonsmooth digits`` goes there.
    motion : str
        Which of several motions these `phases` are; see `of_motion`.
    body : Body, optional
        What moves, if it is not one mass: the equations of the phases are then the laws of
        its contact.

    Raises
    ------
    SceneError
        Naming the field that is wrong, what was found and what was expected.
    """

    def __post_init__(self) -> None:
        check(self)
