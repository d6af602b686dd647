"""What an expansion says of itself beside its conditions: for tables, fits and pictures."""

from dataclasses import dataclass


@dataclass(frozen=True)
class About:
    """Facts about an expansion; a file of ``expansions/`` without them has these.

    Parameters
    ----------
    place : int
        Where it stands when all are told, the lowest first.
    power : bool
        Whether its errors fall as a power of the order; else by a factor with each order.
    first : bool
        Whether the orbits of all others start from its times and are judged by it; of one.
    colour, marker, line : str, str, str or tuple
        Of its curve in pictures, as matplotlib has them; filled or not.
    filled : bool
        Whether the marker is filled.
    """

    place: int = 99
    power: bool = False
    first: bool = False
    colour: str = "0.5"
    marker: str = "x"
    line: str | tuple[int, tuple[float, ...]] = "--"
    filled: bool = True
