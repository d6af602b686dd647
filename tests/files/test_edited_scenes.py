"""Results of a scene edited since: refused if, and only if, its mathematics changed."""

import json
import random
from pathlib import Path

import pytest
from shown import ROOT

import nonsmooth as ns
from nonsmooth.scene_files import store

#: The scene that is edited.
BALL = (ROOT / "examples" / "bouncing_ball.py").read_text("utf-8")

#: Edits of words and of defaults: none changes an orbit of given parameters.
WORDS = {
    "title": ('"a ball that bounces', '"one of {} balls that bounce'),
    "source": ("P. J. Holmes", "Holmes, {} pages"),
    "default": ("9.81", "{}.8"),
    "another default": ('"rad/s", 50.0', '"rad/s", 6{}.5'),
    "what a parameter is": ("amplitude of the table", "amplitude no. {}"),
    "largest value": ("most=1", "most=0.9{}"),
    "demand in words": ("the ball stays above", "the {} balls stay above"),
    "guess": ("frequency=Omega", "frequency=Omega, guess=(6 / Omega + {} / (100 * Omega),)"),
    "extremes": ("frequency=Omega", "frequency=Omega, extremes={{'slow': {{r: 1 / {}}}}}"),
    "order of terms": ("a + g - A * Omega**2 * forcing", "-A * forcing * Omega**2 + g + a"),
    "comment": ("# zero;", "# {} terms, zero;"),
}

#: Edits that change the motion or what must hold of it.
MATHEMATICS = {
    "coefficient": ("a + g", "a + g * {}"),
    "damping": ("a + g", "a + Omega * v / {} + g"),
    "spring": ("a + g", "a + Omega**2 * x / {} + g"),
    "force": ("A * Omega**2 * forcing", "A * Omega**2 * forcing / {}"),
    "jump": ("-r * v", "-r * v / {}"),
    "event": ("Event(x,", "Event({0} * A + x,"),
    "demand": ('table": x}', "table\": x, 'low': {} * g / Omega**2 - x}}"),
    "requirement": ("frequency=Omega", "frequency=Omega, requires={{'few': {} - r}}"),
    "units": ("frequency=Omega", "frequency=Omega, scales={{'length': {} * A}}"),
}


def edited(text: str, names: list[str], dice: random.Random) -> str:
    """Return the text of a scene file after some of the edits."""
    for name in names:
        old, new = (WORDS | MATHEMATICS)[name]
        assert text.count(old) >= 1, name
        text = text.replace(old, new.format(dice.randrange(2, 9)), 1)
        if name == "event":  # what falls to zero there is demanded
            text = text.replace(": x}", ": x + A * " + text.partition("Event(")[2][0] + "}")
    return text


def edits(seed: int) -> tuple[list[str], bool]:
    """Return some edits that can be made together, and whether they change the mathematics."""
    dice = random.Random(seed)
    found: dict[str, str] = {}  # one edit at each place
    for name, (old, _) in dice.sample([*WORDS.items()], 2):
        found.setdefault(old[:5], name)
    if changes := dice.random() < 0.5:
        name = dice.choice([*MATHEMATICS])
        found[MATHEMATICS[name][0][:5]] = name
        found.pop("a + g" if name == "force" else "", None)
    return [*found.values()], changes


@pytest.fixture(scope="module")
def results(tmp_path_factory: pytest.TempPathFactory):
    """Return the folder of an orbit, a sweep and a family."""
    folder = tmp_path_factory.mktemp("edited")
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("XDG_CACHE_HOME", str(folder))
        patch.setattr(store, "_FOR_NOW", {})
        (folder / "scene.py").write_text(BALL, "utf-8")
        case = ns.scene(folder / "scene.py")()
        ns.save(ns.solve(case, order=6), folder / "orbit.json")
        ns.save(ns.sweep(case, ["ck-tau"], [4, 6]), folder / "sweep.json")
        ns.save(ns.family(case, "gravity", [9.0, 9.5], order=6), folder / "family.json")
        yield folder


def check(results: Path, names: list[str], seed: int, refused: bool) -> None:
    """Load each result under the scene after some edits."""
    path = results / "edited.py"
    path.write_text(edited(BALL, names, random.Random(seed)), "utf-8")
    for kind in ("orbit", "sweep", "family"):
        file = results / f"{kind}.json"
        if refused:
            with pytest.raises(ns.FileError, match=f"{kind} of other equations"):
                ns.load(file, scene=path)
        else:
            document = json.loads(file.read_text("utf-8"))
            assert ns.load(file, scene=path).as_dict()["parameters"] == document["parameters"]


@pytest.mark.parametrize("name", MATHEMATICS)
def test_other_equations_are_refused(name: str, results: Path) -> None:
    check(results, [name], 1, refused=True)


def test_other_words_are_the_same_mathematics(results: Path) -> None:
    """All of them at once, but the second at the same place."""
    check(results, [name for name in WORDS if name != "guess"], 1, refused=False)
    check(results, ["guess"], 2, refused=False)


@pytest.mark.parametrize(
    "seed", [*range(3), *(pytest.param(n, marks=pytest.mark.long) for n in range(3, 60))]
)
def test_random_edits(seed: int, results: Path) -> None:
    names, changes = edits(seed)
    check(results, names, seed, refused=changes)


def test_a_mistake_in_the_scene_is_not_one_of_the_result(results: Path) -> None:
    path = results / "mistaken.py"
    path.write_text(BALL.replace('"flight"', '"2 flights"'), "utf-8")
    with pytest.raises(ns.SceneFileError, match=r"mistaken\.py, line \d+: phase 2 flights"):
        ns.load(results / "sweep.json", scene=path)
