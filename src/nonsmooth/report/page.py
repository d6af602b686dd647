"""The page: what was computed, put into the template, with the pictures inside."""

import re
from collections.abc import Mapping
from dataclasses import dataclass
from importlib.metadata import version

from jinja2 import Environment, PackageLoader, StrictUndefined
from markupsafe import Markup, escape

from nonsmooth.codegen.printing.html import STYLE, mathml
from nonsmooth.codegen.shortcuts.document import equations_html
from nonsmooth.solver.shortcuts.orbit.methods import METHODS
from nonsmooth.solver.shortcuts.orbit.motion import exact
from nonsmooth.solver.shortcuts.orbit.oscillator import DEFAULT, StickSlip
from nonsmooth.solver.shortcuts.search.kernels import module
from nonsmooth.style import FLOOR

from .captions import PLATES, Plate, flags
from .case import MOST, Case
from .claims import CLAIMS, GROUPS
from .claims.quotations import QUOTATIONS, Quotation
from .finding import VERDICTS, Claim, verdict
from .intervals import FIRST, LAST, SCANNED, Intervals, force, in_words
from .ours import remark, space_heads, space_rows
from .reading import reading
from .words import number, percent, signed

#: Modules of the mathematics that the page rests on, and the orders in its table.
GENERATED, ORDERS = ("hb", "hb-c1", "c1"), (3, 10, 40)

#: (21) and (22), which nothing derives: they are definitions.
MEASURES = {
    "21": ("norm over a period", r"\lVert f \rVert = \sqrt{\int_0^T f^2(t)\, dt}"),
    "22": (
        "error of the acceleration",
        r"\varepsilon = \frac{\lVert \ddot{x}_{\mathrm{exact}}"
        r" - \ddot{x}_{\mathrm{approx.}} \rVert}"
        r"{\lVert \ddot{x}_{\mathrm{exact}} \rVert}",
    ),
}


@dataclass(frozen=True)
class Checked:
    """A claim with what was found.

    Parameters
    ----------
    number : int
    claim : Claim
    quotation : Quotation
        What the paper says, in its words.
    verdict : str
    parts : list of dict
        The words of each part, its finding, and the forces for which it holds.
    """

    number: int
    claim: Claim
    quotation: Quotation
    verdict: str
    parts: list[dict[str, object]]


def check(case: Case, intervals: Intervals) -> list[Checked]:
    """Return every claim with its verdict for this case."""
    checked = []
    for place, claim in enumerate(CLAIMS, 1):
        findings = tuple(part.of(case) for part in claim.parts)
        parts: list[dict[str, object]] = [
            {
                "words": part.words,
                "ours": part.ours,
                "counts": part.counts,
                "holds": finding.holds,
                "numbers": finding.numbers,
                "where": in_words(case.belt, intervals[part]),
            }
            for part, finding in zip(claim.parts, findings, strict=True)
        ]
        quotation = QUOTATIONS[claim.name]
        checked.append(Checked(place, claim, quotation, verdict(claim, findings), parts))
    return checked


def inline(svg: str, name: str, words: str) -> str:
    """Return a picture as an element of the page: no prologue, and names of its own.

    Parameters
    ----------
    svg : str
        A picture as matplotlib writes it.
    name : str
        What its names begin with, so that no two on the page are the same.
    words : str
        What it shows.
    """
    body = svg[svg.index("<svg") :]
    body = re.sub(
        r"<metadata>.*?</metadata>|<style.*?</style>|<!--.*?-->", "", body, flags=re.S
    )
    body = re.sub(r'\bid="', f'id="{name}-', body)
    body = re.sub(r'(?:xlink:)?href="#', f'href="#{name}-', body)
    body = body.replace("url(#", f"url(#{name}-")
    box = re.search(r'viewBox="[^"]*"', body)
    head = f'<svg {box[0] if box else ""} role="img" aria-label="{escape(words)}">'
    return head + re.sub(r">\s+<", "><", body[body.index(">") + 1 :].strip())


def _equations() -> str:
    """Return all equations of the paper: those that are derived, and the two measures."""
    derived = equations_html(tuple(METHODS))
    measures = "".join(
        f'<figure class="equation" id="eq-{n}"><figcaption>{words}</figcaption>'
        f'<div class="sides"><div class="side">{mathml(latex)}</div></div>'
        f'<a class="number" href="#eq-{n}">({n})</a></figure>'
        for n, (words, latex) in MEASURES.items()
    )
    return folded(f"{derived}<h2>Section 4: Measure of the error</h2>{measures}")


