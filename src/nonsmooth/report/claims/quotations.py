"""The paper's own words for each claim: short quotations from Kim and Perkins (2003).

Left out at the ends, nothing within; C¹ stands for the paper's blackboard letter.
"""

from dataclasses import dataclass


@dataclass(frozen=True)
class Quotation:
    """Some words of the paper, at most a sentence.

    Parameters
    ----------
    section : str
        Where they stand.
    words : str
        As they stand there.
    """

    section: str
    words: str


#: By the name of the claim.
QUOTATIONS: dict[str, Quotation] = {
    "smoothness": Quotation(
        "Section 2",
        "the displacement is continuous and smooth, the velocity is continuous but not "
        "smooth, and consequently the acceleration is discontinuous",
    ),
    "friction": Quotation(
        "Section 2",
        "Since the speed of the particle remains less than or equal to V during the limit "
        "cycle, the friction force always acts in the direction of the belt velocity.",
    ),
    "centre": Quotation(
        "Section 2", "The particle oscillates about the position x_s = μ_k F_N / K"
    ),
    "mean-square": Quotation(
        "Section 4",
        "the series expansion converges to the exact solution (solid curve) in the mean "
        "square sense",
    ),
    "not-pointwise": Quotation(
        "Section 1",
        "the harmonic balance series for the acceleration will only converge in a mean square "
        "sense to the exact solution and not pointwise",
    ),
    "gibbs": Quotation(
        "Section 4",
        "shows the expected oscillatory behavior (Gibbs phenomenon) near the discontinuity",
    ),
    "mean-of-the-jump": Quotation(
        "Section 4",
        "converges to the arithmetic mean of the values on either side of the discontinuity as "
        "required",
    ),
    "slow-period": Quotation(
        "Section 4", "The classical harmonic balance series exhibits very slow convergence."
    ),
    "monotone-hb": Quotation(
        "Section 4", "slowly decreases monotonically with increasing expansion size"
    ),
    "g1": Quotation(
        "Section 3.2", "this function is periodic and C¹ as defined by the conditions"
    ),
    "one-function-period": Quotation(
        "Section 4",
        "The addition of a single C¹ function dramatically improves the convergence rate.",
    ),
    "one-function-gibbs": Quotation(
        "Section 4",
        "the Gibbs phenomenon present in the classical harmonic balance solution is entirely "
        "eliminated upon the addition of a single C¹ term",
    ),
    "one-function-pointwise": Quotation(
        "Section 4",
        "both of these two latter series converge pointwise to the exact acceleration",
    ),
    "one-function-acceleration": Quotation(
        "Section 4", "decreases at a significantly greater rate (note log scale)"
    ),
    "one-function-rises": Quotation(
        "Section 4",
        "decreases at a significantly greater rate (note log scale) although not monotonically",
    ),
    "dependence": Quotation(
        "Section 4",
        "It is speculated that the non-monotonic behavior may occur because g₁(t) may not be "
        "linearly independent of the Fourier series components of the expansion.",
    ),
    "stick-exact": Quotation("Section 3.3", "for t < t₁, ẍ = 0 and stick is captured exactly"),
    "overtakes": Quotation(
        "Section 4",
        "The expansion in purely C¹ functions ultimately leads to even swifter convergence "
        "beyond N = 3.",
    ),
    "band": Quotation(
        "Section 4",
        "beyond N = 3 where it also remains within ±0.1 % of the exact period",
    ),
    "monotone-c1": Quotation(
        "Section 4",
        "the estimated period using the new C¹ series exhibits monotonic convergence beyond "
        "N = 3",
    ),
    "poorest": Quotation(
        "Section 4",
        "The classical harmonic balance solution (dash-dot curve) is relatively poor compared "
        "to the other approximations.",
    ),
    "c1-gibbs": Quotation(
        "Section 4",
        "entirely eliminated upon the addition of a single C¹ term (dashed curve) (as well as "
        "in the new C¹ series (dotted curve))",
    ),
    "c1-pointwise": Quotation(
        "Abstract",
        "This expansion converges pointwise to the exact solution and to all derivatives "
        "thereof.",
    ),
    "swiftest": Quotation(
        "Section 4",
        "the new C¹ series produces the swiftest convergence rate",
    ),
    "stairs": Quotation(
        "Section 4",
        "the even-order terms (N = 2, 4, …) are not expected to contribute to the "
        "antisymmetric acceleration response",
    ),
}
