"""The paper's own words beside each claim, and the thresholds that are not the paper's."""

import re

import numpy as np
import pytest
from computed import case
from fakes import Fake

from nonsmooth.report.checks import c1, fourier
from nonsmooth.report.checks import orbit as motion
from nonsmooth.report.claims import CLAIMS
from nonsmooth.report.claims.quotations import QUOTATIONS
from nonsmooth.shortcuts import printed
from nonsmooth.solver.scaling import equilibrated
from nonsmooth.solver.shortcuts.orbit.oscillator import DEFAULT
from nonsmooth.solver.shortcuts.search import kernels

#: Sentences of Kim and Perkins (2003) by section, copied from the paper and not from the page;
#: marks of the figures are left out, and "..." where a sentence goes on.
SENTENCES = {
    "Abstract": (
        "This expansion converges pointwise to the exact solution and to all derivatives "
        "thereof.",
    ),
    "Section 1": (
        "Moreover, the harmonic balance series for the acceleration will only converge in a "
        "mean square sense to the exact solution and not pointwise.",
    ),
    "Section 2": (
        "The particle oscillates about the position x_s = μ_k F_N / K with period T as shown "
        "in Fig. 2(b).",
        "Since the speed of the particle remains less than or equal to V during the limit "
        "cycle, the friction force always acts in the direction of the belt velocity.",
        "Note that the displacement is continuous and smooth, the velocity is continuous but "
        "not smooth, and consequently the acceleration is discontinuous.",
    ),
    "Section 3.2": (
        "Note that this function is periodic and C¹ as defined by the conditions ...",
    ),
    "Section 3.3": ("Note that for t < t₁, ẍ = 0 and stick is captured exactly.",),
    "Section 4": (
        "The approximate solution for N = 40 (dashed curve) shows the expected oscillatory "
        "behavior (Gibbs phenomenon) near the discontinuity and converges to the arithmetic "
        "mean of the values on either side of the discontinuity as required.",
        "Hence, the series expansion converges to the exact solution (solid curve) in the mean "
        "square sense (L2 norm).",
        "The classical harmonic balance series exhibits very slow convergence.",
        "The addition of a single C¹ function dramatically improves the convergence rate.",
        "The expansion in purely C¹ functions ultimately leads to even swifter convergence "
        "beyond N = 3.",
        "Moreover, the estimated period using the new C¹ series exhibits monotonic convergence "
        "beyond N = 3 where it also remains within ±0.1 % of the exact period.",
        "The classical harmonic balance solution (dash-dot curve) is relatively poor compared "
        "to the other approximations.",
        "Note that the Gibbs phenomenon present in the classical harmonic balance solution is "
        "entirely eliminated upon the addition of a single C¹ term (dashed curve) (as well as "
        "in the new C¹ series (dotted curve)).",
        "Moreover, both of these two latter series converge pointwise to the exact "
        "acceleration, whereas the classical harmonic balance solution converges only in the "
        "mean square sense.",
        "This error measure for the acceleration using the classical harmonic balance slowly "
        "decreases monotonically with increasing expansion size.",
        "However, the error for the classical harmonic balance augmented with one C¹ term "
        "decreases at a significantly greater rate (note log scale) although not "
        "monotonically.",
        "It is speculated that the non-monotonic behavior may occur because g₁(t) may not be "
        "linearly independent of the Fourier series components of the expansion.",
        "This is expected since the even-order terms (N = 2, 4, …) are not expected to "
        "contribute to the antisymmetric acceleration response.",
        "Moreover, the new C¹ series produces the swiftest convergence rate since all terms in "
        "the series are in the same function space as the exact solution.",
    ),
}

PARTS = {part.check: part for claim in CLAIMS for part in claim.parts}


def test_every_claim_is_quoted_from_the_paper_with_its_section() -> None:
    assert list(QUOTATIONS) == [claim.name for claim in CLAIMS]
    for claim in CLAIMS:
        quotation = QUOTATIONS[claim.name]
        assert len(quotation.words) > 30
        assert any(quotation.words in known for known in SENTENCES[quotation.section])
        number = quotation.section.removeprefix("Section ")
        assert number in claim.where, claim.name


def test_no_sentence_stands_unused() -> None:
    words = [(quotation.section, quotation.words) for quotation in QUOTATIONS.values()]
    for section, sentences in SENTENCES.items():
        for known in sentences:
            assert any(there == section and said in known for there, said in words), known


def ours(check) -> list[float]:
    """Return the numbers of a threshold that is ours."""
    return [float(text) for text in re.findall(r"\d+(?:\.\d+)?", PARTS[check].ours)]


@pytest.mark.parametrize(
    ("check", "scale", "measured"),
    [
        (fourier.not_uniform, 100, lambda x: {"largest": {"hb": lambda N: x}}),
        (fourier.mean_square, 1, lambda x: {"acceleration": {"hb": lambda N: N**-x}}),
        (
            fourier.uniform,
            1,
            lambda x: {"largest": {"hb-c1": lambda N: x ** np.log2(N / 10)}},
        ),
        (c1.no_ripple, 100, lambda x: {"largest": {"c1": lambda N: x}}),
        (
            fourier.no_ripple_at_3,
            100,
            lambda x: {"overshoot": dict.fromkeys(("hb", "hb-c1"), lambda N: x)},
        ),
        (
            fourier.ripple_vanishes,
            100,
            lambda x: {"overshoot": {"hb": lambda N: 0.5, "hb-c1": lambda N: x}},
        ),
    ],
    ids=lambda value: getattr(value, "__name__", ""),
)
def test_a_threshold_is_where_it_is_said_to_be(check, scale: float, measured) -> None:
    said = ours(check)[0] / scale
    below, above = (check(Fake(**measured(said * factor))).holds for factor in (0.99, 1.01))
    assert below != above


def test_thresholds_that_are_ours_are_not_those_of_the_paper() -> None:
    papers = {c1.in_band_beyond_three, fourier.visible}  # 0.1 %: Section 4
    assert all(not PARTS[check].ours for check in papers)
    numbers = re.compile(r"\d+ %|factor|exponent|half|third|fifth|up to 20|N⁻")
    for check, part in PARTS.items():
        if numbers.search(part.words) and "0.1 %" not in part.words:
            assert part.ours, check
    assert sum(bool(part.ours) for part in PARTS.values()) == 21


def test_what_is_left_of_g1_and_what_its_jacobian_loses() -> None:
    (claim,) = (claim for claim in CLAIMS if claim.name == "dependence")
    left, printed_, scaled, solved = re.search(
        r"leave (\S+) % .* number (\S+), or (\S+) once .* number is (\d+),", claim.note
    ).groups()  # type: ignore[union-attr]
    assert motion.in_span_of_harmonics(case()).numbers.startswith(f"{left}12 % of g₁")
    orbit = case().orbit("hb-c1", 40)
    J = np.empty((len(orbit.unknowns),) * 2)
    kernels.compiled("hb-c1").jacobian(DEFAULT.alpha, orbit.unknowns, J)
    assert f"{np.linalg.cond(equilibrated(J)):.0f}" == solved
    _, J = printed.solve("hb-c1", 40, DEFAULT, (orbit.t1, orbit.period))
    raised = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹", "0123456789")
    for text, found in (
        (printed_, np.linalg.cond(J)),
        (scaled, np.linalg.cond(equilibrated(J))),
    ):
        head, _, power = text.partition("×10")
        assert f"{found:.0e}" == f"{head}e+{int(power.translate(raised)):02d}"
