"""What the paper claims of a series of C1 functions (Section 3.3)."""

from ..checks import c1
from ..finding import Claim, Part

C1 = (
    Claim(
        "stick-exact",
        "C¹ series: stick",
        "The C¹ series reproduces the stick phase exactly.",
        "Section 3.3",
        (
            Part(
                "its acceleration in stick is zero at the lowest order that has an orbit",
                c1.stick_is_exact,
            ),
        ),
    ),
    Claim(
        "overtakes",
        "C¹ series: overtakes",
        "Its period overtakes that of harmonics with one C¹ function, beyond N = 3.",
        "Section 4, Fig. 4",
        (
            Part("from some order up to 20 on it does", c1.overtakes, ours="N = 20"),
            Part("it is better at every order beyond 3", c1.beyond_three),
            Part("it is still behind at N = 3", c1.behind_at_three, counts=False),
        ),
    ),
    Claim(
        "band",
        "C¹ series: within 0.1 %",
        "Beyond N = 3 its period is within ±0.1 % of the exact one.",
        "Section 4, Fig. 4",
        (
            Part("at every order from 4 on", c1.in_band_beyond_three),
            Part("at every order from 3 on", c1.in_band_from_three, counts=False),
            Part(
                "at every order from 4 on, a solution counted whose stick ends too early",
                c1.in_band_with_any_solution,
                counts=False,
            ),
        ),
        note=(
            "The lower end depends on what counts as an orbit. Below it the solution at N "
            "= 4 ends stick more than an eighth of its travel short of the static limit, "
            "and the program rejects it; if it is counted the claim holds from a smaller "
            "force on, as the last line says."
        ),
    ),
    Claim(
        "monotone-c1",
        "C¹ series: monotone period",
        "Beyond N = 3 its period converges monotonically.",
        "Section 4, Fig. 4",
        (
            Part("the size of its error falls at every order from 4 on", c1.shrinks),
            Part("the period comes to the exact one from one side", c1.one_sided),
        ),
        note=(
            "The error changes sign every other order, so that the period itself goes up "
            "and down."
        ),
    ),
    Claim(
        "poorest",
        "N = 3: harmonics poorest",
        "At N = 3 classical harmonic balance is the poorest of the three.",
        "Section 4, Fig. 5",
        (Part("its error (22) is the largest", c1.poorest),),
    ),
    Claim(
        "c1-gibbs",
        "C¹ series: no Gibbs",
        "The C¹ series has no Gibbs' phenomenon.",
        "Section 4, Fig. 5",
        (
            Part(
                "its largest error is below 1 % of the jump at N = 10",
                c1.no_ripple,
                ours="1 % of the jump, at N = 10",
            ),
        ),
    ),
    Claim(
        "c1-pointwise",
        "C¹ series: pointwise",
        "It converges pointwise, and so do all its derivatives (checked up to the jerk).",
        "Abstract; Sections 4 and 5",
        (
            Part(
                "the largest errors of x, velocity, acceleration and jerk, phase on phase, "
                "fall tenfold or more from N = 9 to 12 and to 15",
                c1.all_derivatives,
                ours="a factor of 10 in three orders",
            ),
        ),
    ),
    Claim(
        "swiftest",
        "C¹ series: swiftest",
        "Its error (22) falls faster still, the fastest of the three.",
        "Section 4, Fig. 6",
        (
            Part(
                "it is smaller than with one C¹ function from some order up to 20 on",
                c1.overtakes_acceleration,
                ours="N = 20",
            ),
        ),
    ),
    Claim(
        "stairs",
        "C¹ series: stairs",
        "It goes down like stairs, as even orders add nothing to an odd function.",
        "Section 4, Fig. 6",
        (
            Part(
                "it falls by a factor above 2 at each odd order, below 2 at each even one",
                c1.stairs,
                ours="a factor of 2",
            ),
            Part("even orders change it by less than 1 %", c1.even_add_nothing, ours="1 %"),
        ),
        note=(
            "The test functions of (18) are not odd about mid-slip, and so the solution "
            "is not quite odd either: even orders do change it, mostly for the worse."
        ),
    ),
)
