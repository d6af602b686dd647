"""What the paper claims of the exact orbit (Section 2)."""

from ..checks import orbit
from ..finding import Claim, Part

ORBIT = (
    Claim(
        "smoothness",
        "The exact orbit is C¹",
        "The exact orbit is C¹: displacement and velocity are continuous, the acceleration "
        "jumps where stick and slip meet.",
        "Section 2, Fig. 2",
        (Part("x and its derivative have no jump, the acceleration has two", orbit.smooth),),
    ),
    Claim(
        "friction",
        "Friction pulls with the belt",
        "The mass is never faster than the belt, and so friction always acts in the belt's "
        "direction.",
        "Section 2, Fig. 2",
        (
            Part("the velocity is at most V", orbit.never_faster),
            Part("friction is never negative, in stick either", orbit.friction_drives),
        ),
    ),
    Claim(
        "centre",
        "The orbit's centre",
        "The mass oscillates about x_s = μ_k F_N / K.",
        "Section 2, Fig. 2",
        (Part("x_s is the mean of x over a period", orbit.centred),),
    ),
)
