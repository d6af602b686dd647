"""The documentation: ``make docs``, or sphinx-build.  Needs no network."""

import logging
import os
import re
import sys
import types
import warnings
from importlib.metadata import version as installed
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from sphinx.application import Sphinx

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE / "_extensions"))
# A profile for the kernels that run the pages: nothing of the reader's own enters, and they
# do not warn of being reachable from this machine.
PROFILE = TemporaryDirectory()
CONFIG = Path(PROFILE.name, "profile_default", "ipython_kernel_config.py")
CONFIG.parent.mkdir()
CONFIG.write_text('c.IPKernelApp.log_level = "ERROR"\n', encoding="utf-8")
os.environ["IPYTHONDIR"] = PROFILE.name
logging.getLogger("traitlets").setLevel(logging.WARNING)
# Of docstrings of SymPy, whose sections are not numpydoc's.
warnings.filterwarnings("ignore", "Unknown section", UserWarning, "numpydoc")

project = "nonsmooth"
author = "The nonsmooth developers"
copyright = author
version = release = installed("nonsmooth")

extensions = [
    "myst_nb",
    "sphinx.ext.autodoc",
    "sphinx.ext.autosummary",
    "sphinx.ext.viewcode",
    "numpydoc",
    "sphinx_click",
    "sphinx_copybutton",
    "derived",
    "mathml",
    "navigation",
    "places",
    "rooms",
]
exclude_patterns = ["_build", "_extensions"]
nitpicky = True
highlight_language = "none"
default_role = "code"
smartquotes_action = "q"  # a double hyphen is one of the command line

# Pages: MyST Markdown; those with cells are executed, and an error in one ends the build.
myst_enable_extensions = ["colon_fence", "dollarmath", "deflist"]
myst_heading_anchors = 3
nb_execution_mode = "force"
nb_execution_raise_on_error = True
nb_execution_in_temp = True
nb_execution_timeout = 900
nb_execution_show_tb = True
nb_merge_streams = True

# Reference: from the docstrings, which state the types.
autodoc_typehints = "none"
autodoc_member_order = "bysource"
autosummary_generate = False
numpydoc_show_class_members = False
numpydoc_class_members_toctree = False
rooms = [
    "nonsmooth.codegen",
    "nonsmooth.generated",
    "nonsmooth.solver",
    "nonsmooth.files",
    "nonsmooth.scene_files",
    "nonsmooth.report",
]

html_theme = "furo"
html_title = f"nonsmooth {version}"
html_static_path = ["_static"]
html_css_files = ["site.css"]
html_math_renderer = "mathml"
html_copy_source = html_show_sourcelink = False
html_theme_options = {"navigation_with_keys": True}


def skip_types(
    app: Sphinx, what: str, name: str, obj: Any, skip: bool, options: dict[str, Any]
) -> bool | None:
    """Leave out names of types, such as an array of float64: they have no docstring."""
    return True if isinstance(obj, types.GenericAlias) else None


def escape(app: Sphinx, context: Any, lines: list[str]) -> None:
    """Let stars and backslashes in the help of a command stand for themselves."""
    lines[:] = [re.sub(r"[*\\]", r"\\\g<0>", line) for line in lines]


def examples(app: Sphinx, context: Any, lines: list[str]) -> None:
    """Let what a command ends with, a heading and lines to type, be set as they are typed."""
    block = [line.removeprefix("| ") for line in lines if line.startswith("| ")]
    if not block or not block[0].endswith(":"):
        return
    heading, *typed = block
    rest = [line for line in lines if not line.startswith("| ")]
    lines[:] = [heading, "", ".. code-block:: text", "", *typed, "", *rest]


def setup(app: Sphinx) -> None:
    """Connect what is above."""
    app.connect("autodoc-skip-member", skip_types)
    app.connect("sphinx-click-process-description", escape)
    app.connect("sphinx-click-process-options", escape)
    app.connect("sphinx-click-process-epilog", examples)
