"""generated/ is what the derivation gives, to the byte."""

import dataclasses
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

from nonsmooth.codegen import generate, scenes
from nonsmooth.codegen.emission import one_function, phase_maps, whole_period
from nonsmooth.codegen.emission.text import module_text
from nonsmooth.codegen.expansions import ck

DERIVE = """
import sys
from nonsmooth.codegen import generate, scenes
if len(sys.argv) > 1:
    scenes.names = lambda: tuple(sys.argv[1:])
    generate.space.sources = dict
for name, text in generate.sources().items():
    content = text if isinstance(text, bytes) else text.encode()
    if (generate.FOLDER / name).read_bytes() != content:
        print(name)
"""


@pytest.mark.parametrize("names", [("impact",), pytest.param((), marks=pytest.mark.long)])
def test_a_derivation_in_another_process_gives_the_committed_files(names: tuple[str]) -> None:
    """The text does not depend on the process: neither on its hashes nor on its clock.

    All is derived by `make test-long`, and by `make lint`.
    """
    environment = os.environ | {"PYTHONHASHSEED": "12345"}
    command = [sys.executable, "-c", DERIVE, *names]
    done = subprocess.run(command, check=True, env=environment, capture_output=True)
    assert done.stdout == b""


def test_the_folder_has_the_files_of_every_scene_and_no_others() -> None:
    found = {path.parent.name for path in generate.FOLDER.glob("*/scene.py")}
    assert found == {name.replace("-", "_") for name in scenes.names()}
    for scene in map(scenes.load, scenes.names()):
        folder = generate.FOLDER / scene.name.replace("-", "_")
        motions = {folder / motion.replace("-", "_") for motion in scene.motions}
        for each in (folder, *motions):
            assert {path.stem for path in each.glob("*.py")} == {"__init__", "scene"}
        assert {path.parent for path in folder.glob("*/scene.py")} == motions


#: What stands for the derived files where only the handling of files is tested.
FILES = {
    "__init__.py": "# a\n",
    "hb.py": "x = 1\n",
    "c1.py": "y = 2\n",
    "scene/ck.py": "z = 3\n",
}


@pytest.fixture
def few_files(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(generate, "sources", lambda: dict(FILES))


@pytest.mark.usefixtures("few_files")
def test_a_second_run_changes_nothing(tmp_path: Path) -> None:
    generate.write(tmp_path)
    before = {path: path.stat().st_mtime_ns for path in tmp_path.rglob("*.py")}
    assert len(before) == len(FILES)
    assert generate.write(tmp_path) == []
    assert {path: path.stat().st_mtime_ns for path in tmp_path.rglob("*.py")} == before


@pytest.mark.usefixtures("few_files")
def test_text_and_set_of_files_are_compared_without_writing(tmp_path: Path) -> None:
    generate.write(tmp_path)
    (tmp_path / "scene" / "extra.py").write_text("old = True\n")
    (tmp_path / "c1.py").unlink()
    (tmp_path / "hb.py").write_text("x = -1\n")
    expected = ["c1.py: missing", "hb.py: differs", "scene/extra.py: not generated"]
    assert generate.differences(tmp_path) == expected
    assert not (tmp_path / "c1.py").exists()
    assert (tmp_path / "hb.py").read_text() == "x = -1\n"
    changed = ["hb.py: written", "c1.py: written", "scene/extra.py: removed"]
    assert generate.write(tmp_path) == changed
    assert generate.differences(tmp_path) == []
    assert (tmp_path / "scene" / "ck.py").read_text() == FILES["scene/ck.py"]


FORMS = {
    "ck": lambda: phase_maps.closed_forms(ck.rest),
    "hb": whole_period.closed_forms,
    "hb_c1": one_function.closed_forms,
}


#: What the solver has beside the closed forms.
LOOPS = "".join(
    path.read_text("utf-8")
    for folder in ("rows", "maps")
    for path in sorted((generate.FOLDER.parent / "solver" / folder).glob("*.py"))
)


@pytest.mark.parametrize("name", FORMS)
def test_every_closed_form_counts_in_the_hash_and_is_called(name: str) -> None:
    forms = list(FORMS[name]())
    mark = re.compile(r'MATHEMATICS = "(\w+)"')
    shared = [q for q in whole_period.closed_forms() if q.name in one_function.SHARED]
    beside = shared if name == "hb_c1" else []
    assert all(f"{form.name}(" in LOOPS for form in (*forms, *beside))
    hashes = set(mark.findall((generate.FOLDER / f"{name}.py").read_text("utf-8")))
    hashes |= set(mark.findall(module_text("", forms, beside)))
    assert len(hashes) == 1
    together = [*beside, *forms]
    for place, form in enumerate(together):
        changed = dataclasses.replace(form, values=(form.values[0] + 1, *form.values[1:]))
        others = [*together[:place], changed, *together[place + 1 :]]
        hashes.update(mark.findall(module_text("", others)))
    assert len(hashes) == 1 + len(together)


def test_no_loop_is_there_that_nothing_calls() -> None:
    found = re.findall(r"^def (\w+)", LOOPS, re.M)
    unused = {name for name in found if not re.search(rf"(?<!def )\b{name}\(", LOOPS)}
    named = (f'"{name}"' for name in unused)  # of those that are linked by their names
    text = (generate.FOLDER.parent / "solver" / "kernels" / "linking.py").read_text("utf-8")
    assert unused <= {"motion", *(name.strip('"') for name in named if name in text)}
