"""A page for each room of the package: its docstring, and that of each module in it.

The packages that conf.py lists as ``rooms`` are taken with all packages below them.  With a
page a module there would be seven times as many, and each carries the list of all pages.
"""

import pkgutil
from importlib import import_module
from pathlib import Path

from sphinx.application import Sphinx

#: Where the pages are written; they are not kept.
FOLDER = "reference/modules"


def page(package: str) -> tuple[str, list[str]]:
    """Return the page of a package as reStructuredText, and the packages in it."""
    found = list(pkgutil.iter_modules(import_module(package).__path__))
    modules = [module.name for module in found if module.name[0] != "_"]
    packages = [f"{package}.{module.name}" for module in found if module.ispkg]
    parts = [section(package, "="), listed("autosummary", modules)]
    parts.append(listed("toctree", packages, ":hidden:"))
    parts += [
        section(f"{package}.{module.name}", "-")
        for module in found
        if module.name in modules and not module.ispkg
    ]
    return "\n".join(parts), packages


def section(module: str, line: str) -> str:
    """Return the heading of a module and what documents its members."""
    title = module.removeprefix("nonsmooth.").replace("_", r"\_")
    return f"{title}\n{line * len(title)}\n\n.. automodule:: {module}\n   :members:\n"


def listed(directive: str, names: list[str], *options: str) -> str:
    """Return a directive with a name a line; nothing without names."""
    body = [*options, "", *names]
    return "\n   ".join([f".. {directive}::", *body]) + "\n" if names else ""


def write(app: Sphinx) -> None:
    """Write the pages that are not there already, or differ."""
    folder = Path(app.srcdir, FOLDER)
    folder.mkdir(exist_ok=True)
    rooms = list(app.config.rooms)
    for package in rooms:
        text, below = page(package)
        rooms += below
        path = folder / f"{package}.rst"
        if not path.exists() or path.read_text("utf-8") != text:
            path.write_text(text, "utf-8")


def setup(app: Sphinx) -> dict[str, bool]:
    """Write the pages before any is read."""
    app.add_config_value("rooms", [], "env", list)
    app.connect("builder-inited", write)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
