"""The navigation beside each page, without what makes it most of the time of a build.

Sphinx copies the contents of all pages for the navigation of each, with every function in them;
and it does so for each page of source as well, where the navigation is the same.
"""

from collections.abc import Callable
from typing import Any

from docutils import nodes
from sphinx import addnodes
from sphinx.application import Sphinx

#: Pages of modules, and of source.
MODULES, SOURCE = "reference/modules/", "_modules/"

#: The navigation of pages of source, by the folders above the page: the links begin there.
COMPUTED: dict[int, str] = {}


def brief(app: Sphinx, doctree: nodes.document) -> None:
    """List modules, and not their functions, in the contents of the pages of modules."""
    if app.env.docname.startswith(MODULES):
        for described in doctree.findall(addnodes.desc):
            described["no-contents-entry"] = True


def once(app: Sphinx, page: str, template: str, context: dict[str, Any], doctree: Any) -> None:
    """Let pages of source that are equally deep share their navigation."""
    compute: Callable[..., str] | None = context.get("toctree")
    if not page.startswith(SOURCE) or compute is None:
        return
    depth = page.count("/")

    def navigation(**options: Any) -> str:
        if depth not in COMPUTED:
            COMPUTED[depth] = compute(**options)
        return COMPUTED[depth]

    context["toctree"] = navigation


def setup(app: Sphinx) -> dict[str, bool]:
    """Connect both before Sphinx collects the contents, and the theme asks for them."""
    app.connect("doctree-read", brief, priority=400)
    app.connect("html-page-context", once, priority=400)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
