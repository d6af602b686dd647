"""What the documentation shows is what the program does: doctests, README and pages."""

import doctest
import importlib
import itertools
import json
import linecache
import pkgutil
import re
import shlex
import shutil
from pathlib import Path

import pytest
from shown import PAGES, README, ROOT, differences

import nonsmooth
from nonsmooth.cli import progress

#: The scene file that pages write and use.
BALL = ROOT / "examples" / "bouncing_ball.py"


def modules() -> dict[str, str]:
    """Return the text of each module by its name."""
    found = pkgutil.walk_packages(nonsmooth.__path__, "nonsmooth.")
    files = {m.name: m.module_finder.find_spec(m.name).origin for m in found}
    files["nonsmooth"] = nonsmooth.__file__
    return {name: Path(file).read_text("utf-8") for name, file in files.items()}


def test_every_module_can_be_imported() -> None:
    assert all(importlib.import_module(name) for name in modules() if "__main__" not in name)


@pytest.mark.parametrize("name", [name for name, text in modules().items() if ">>> " in text])
def test_examples_in_docstrings_run(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    # Before each example doctest asks of every file that was ever quoted whether it changed.
    monkeypatch.setattr(linecache, "cache", {})
    result = doctest.testmod(importlib.import_module(name))
    assert result.failed == 0


def test_some_docstrings_have_examples() -> None:
    finder = doctest.DocTestFinder(exclude_empty=True)
    names = (
        "oscillators",
        "kim_perkins",
        "solver.solve",
        "codegen.system",
        "cli.values",
    )
    for name in names:
        module = importlib.import_module(f"nonsmooth.{name}")
        assert any(test.examples for test in finder.find(module)), name


@pytest.fixture
def place(tmp_path: Path, monkeypatch) -> Path:
    """Return a folder of its own to be in, with the scene file of the pages, derived before."""
    nonsmooth.scene(BALL)
    monkeypatch.chdir(tmp_path)
    shutil.copy(BALL, tmp_path)
    return tmp_path


@pytest.mark.usefixtures("place")
@pytest.mark.parametrize("page", [page for page, text in PAGES.items() if ">>>" in text])
def test_python_examples_of_the_pages_run(page: str) -> None:
    result = doctest.testfile(str(ROOT / page), module_relative=False)
    assert result.attempted > 0
    assert result.failed == 0


def blocks(page: str) -> list[tuple[str, str]]:
    """Return each command of a page's console blocks with the output shown."""
    text = "\n".join(re.findall(r"```console\n(.*?)```", PAGES[page], flags=re.DOTALL))
    parts = re.split(r"^\$ ", text, flags=re.MULTILINE)[1:]
    commands = [part.partition("\n") for part in parts]
    return [(line, out) for line, _, out in commands if line.startswith("nonsmooth ")]


def shown() -> list[tuple[str, str, str]]:
    """Return each command with output, after the page that shows it."""
    return [(page, *block) for page in PAGES for block in blocks(page) if block[1].strip()]


@pytest.mark.usefixtures("place")
@pytest.mark.parametrize(("page", "command", "output"), shown())
def test_output_on_a_page_is_what_the_command_prints(
    run, monkeypatch, page: str, command: str, output: str
) -> None:
    monkeypatch.setattr(progress, "QUIET", 86_400.0)  # pages show nothing of what takes long
    for case in re.findall(r"```toml\n(.*?)```", PAGES[page], flags=re.DOTALL):
        table = case[1 : case.index("]")]
        name = "belt" if table == "stick_slip" else table
        Path(f"{name}.toml").write_text(case, encoding="utf-8")
    _, out, err = run(*shlex.split(command)[1:])
    assert differences(output, out + err) == []


DOCUMENTS = (
    "solve --order 3",
    "solve --method c1 --order 4 --normal-force 100",
    "solve --tol 1e-2",
    "solve --method hb-c1 --order 8",
    "sweep --orders 3,4",
    "sweep --vary belt-speed=1:2:2",
    "roots --order 3",
    "solve impact --order 4",
    "solve stick-slip-damped --tol 1e-3",
    "solve impact --gap 5 --method ck",
    "sweep impact --orders 4 --methods ck",
    "simulate impact --cycles 2",
    "scenes",
    "scenes stick-slip-damped",
    "digits impact --orders 4 --methods hb",
    "modes",
    "modes beam-mass --method all",
    "modes beam-crack --vary position=1/4:1/2:2",
    "sweep string-mass --orders 2,3",
)


#: What has the names of a scene's own parameters and functions as keys.
OF_A_SCENE = ("parameters", "units", "coefficients")


def keys(document: object) -> set[str]:
    """Return all keys of a JSON document, those of what it contains included."""
    if isinstance(document, dict):
        if "scene" in document or "structure" in document:
            document = document | dict.fromkeys(set(OF_A_SCENE) & set(document))
        return {*document, *itertools.chain(*map(keys, document.values()))}
    if isinstance(document, list):
        return {*itertools.chain(*map(keys, document))}
    return set()


@pytest.mark.parametrize("command", DOCUMENTS)
def test_every_key_of_a_document_is_on_the_page_of_files(run, command: str) -> None:
    _, out, _ = run(*command.split(), "--json")
    named = set(re.findall(r"`\"?(\w[\w-]*)", PAGES["docs/reference/files.md"]))
    assert keys(json.loads(out)) - named == set()


def test_every_public_name_is_in_the_reference() -> None:
    listed = re.findall(r"auto\w+:: nonsmooth\.(\w+)$", PAGES["docs/reference/python.md"], re.M)
    assert {name for name in nonsmooth.__all__ if name[0] != "_"} <= {*listed}


def test_the_columns_of_a_sweep_are_on_the_page_of_files(run, tmp_path: Path) -> None:
    run("sweep", "--methods", "c1", "--orders", "3", "-o", tmp_path / "sweep.csv")
    columns = (tmp_path / "sweep.csv").read_text("utf-8").splitlines()[0]
    assert columns in "".join(PAGES["docs/reference/files.md"].split())


def test_the_readme_shows_real_output() -> None:
    assert sum(page == "README.md" for page, *_ in shown()) >= 1


@pytest.mark.parametrize("page", PAGES)
def test_every_place_that_a_page_names_exists(page: str) -> None:
    folders = "codegen|solver|generated|tests|docs|src|benchmarks|examples"
    for path in re.findall(rf"`((?:{folders})/[\w./]+)`", PAGES[page]):
        assert (ROOT / path).exists(), path
    named = re.findall(rf"`((?:{folders})/[\w/]+\.py)`:\s`(\w+)`", PAGES[page])
    for path, name in named:
        text = (ROOT / path).read_text("utf-8")
        assert re.search(rf"(def |class |^){name}\b", text, re.MULTILINE), (path, name)
    assert named or page != "docs/reference/equations.md"


@pytest.mark.parametrize("page", PAGES)
def test_every_file_that_a_page_links_to_exists(page: str) -> None:
    for target in re.findall(r"\]\(([^)#]+)[^)]*\)", PAGES[page]):
        if "://" not in target and "modules" not in target:
            assert ((ROOT / page).parent / target).exists(), target


def test_the_readme_writes_the_scene_file_that_it_runs() -> None:
    (written,) = (
        q for q in re.findall(r"```python\n(.*?)```", README, re.DOTALL) if "SCENE" in q
    )
    lines = [line for line in written.splitlines() if line]
    beside = [line for line in BALL.read_text("utf-8").splitlines() if line]
    assert [line for line in lines if line not in beside] == []


def test_every_equation_of_the_paper_is_in_the_index() -> None:
    index = PAGES["docs/reference/equations.md"]
    numbers = {int(n) for row in re.findall(r"^\| ([\d, -]+) \|", index, re.MULTILINE)
               for n in expand(row)}  # fmt: skip
    assert numbers == set(range(1, 23))


def expand(row: str) -> list[str]:
    numbers = []
    for part in row.split(","):
        first, _, last = part.strip().partition("-")
        numbers += [str(n) for n in range(int(first), int(last or first) + 1)]
    return numbers
