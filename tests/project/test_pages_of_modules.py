"""What the documentation adds to Sphinx: a page for each room, and one navigation for many."""

import importlib
import pkgutil
import re
from pathlib import Path
from types import ModuleType, SimpleNamespace

import pytest

pytest.importorskip("sphinx")

from docutils import nodes
from sphinx import addnodes

import nonsmooth

DOCS = Path(__file__).resolve().parents[2] / "docs"

#: What is documented elsewhere: the command line, pictures as methods of results, public names.
ELSEWHERE = r"nonsmooth\.(__main__|cli|plots|extras|families|scene)(\.|$)"


@pytest.fixture
def extension(monkeypatch):
    """Return a loader of an extension of the documentation, not loaded before."""
    monkeypatch.syspath_prepend(DOCS / "_extensions")

    def load(name: str) -> ModuleType:
        monkeypatch.delitem(importlib.sys.modules, name, raising=False)
        return importlib.import_module(name)

    return load


def test_every_module_is_on_one_page(extension, tmp_path: Path) -> None:
    conf = (DOCS / "conf.py").read_text("utf-8")
    (listed,) = re.findall(r"^rooms = \[(.*?)\]", conf, re.DOTALL | re.MULTILINE)
    (tmp_path / "reference").mkdir()
    rooms = re.findall(r'"(.*?)"', listed)
    app = SimpleNamespace(srcdir=tmp_path, config=SimpleNamespace(rooms=rooms))
    extension("rooms").write(app)
    pages = [path.read_text("utf-8") for path in tmp_path.rglob("*.rst")]
    pages.append((DOCS / "reference" / "modules.md").read_text("utf-8"))
    found = re.findall(r"automodule:: (.*)", "\n".join(pages))
    known = [m.name for m in pkgutil.walk_packages(nonsmooth.__path__, "nonsmooth.")]
    expected = [name for name in known if not re.match(ELSEWHERE, name) and "._" not in name]
    assert sorted(found) == sorted(expected)


def test_a_page_of_a_room_links_to_the_rooms_in_it(extension) -> None:
    text, packages = extension("rooms").page("nonsmooth.solver.space")
    assert packages == [
        "nonsmooth.solver.space.eigenvalues",
        "nonsmooth.solver.space.expansions",
    ]
    tree = text.split(".. toctree::")[1].split("\nsolver.space.")[0]
    assert tree.split() == [":hidden:", *packages]
    assert "automodule:: nonsmooth.solver.space.eigenvalues\n" not in text


def test_functions_are_left_out_of_the_contents_of_pages_of_modules(extension) -> None:
    brief = extension("navigation").brief
    for page, left_out in (
        ("reference/modules/nonsmooth.solver", True),
        ("reference/python", None),
    ):
        doctree = nodes.document(None, None)
        doctree += addnodes.desc()
        brief(SimpleNamespace(env=SimpleNamespace(docname=page)), doctree)
        assert doctree[0].get("no-contents-entry") is left_out


def test_pages_of_source_that_are_equally_deep_share_their_navigation(extension) -> None:
    once, asked = extension("navigation").once, []

    def navigation(page: str) -> str:
        def compute(**options: object) -> str:
            asked.append((page, options))
            return f"as from {page}"

        context = {"toctree": compute}
        once(None, page, "page.html", context, None)
        return context["toctree"](maxdepth=-1)

    assert navigation("_modules/a/b") == navigation("_modules/a/c") == "as from _modules/a/b"
    assert navigation("_modules/a") == "as from _modules/a"
    assert [navigation(page) for page in ("a/b", "c/d")] == ["as from a/b", "as from c/d"]
    assert asked[0] == ("_modules/a/b", {"maxdepth": -1})
    assert len(asked) == 4
