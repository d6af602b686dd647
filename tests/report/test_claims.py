"""The table of the claims: the paper's own words, and the verdict on each of some cases."""

import re

import numpy as np
import pytest
from computed import ODD, Exact, case
from every_run import tried
from fakes import Fake

from nonsmooth.report.case import DEFAULT, at_alpha
from nonsmooth.report.checks import Finding
from nonsmooth.report.claims import CLAIMS, PARTS, Claim, Part
from nonsmooth.solver.kernels import registry
from nonsmooth.solver.scaling import equilibrated

CLAIM = {claim.name: claim for claim in CLAIMS}

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


def test_every_claim_is_quoted_from_the_paper_with_its_section() -> None:
    assert len(CLAIM) == len(CLAIMS) == 25
    for claim in CLAIMS:
        assert len(claim.quoted) > 30
        assert any(claim.quoted in known for known in SENTENCES[claim.source]), claim.name
        assert claim.source.removeprefix("Section ") in claim.where, claim.name


def test_no_sentence_stands_unused() -> None:
    for section, sentences in SENTENCES.items():
        for known in sentences:
            assert any(c.source == section and c.quoted in known for c in CLAIMS), known


def test_thresholds_that_are_ours_are_not_those_of_the_paper() -> None:
    numbers = re.compile(r"\d+ %|factor|exponent|half|third|fifth|up to 20|N⁻")
    for part in PARTS:
        papers = "0.1 %" in part.words or part.words.startswith("at every order from")
        assert not (papers and part.ours), part.words
        assert papers or part.ours or not numbers.search(part.words), part.words
    assert sum(bool(part.ours) for part in PARTS) == 21


#: What is not simply true, by alpha.
NOT_QUITE = {
    0.3: {
        "in part": "slow-period monotone-hb one-function-period one-function-gibbs overtakes "
        "stairs",
        "not": "dependence band monotone-c1 poorest",
    },
    1.0: {
        "in part": "mean-of-the-jump monotone-hb one-function-gibbs overtakes monotone-c1 "
        "stairs",
        "not": "dependence",
    },
    5.0: {
        "in part": "mean-of-the-jump slow-period one-function-gibbs monotone-c1 stairs",
        "not": "dependence",
    },
}

#: Statements of which something is told in SI units, or is rounding.
NOT_THE_SAME = {"smoothness", "friction", "centre", "c1-pointwise"}


@pytest.mark.parametrize("alpha", tried(NOT_QUITE, every_run=[1.0]))
def test_the_verdicts_are_those_of_alpha_in_any_units(alpha: float) -> None:
    one, other = (case(at_alpha(belt, alpha).belt) for belt in (DEFAULT, ODD))
    for claim in CLAIMS:
        found, same = ([part.of(each) for part in claim.parts] for each in (one, other))
        lists = NOT_QUITE[alpha]
        expected = "does not hold" if claim.name in lists["not"].split() else "holds"
        expected = "holds in part" if claim.name in lists["in part"].split() else expected
        assert claim.verdict([finding.holds for finding in found]) == expected, claim.name
        assert [finding.holds for finding in same] == [finding.holds for finding in found]
        assert found == same or claim.name in NOT_THE_SAME, claim.name


@pytest.mark.parametrize("belt", [DEFAULT, ODD], ids=["default", "odd"])
def test_what_has_a_unit_is_that_of_the_oscillator(belt) -> None:
    exact = Exact(belt)
    places = {"smoothness": (0, 4), "friction": (1, -2), "centre": (0, 2)}
    falls, least, centre = (
        float(CLAIM[name].parts[part].of(case(belt)).numbers.split()[word])
        for name, (part, word) in places.items()
    )
    lowest = belt.stiffness * (exact.centre - exact.reach)  # N: the spring in A
    assert (falls, centre) == pytest.approx((exact.jump, exact.centre), rel=5e-3)
    assert least == pytest.approx(lowest, rel=5e-3, abs=1e-12)


@pytest.mark.parametrize("alpha", tried([1e-6, 1.25e-3, 50.0, 1e6], every_run=[1e-6]))
def test_every_claim_is_decided_at_the_extremes(alpha: float) -> None:
    case = at_alpha(DEFAULT, alpha)
    assert all(part.of(case).numbers for part in PARTS)


def test_an_orbit_that_is_missing_counts_against_a_statement() -> None:
    found = CLAIM["poorest"].parts[0].of(Fake(missing=[("hb", 3)]))
    assert found == Finding(False, "hb has no orbit at N = 3")


def test_a_verdict_is_made_of_the_parts_that_count() -> None:
    def verdict(counts: tuple[bool, ...], holds: tuple[bool, ...]) -> str:
        parts = tuple(Part("", lambda case: Finding(True, ""), count) for count in counts)
        return Claim("", "", "", "", "", "", parts).verdict(holds)

    assert verdict((True, True), (True, True)) == "holds"
    assert verdict((True, True), (True, False)) == "holds in part"
    assert verdict((True, True), (False, False)) == "does not hold"
    assert verdict((True, False), (True, False)) == "holds"
    assert verdict((True, False), (False, True)) == "does not hold"


def test_what_is_left_of_g1_and_what_its_jacobian_loses() -> None:
    claim = CLAIM["dependence"]
    left, plain, scaled = re.search(
        r"leave (\S+) % .* number (\S+), or (\S+) once", claim.note
    ).groups()  # type: ignore[union-attr]
    assert claim.parts[0].of(case()).numbers.startswith(f"{left}12 % of g₁")
    orbit = case().orbit("hb-c1", 40)
    J = np.empty((len(orbit.unknowns),) * 2)
    kernel = registry.kernel(DEFAULT.scene, "hb-c1")
    kernel.jacobian(kernel.given(DEFAULT, 40), orbit.unknowns, J)
    raised = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹", "0123456789")
    for text, found in (
        (plain, np.linalg.cond(J)),
        (scaled, np.linalg.cond(equilibrated(J))),
    ):
        head, _, power = text.partition("×10")
        assert f"{found:.0e}" == f"{head}e+{int(power.translate(raised)):02d}"
