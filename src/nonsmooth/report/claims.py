"""What the paper claims, claim by claim, with the checks that decide each."""

from . import checks_c1 as c1
from . import checks_fourier as fourier
from . import checks_orbit as orbit
from .finding import Claim, Part

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

HB = (
    Claim(
        "mean-square",
        "Convergence in the mean square",
        "The acceleration of classical harmonic balance converges in the mean square.",
        "Sections 1, 3.1 and 4, Fig. 3",
        (
            Part(
                "the error (22) falls at least like N⁻⁰·⁴ from N = 10 to 20 and to 40",
                fourier.mean_square,
                ours="an exponent of at least 0.4",
            ),
        ),
    ),
    Claim(
        "not-pointwise",
        "No pointwise convergence",
        "It does not converge pointwise: near the jumps its error is of order 1, whatever N.",
        "Sections 1, 3.2 and 4",
        (
            Part(
                "the largest error stays above 40 % of the jump",
                fourier.not_uniform,
                ours="40 % of the jump",
            ),
            Part(
                "in the middle half of stick and of slip it does not halve either, from N = 10 "
                "to 40",
                fourier.nowhere,
                counts=False,
                ours="half of the error at N = 10",
            ),
        ),
        note=(
            "At any instant off the jumps the error does go to zero, as that of a Fourier "
            "series does; it does not do so at the jumps, nor evenly beside them."
        ),
    ),
    Claim(
        "gibbs",
        "Gibbs’ phenomenon",
        "Beside the jumps the series oscillates: Gibbs' phenomenon.",
        "Sections 1 and 4, Fig. 3",
        (
            Part(
                "at N = 40 the ripple in stick is that of Gibbs' constant, to a third",
                fourier.gibbs,
                ours="a third of Gibbs' constant",
            ),
            Part(
                "it stays: at N = 40 it is more than half as high as at N = 20, and above 1 %",
                fourier.ripple_stays,
                ours="half of the height at N = 20, and 1 % of the jump",
            ),
        ),
    ),
    Claim(
        "mean-of-the-jump",
        "The mean at the jump",
        "At the jump the series takes the mean of the two sides.",
        "Section 4, Fig. 3",
        (
            Part(
                "half of the jump, to a fifth, where stick ends in the series",
                fourier.half_way_at_own_end,
                ours="40 to 60 % of the jump",
            ),
            Part(
                "and where stick ends in the exact orbit, on normalised time",
                fourier.half_way_at_exact_end,
                ours="40 to 60 % of the jump",
            ),
        ),
        note=(
            "Stick ends at a slightly wrong time in the series. That error falls like "
            "1/N, and so does the width of the ripple: measured in ripples, the wrong "
            "time stays as wrong."
        ),
    ),
    Claim(
        "slow-period",
        "A slow period",
        "The period of classical harmonic balance converges very slowly.",
        "Section 4, Fig. 4; abstract",
        (
            Part(
                "its error falls like 1/N, the exponent to 0.2",
                fourier.slow,
                ours="an exponent from 0.8 to 1.2",
            ),
            Part("to N = 40 it is outside ±0.1 %, so that Fig. 4 shows it", fourier.visible),
        ),
    ),
    Claim(
        "monotone-hb",
        "Slow and steady acceleration",
        "Its acceleration error (22) falls slowly, and at every order.",
        "Section 4, Fig. 6",
        (
            Part(
                "like the square root of 1/N, the exponent to 0.2",
                fourier.slow_acceleration,
                ours="an exponent from 0.3 to 0.7",
            ),
            Part("at every order from 2 to 40", fourier.monotone),
        ),
    ),
)

HB_C1 = (
    Claim(
        "g1",
        "g₁ is periodic and C¹",
        "The function g₁ of (12) is periodic and as smooth as the exact orbit.",
        "Section 3.2",
        (Part("g₁ and its derivative have no jump", orbit.g1_is_c1),),
    ),
    Claim(
        "one-function-period",
        "One C¹ function: period",
        "One C¹ function beside the harmonics improves the convergence of the period "
        "dramatically.",
        "Section 4, Fig. 4",
        (
            Part("its error is smaller at every order from 1 to 40", fourier.better_period),
            Part(
                "it falls by at least one more power of N",
                fourier.faster_period,
                ours="an exponent larger by 1",
            ),
        ),
    ),
    Claim(
        "one-function-gibbs",
        "One C¹ function: no Gibbs",
        "One C¹ function removes Gibbs' phenomenon entirely.",
        "Sections 4 and 5, Fig. 5",
        (
            Part(
                "at N = 40 the ripple in stick is below 1 % of the jump, where without g₁ it "
                "is above",
                fourier.ripple_vanishes,
                ours="1 % of the jump",
            ),
            Part(
                "it is below 1 % at N = 3 already, as in Fig. 5",
                fourier.no_ripple_at_3,
                ours="1 % of the jump",
            ),
        ),
    ),
    Claim(
        "one-function-pointwise",
        "One C¹ function: pointwise",
        "With it the acceleration converges pointwise.",
        "Sections 4 and 5, Fig. 5",
        (
            Part(
                "the largest error, each phase laid over the exact one, falls to 0.7 of itself "
                "or less each time N is doubled",
                fourier.uniform,
                ours="a factor of 0.7",
            ),
        ),
    ),
    Claim(
        "one-function-acceleration",
        "One C¹ function: acceleration",
        "Its error (22) falls much faster than without.",
        "Section 4, Fig. 6",
        (
            Part(
                "by at least another square root of N",
                fourier.faster_acceleration,
                ours="an exponent larger by 0.5",
            ),
        ),
    ),
    Claim(
        "one-function-rises",
        "One C¹ function: not steady",
        "It does not fall at every order.",
        "Section 4, Fig. 6",
        (Part("somewhere from N = 2 to 40 it rises", fourier.not_monotone),),
    ),
    Claim(
        "dependence",
        "g₁ depends on the harmonics",
        "The reason may be that g₁ depends linearly on the harmonics beside it (offered as "
        "a guess).",
        "Section 4, on Fig. 6",
        (
            Part(
                "g₁ is a sum of its first 40 harmonics",
                orbit.in_span_of_harmonics,
                ours="a part of 10⁻¹², which is rounding",
            ),
        ),
        note=(
            "g₁ is nearly dependent on the harmonics: not exactly, and that is not the cause. "
            "At α = 1 the first 40 leave 0.003 % of it, and with g₁ as printed the Jacobian "
            "for N = 40 has the condition number 3×10¹², or 5×10⁶ once its rows and columns "
            "are scaled. The program solves with what they leave in the place of g₁; in "
            "exact arithmetic the orbit is the same, the scaled condition number is 38, and "
            "the error rises all the same. nonsmooth digits measures it."
        ),
    ),
)

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
            Part("it does so for good at an order up to 20", c1.overtakes, ours="N = 20"),
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
                "it is smaller than with one C¹ function, for good from an order up to 20",
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

#: The headings under which the claims stand, in the order of the paper's methods.
GROUPS: dict[str, tuple[Claim, ...]] = {
    "The exact orbit (Section 2)": ORBIT,
    "Classical harmonic balance (Section 3.1)": HB,
    "One C¹ function beside the harmonics (Section 3.2)": HB_C1,
    "A series of C¹ functions (Section 3.3)": C1,
}

CLAIMS = tuple(claim for group in GROUPS.values() for claim in group)
