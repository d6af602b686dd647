"""The page of the report: the results put into the template, with the pictures."""

from collections.abc import Iterator, Mapping
from typing import Any

from nonsmooth.codegen.equations import sections
from nonsmooth.codegen.printing.html import fragment_of
from nonsmooth.kim_perkins import METHODS, SCENE
from nonsmooth.solver.kernels import registry

from .captions import PLATES, flags, other_tests, reading
from .case import DEFAULT, MOST, Case
from .claims import CLAIMS, GROUPS, VERDICTS
from .figures import FLOOR
from .html import filled, folded, inline
from .intervals import FIRST, LAST, SCANNED, Intervals, force, in_words
from .words import number, percent

#: Orders in the table of errors.
ORDERS = (3, 10, 40)


def check(case: Case, intervals: Intervals) -> Iterator[dict[str, Any]]:
    """Yield every claim with its number, the verdict for this case, and its parts.

    With each part come its finding, and in words the normal forces for which it holds.
    """
    for place, claim in enumerate(CLAIMS, 1):
        findings = [part.of(case) for part in claim.parts]
        where = [in_words(case.belt, intervals[part]) for part in claim.parts]
        parts = list(zip(claim.parts, findings, where, strict=True))
        verdict = claim.verdict([finding.holds for finding in findings])
        yield {"number": place, "claim": claim, "verdict": verdict, "parts": parts}


def _errors(case: Case, method: str, order: int) -> tuple[str, str]:
    """Return the errors of the period and of (22) in percent, or "rounding"."""
    if not case.has(method, order):
        return "no orbit", ""
    error = case.measured("acceleration", method, order)
    shown = percent(error) if error > FLOOR else "rounding"
    period = case.measured("period", method, order)
    return percent(period) if period else "rounding", shown


def page(case: Case, intervals: Intervals, pictures: Mapping[str, str]) -> str:
    """Return the page as self-contained HTML.

    Parameters
    ----------
    case : Case
        The oscillator.
    intervals : dict
        The intervals of alpha in which each part of the claims holds.
    pictures : dict of str to str
        SVG by name.
    """
    belt, checked = case.belt, [*check(case, intervals)]
    shown = {name: words for plate in PLATES for name, words in plate.pictures.items()}
    shown["claims"] = f"For which normal forces each of the {len(CLAIMS)} claims holds."
    return filled(
        "page.html.jinja",
        belt=belt,
        alpha=number(belt.alpha),
        default=belt == DEFAULT,
        flags=flags(belt),
        period=number(case.exact.period, 6),
        orders=ORDERS,
        most=MOST,
        methods=METHODS,
        errors={m: [_errors(case, m, N) for N in ORDERS] for m in METHODS},
        reading=reading(case, MOST),
        case=case,
        plates=PLATES,
        svg={name: inline(pictures[name], name, words) for name, words in shown.items()},
        other_tests=other_tests(case),
        groups={
            heading: [row for row in checked if row["claim"] in claims]
            for heading, claims in GROUPS.items()
        },
        tally={name: [row for row in checked if row["verdict"] == name] for name in VERDICTS},
        count=len(checked),
        scanned=SCANNED,
        forces=[f"{force(belt, alpha):.4g}" for alpha in (FIRST, LAST)],
        inside=FIRST <= belt.alpha <= LAST,
        alphas=(f"{FIRST:g}", f"{LAST:g}"),
        equations=folded(fragment_of(sections(SCENE, METHODS))),
        hashes={method: registry.mathematics(belt.scene, [method]) for method in METHODS},
    )
