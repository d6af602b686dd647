"""Generic code names no scene; folders stay small enough to be read.

The words are those of the scenes' own records: names of scenes, phases and parameters, and the
symbols that stand for them in the paper, less those that any mechanical system has.
"""

import ast
import io
import keyword
import re
import tokenize
from collections.abc import Iterator
from functools import cache
from pathlib import Path

from shown import ROOT

from nonsmooth.codegen import scenes
from nonsmooth.kim_perkins import SCENE

#: What the generic interface itself speaks of; the rest is also what is left.
GENERAL = frozenset(
    {
        "beam",
        "chain",
        "contact",
        "modes",
        "ratio",
        "mass",
        "damping",
        "stiffness",
        "force",
        "frequency",
        "speed",
        "damped",
        "two",
        "rest",
    }
)

#: Names of the paper's oscillator that no record has.
PAPER = frozenset({"belt", "alpha", "t1", "backlash"})

#: Rooms that may name a scene.
OWN = re.compile(
    r"/report/|/(kim_perkins|all_solutions|one_function)\.py$|/cli/commands/paper\.py$"
    r"|^(codegen/(scenes|expansions)|generated)/"
)

#: Generic places whose text has such a name, and why.
MAY_SAY = {
    "src/nonsmooth/cli/named.py": {SCENE},  # the default
    "codegen/__init__.py": {SCENE},  # the equations that are meant where no scene is named
}

#: Generic texts that have a word of a scene, and why.
SPOKEN_OF = {
    "codegen/emission/phase_maps.py": {"mu"},  # of the moments of the forcing
    "codegen/printing/html.py": {"gap"},  # of columns, in CSS
    "codegen/space/emission.py": {"mu"},  # of the eigenvalues without an attachment
    "src/nonsmooth/cli/__init__.py": {"stick", "slip"},  # the default scene
    "src/nonsmooth/cli/scenes/captions.py": {"alpha", "mu"},  # what alpha of the paper is
    "src/nonsmooth/oscillators.py": {"belt"},  # whose a method alone is
    "src/nonsmooth/cli/commands/equations.py": {"impact"},  # a method needs one impulse more
}

MOST_FILES = 15


@cache
def words() -> frozenset[str]:
    """Return the words of all scenes."""
    found: set[str] = set(PAPER)
    for scene in map(scenes.load, scenes.names()):
        found |= set(scene.name.split("-"))
        for phase in (phase for motion in scene.each_motion for phase in motion.phases):
            found.add(phase.name)
        for motion in scene.motions:
            found |= set(motion.split("-"))
        for parameter in scene.parameters:
            found |= set(parameter.name.split("_"))
    return frozenset(
        word for word in found - GENERAL if len(word) > 1 and not keyword.iskeyword(word)
    )


def sources() -> Iterator[Path]:
    """Yield the Python files of the package, but for what is reached by a link."""
    for top in ("codegen", "solver", "src/nonsmooth"):
        for path in sorted((ROOT / top).rglob("*.py")):
            if not any(parent.is_symlink() for parent in path.parents):
                yield path


def named(path: Path) -> set[str]:
    """Return the words of scenes in the names of a file's code."""
    code = io.StringIO(path.read_text("utf-8"))
    names = (
        q.string.lower()
        for q in tokenize.generate_tokens(code.readline)
        if q.type == tokenize.NAME
    )
    return {word for name in names for word in name.split("_")} & words()


def test_the_words_come_from_the_records() -> None:
    assert {"stick", "slip", "belt", "mu", "normal", "restitution", "gap", "flight"} <= words()
    assert named(ROOT / "codegen" / "scenes" / "impact.py")


@cache
def literals(path: Path) -> set[str]:
    """Return the texts of a file's code: its string literals."""
    tree = ast.parse(path.read_text("utf-8"))
    nodes = (q.value for q in ast.walk(tree) if isinstance(q, ast.Constant))
    return {value for value in nodes if isinstance(value, str)}


#: Generic files, by their place below the root.
GENERIC = {str(q.relative_to(ROOT)): q for q in sources()}
GENERIC = {place: q for place, q in GENERIC.items() if not OWN.search(place)}


def test_a_generic_file_names_no_scene() -> None:
    assert {place: found for place, q in GENERIC.items() if (found := named(q))} == {}


def test_no_text_of_a_generic_file_is_the_name_of_a_scene() -> None:
    names = {spelled for name in scenes.names() for spelled in (name, name.replace("-", "_"))}
    said = {place: literals(q) & names for place, q in GENERIC.items()}
    assert {place: found for place, found in said.items() if found} == MAY_SAY


def prose(text: str) -> set[str]:
    """Return the words of scenes in a text; what is an example or quoted does not count."""
    plain = re.split(r"\n *Examples\n|Examples:", text)[0]
    plain = re.sub(r"``.*?``|\"[^\"]*\"", " ", plain, flags=re.DOTALL)
    return set(re.findall(r"[a-z0-9]+", plain.lower())) & words()


def test_docstrings_help_and_messages_of_a_generic_file_speak_of_no_scene() -> None:
    wrong = {}
    for place, path in GENERIC.items():
        found = set().union(*(prose(text) for text in literals(path) if " " in text))
        wrong[place] = found - SPOKEN_OF.get(place, set())
    assert {place: found for place, found in wrong.items() if found} == {}


def test_no_folder_has_more_files_than_one_can_look_through() -> None:
    width: dict[Path, int] = {}
    for path in sources():
        width[path.parent] = width.get(path.parent, 0) + 1
    wide = {str(q.relative_to(ROOT)): n for q, n in width.items() if n > MOST_FILES}
    assert wide == {}
