"""The documents of the paper's methods have what those of every scene have."""

import json

import numpy as np
import pytest

import nonsmooth as ns
from nonsmooth.files.shortcuts.documents import of_solution
from nonsmooth.solver.no_orbit import NoOrbit
from nonsmooth.solver.shortcuts.orbit.oscillator import DEFAULT, StickSlip

#: Alpha of about 0.4, and no unit of 1.
SLOW = StickSlip(mass=3, stiffness=50, belt_speed=2, mu_s=0.4, mu_k=0.3, normal_force=80)

#: Keys of the generic document that the paper's has not: it has the count of its functions.
NOT_OF_THE_PAPER = {"functions", "others"}


def keys(document: dict, prefix: str = "") -> set[str]:
    """Return all keys but those of coefficients, with the keys that they are under."""
    found = set()
    for key, value in document.items():
        found.add(prefix + key)
        if isinstance(value, dict) and key != "coefficients":
            found |= keys(value, f"{prefix}{key}.")
    return found


def test_no_key_of_any_scene_is_missing(run) -> None:
    _, own, _ = run("solve", "--method", "c1", "--order", 8, "--json")
    _, generic, _ = run("solve", "--method", "c1-tau", "--order", 8, "--json")
    own, generic = json.loads(own), json.loads(generic)
    assert keys(generic) - keys(own) - NOT_OF_THE_PAPER <= {
        f"units.{name}" for name in generic["units"]
    }
    assert [own[name] for name in ("schema", "scene", "class", "motion")] == [
        generic[name] for name in ("schema", "scene", "class", "motion")
    ]
    for name in ("duration", "durations", "forcing_phase", "displacement", "velocity"):
        assert own["units"][name] == generic["units"][name]


@pytest.mark.parametrize("belt", [DEFAULT, SLOW])
@pytest.mark.parametrize(("method", "order"), [("hb", 7), ("hb", 60), ("hb-c1", 9), ("c1", 6)])
def test_phases_and_ends_are_those_of_the_motion(belt, method: str, order: int) -> None:
    orbit = ns.solve(belt, method, order)
    document = of_solution(belt, method, order, orbit)
    stick, slip = document["phases"]
    assert [stick["name"], slip["name"]] == ["stick", "slip"]
    assert stick["duration"] == orbit.t1
    assert stick["duration"] + slip["duration"] == pytest.approx(orbit.period, rel=1e-15)
    for phase, t in ((stick, 0.0), (slip, orbit.t1)):
        assert phase["start"]["displacement"] == orbit.displacement(t)
        assert phase["start"]["velocity"] == orbit.velocity(t)
    t = np.linspace(0, orbit.period, 20_001)
    for name, values in (
        ("displacement", orbit.displacement(t)),
        ("velocity", orbit.velocity(t)),
    ):
        low, high = document["extremes"][name]
        size = high - low
        assert low <= values.min() + 1e-9 * size
        assert high >= values.max() - 1e-9 * size
        assert values.min() - low < 1e-5 * size
        assert high - values.max() < 1e-5 * size
    left, right = document["extremes"]["displacement"]
    assert (right - left) / 2 == pytest.approx(orbit.amplitude, rel=1e-10)


def test_ends_by_samples_are_those_between_critical_points(monkeypatch) -> None:
    from nonsmooth.solver.shortcuts.orbit import extremes

    for method in ("hb", "hb-c1"):
        by_samples = ns.solve(DEFAULT, method, 40).extremes
        monkeypatch.setattr(extremes, "MOST_FOLLOWED", 40)
        followed = ns.solve(DEFAULT, method, 40).extremes
        monkeypatch.undo()
        for name, ends in followed.items():
            assert by_samples[name] == pytest.approx(ends, rel=1e-9)


def test_errors_of_the_times_are_those_of_stick_and_slip() -> None:
    orbit = ns.solve(SLOW, "c1", 5)
    exact, document = ns.exact(SLOW), of_solution(SLOW, "c1", 5, orbit)
    here = (orbit.t1, orbit.period - orbit.t1)
    there = (exact.t1, exact.period - exact.t1)
    assert document["exact"]["durations"] == list(there)
    worst = max(abs(a - b) for a, b in zip(here, there, strict=True)) / exact.period
    assert document["errors"]["times"] == pytest.approx(worst, rel=1e-9)
    assert document["errors"]["discontinuous"] == orbit.errors.acceleration_aligned
    assert 0.9 * worst < document["estimate"]["times"] < 3 * worst


def test_without_an_orbit_the_keys_are_the_same() -> None:
    there = of_solution(DEFAULT, "c1", 5, ns.solve(DEFAULT, "c1", 5))
    absent = of_solution(DEFAULT, "c1", 5, NoOrbit("none", False, ()))
    assert keys(there) - keys(absent) <= {f"outcome.{name}" for name in there["outcome"]} | {
        "outcome"
    }
    assert absent["phases"][1] == {
        "name": "slip", "duration": None, "start": {"displacement": None, "velocity": None}
    }  # fmt: skip
    assert absent["errors"]["times"] is None


def test_what_no_method_is_named_for_is_solved_as_on_the_command_line(run) -> None:
    status, out, _ = run("solve", "--json")
    assert status == 0
    by_method = {each["method"]: each for each in json.loads(out)["orbits"]}
    orbit = ns.solve(DEFAULT)
    assert (orbit.method, orbit.order, orbit.period) == ("c1", 10, by_method["c1"]["period"])
    assert ns.solve(DEFAULT, "hb").period == by_method["hb"]["period"]
    status, out, _ = run("solve", "impact", "--json")
    by_method = {each["method"]: each for each in json.loads(out)["orbits"]}
    orbit = ns.solve(ns.scene("impact")())
    assert (orbit.method, orbit.order) == ("ck-tau", 10)
    assert orbit.period == by_method["ck-tau"]["period"]


def test_documents_begin_alike_and_are_those_of_python(run) -> None:
    begins = ("schema", "scene", "class", "motion", "cycles")
    _, own, _ = run("sweep", "--methods", "c1", "--orders", "4", "--json")
    _, generic, _ = run("sweep", "--methods", "c1-tau", "--orders", "4", "--json")
    _, family, _ = run("sweep", "--vary", "mass=1:2:2", "--json")
    for text in (own, generic, family):
        document = json.loads(text)
        assert [document[name] for name in begins] == [1, "stick-slip", "C1", None, 1]
    sweep = ns.sweep(DEFAULT, ["c1"], [4]).as_dict()
    assert sweep.keys() == json.loads(own).keys() - {
        "schema", "units", "version", "mathematics", "sha256",
    }  # fmt: skip
    _, out, _ = run("solve", "--method", "c1", "--order", 4, "--json")
    document, orbit = json.loads(out), ns.solve(DEFAULT, "c1", 4)
    assert {name: document[name] for name in orbit.as_dict()} == json.loads(
        json.dumps(orbit.as_dict())
    )
    several = json.loads(run("solve", "--order", 4, "--json")[1])
    assert several["scene"] == "stick-slip"
