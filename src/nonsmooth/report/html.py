"""Parts of a page: templates, prose, pictures and equations as HTML."""

import re
from importlib.metadata import version
from typing import Any

from jinja2 import Environment, PackageLoader, StrictUndefined
from markupsafe import Markup, escape

from nonsmooth.codegen.printing.html import STYLE, mathml


def filled(name: str, **content: Any) -> str:
    """Return a self-contained page: the template of this name, filled with `content`.

    Content that is not marked safe is escaped.
    """
    environment = Environment(
        loader=PackageLoader("nonsmooth.report", "."),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    environment.filters |= {"prose": prose, "math": lambda latex: folded(mathml(latex))}
    template = environment.get_template(name)
    return template.render(version=version("nonsmooth"), equation_style=STYLE, **content)


def prose(words: str) -> Markup:
    r"""Return text as HTML: subscripts after underscores, no breaks before units and at "=".

    Examples
    --------
    >>> prose("μ_k F_N < 3 N's")
    Markup('μ<sub>k</sub> F<sub>N</sub> &lt; 3\xa0N’s')
    """
    text = str(escape(words.replace("'", "’")))
    text = re.sub(r"(?<=\d) (?=(%|[Nsm]|kg|m/s²?|N/m)(?!\w))| (?==)|(?<==) ", "\xa0", text)
    return Markup(re.sub(r"(\w)_(\w+)", r"\1<sub>\2</sub>", text))


def inline(svg: str, name: str, words: str) -> str:
    """Return an SVG of matplotlib as an element of the page, with `words` as its label.

    Its ids begin with `name`, so that those of several pictures differ.
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


def folded(equations: str) -> str:
    """Return equations as a part of a page: headings one level lower, Jacobians folded away."""
    text = re.sub(r' xmlns="[^"]*"', "", equations)
    text = re.sub(
        r"<h2>(Jacobian .*?)</h2>(.*?)(?=<h2>|$)",
        r"<details><summary>\1</summary>\2</details>",
        text,
        flags=re.DOTALL,
    )
    return re.sub(r"(</?)h2", r"\1h3", text)
