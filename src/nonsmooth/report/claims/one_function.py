"""What the paper claims of one C1 function beside the harmonics (Section 3.2)."""

from ..checks import fourier, orbit
from ..finding import Claim, Part

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
