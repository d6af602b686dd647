"""What a sweep over a parameter of the paper's oscillator has to say of it."""

from ...values.vary import Vary
from ...values.vary import parse_vary as parse
from ..parameters import FLAGS

#: Points of a sweep: days of computing, and a hundred gigabytes.
MOST_POINTS = 1_000_000_000

#: The paper's symbols.
SYMBOLS = {
    "mass": "M",
    "stiffness": "K",
    "belt_speed": "V",
    "mu_s": "mu_s",
    "mu_k": "mu_k",
    "normal_force": "F_N",
}

#: What a parameter changes beside alpha: a scale, or a place.
SCALES = {
    "mass": "the units of time and length",
    "stiffness": "the units of time and length",
    "belt_speed": "the unit of length",
    "mu_s": "",
    "mu_k": "the place x_s of slip",
    "normal_force": "the place x_s of slip",
}


def parse_vary(text: str, log: bool) -> Vary:
    """Return what ``--vary`` asks for.

    Examples
    --------
    >>> parse_vary("belt-speed=0.1:10:3", log=True).values(0, 3)
    array([ 0.1,  1. , 10. ])

    Raises
    ------
    Problem
        If `text` is not of this form, or its numbers make no range.
    """
    return parse(text, log, tuple(FLAGS), MOST_POINTS, "belt-speed=0.1:10:200")
