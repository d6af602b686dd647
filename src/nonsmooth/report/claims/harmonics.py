"""What the paper claims of classical harmonic balance (Section 3.1)."""

from ..checks import fourier
from ..finding import Claim, Part

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
