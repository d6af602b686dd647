"""Link a place in the source, as the pages name it, to its documentation.

`codegen/expansions/hb.py` becomes a link to that module, and in `codegen/expansions/hb.py`:
`series` the name one to that object; a place that does not exist is a warning, and so stops
the build.
"""

import re
from itertools import pairwise

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.util import logging
from sphinx.util.nodes import make_refnode

logger = logging.getLogger(__name__)

PLACE = re.compile(r"(?:src/nonsmooth/)?((?:codegen|generated|solver)/\w+|\w+)\.py")


def module_of(literal: nodes.literal) -> str | None:
    """Return the module that a piece of code text names, if it names one."""
    text = literal.astext()
    found = PLACE.fullmatch(text)
    if found is None or not text.startswith(("codegen/", "generated/", "solver/", "src/")):
        return None
    return "nonsmooth." + found[1].replace("/", ".").removesuffix(".__init__")


def link(app: Sphinx, doctree: nodes.document, docname: str) -> None:
    """Put links around the places that a page names."""
    domain = app.env.domains.python_domain

    def wrap(literal: nodes.literal, target: str) -> bool:
        entry = domain.objects.get(target)
        if entry is None:
            return False
        inside = literal.deepcopy()
        wrapped = make_refnode(
            app.builder, docname, entry.docname, entry.node_id, inside, target
        )
        literal.replace_self(wrapped)
        return True

    literals = list(doctree.findall(nodes.literal))
    modules = {literal: module_of(literal) for literal in literals}
    for literal, following in pairwise([*literals, nodes.literal()]):
        module = modules[literal]
        if module is None or isinstance(literal.parent, nodes.reference):
            continue
        position = literal.parent.index(literal)
        between = literal.parent[position + 1 : position + 3]
        if not wrap(literal, module):
            logger.warning("no such place: %s", literal.astext(), location=literal)
        elif len(between) == 2 and between[0].astext() == ": " and between[1] is following:
            wrap(following, f"{module}.{following.astext()}")


def setup(app: Sphinx) -> dict[str, bool]:
    """Link when the references are resolved."""
    app.connect("doctree-resolved", link)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