def folded(equations: str) -> str:
    """Return equations as a part of a page: lower headings, Jacobians folded away."""
    text = re.sub(r' xmlns="[^"]*"', "", equations)
    folded = re.sub(
        r"<h2>(Jacobian .*?)</h2>(.*?)(?=<h2>|$)",
        r"<details><summary>\1</summary>\2</details>",
        text,
        flags=re.DOTALL,
    )
    return re.sub(r"(</?)h2", r"\1h3", folded)


def _visible_error(case: Case, method: str, order: int) -> str:
    """Return (22) in percent; below its floor it is rounding."""
    error = case.acceleration_error(method, order)
    return percent(error) if error > FLOOR else "rounding"


def prose(words: str) -> Markup:
    r"""Return text as HTML: subscripts after underscores, no break before units or at "=".

    Examples
    --------
    >>> prose("μ_k F_N < 3 N's")
    Markup('μ<sub>k</sub> F<sub>N</sub> &lt; 3\xa0N’s')
    """
    text = str(escape(words.replace("'", "’")))
    text = re.sub(r"(?<=\d) (?=(%|[Nsm]|kg|m/s²?|N/m)(?!\w))| (?==)|(?<==) ", "\xa0", text)
    return Markup(re.sub(r"(\w)_(\w+)", r"\1<sub>\2</sub>", text))


def _table(case: Case) -> list[dict[str, object]]:
    """Return the three methods and their errors at a few orders."""
    rows: list[dict[str, object]] = []
    for name, method in METHODS.items():
        errors = [
            (percent(case.period_error(name, N)), _visible_error(case, name, N))
            if case.has(name, N)
            else ("no orbit", "")
            for N in ORDERS
        ]
        rows.append({"name": name, "method": method, "errors": errors})
    return rows


def _parameters(belt: StickSlip) -> str:
    return signed(
        f"M = {belt.mass:g} kg, K = {belt.stiffness:g} N/m, V = {belt.belt_speed:g} m/s, "
        f"μ_s = {belt.mu_s:g}, μ_k = {belt.mu_k:g}, F_N = {belt.normal_force:g} N"
    )


def _plates(case: Case, pictures: Mapping[str, str]) -> list[dict[str, object]]:
    def shown(plate: Plate) -> list[tuple[str, str]]:
        return [(n, inline(pictures[n], n, words)) for n, words in plate.pictures.items()]

    return [
        {
            "title": plate.title,
            "name": next(iter(plate.pictures))[:5],
            "pictures": shown(plate),
            "see": plate.text(case),
            "command": plate.command(case.belt),
        }
        for plate in PLATES
    ]


def page(case: Case, intervals: Intervals, pictures: Mapping[str, str]) -> str:
    """Return the page as HTML that needs nothing from outside.

    Parameters
    ----------
    case : Case
        The oscillator.
    intervals : dict
        Where each part of each claim holds.
    pictures : dict of str to str
        SVG by name.
    """
    belt = case.belt
    checked = check(case, intervals)
    groups, rest = {}, iter(checked)
    for heading, claims in GROUPS.items():
        groups[heading] = [next(rest) for _ in claims]
    environment = Environment(
        loader=PackageLoader("nonsmooth.report", "."),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    environment.filters["prose"] = prose
    words = f"For which normal forces each of the {len(CLAIMS)} claims holds."
    return environment.get_template("page.html.jinja").render(
        version=version("nonsmooth"),
        parameters=_parameters(belt),
        alpha=number(belt.alpha),
        default=belt == DEFAULT,
        flags=flags(belt),
        period=number(exact(belt).period, 6),
        orders=ORDERS,
        most=MOST,
        table=_table(case),
        reading=reading(case, MOST),
        plates=_plates(case, pictures),
        ours=remark(case),
        groups=groups,
        tally=[(name, [c for c in checked if c.verdict == name]) for name in VERDICTS],
        count=len(checked),
        scanned=SCANNED,
        forces=tuple(f"{force(belt, alpha):.4g}" for alpha in (FIRST, LAST)),
        inside=FIRST <= belt.alpha <= LAST,
        alphas=(f"{FIRST:g}", f"{LAST:g}"),
        map=inline(pictures["claims"], "claims", words),
        space=space_rows(),
        space_heads=space_heads(),
        equations=_equations(),
        equation_style=STYLE,
        hashes={name: module(name).MATHEMATICS[:16] for name in GENERATED},
    )
