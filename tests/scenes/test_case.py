"""Cases: every mistake is named, and numbers without units do not depend on the units."""

import copy
import math
import pickle

import pytest
import sympy as sp
from made_scenes import parameters, scene_of

from nonsmooth.scene import Event, Phase, a, forcing, v, x
from nonsmooth.solver.kernels import registry
from nonsmooth.solver.scaling import product_of_powers
from nonsmooth.solver.scenes import loaded
from nonsmooth.solver.scenes.dimensionless import _in_units
from nonsmooth.solver.scenes.loaded import LoadedScene, UnknownScene
from nonsmooth.solver.scenes.parameter_error import ParameterError

IMPACT = registry.load("impact")
DAMPED = registry.load("stick-slip-damped")


def test_shipped_scenes_are_found_by_looking() -> None:
    assert {"impact", "stick-slip-damped"} <= set(registry.names())
    assert registry.load("stick_slip_damped") == DAMPED
    assert loaded.load_folder(IMPACT.folder) == IMPACT != DAMPED
    assert "ck-tau" in registry.methods(IMPACT)
    assert "scene" not in registry.methods(IMPACT)


def test_unknown_names_get_the_nearest_known_one(tmp_path) -> None:
    with pytest.raises(UnknownScene, match="did you mean impact"):
        registry.load("impakt")
    with pytest.raises(UnknownScene, match="expected one of"):
        registry.load(3)  # type: ignore[arg-type]
    with pytest.raises(UnknownScene, match=r"no scene\.py"):
        loaded.load_folder(tmp_path)
    with pytest.raises(UnknownScene, match="did you mean ck-tau"):
        registry.kernel(IMPACT, "ck-tao")
    assert registry.generic_method(IMPACT, "c0-tau") == "ck-tau"
    assert registry.generic_method(DAMPED, "c1-tau") == "ck-tau"
    with pytest.raises(UnknownScene):
        registry.generic_method(IMPACT, "c1-tau")


def test_all_mistakes_are_named_at_once() -> None:
    wrong = {
        "mass": -1,
        "damping": "0.1",
        "stiffness": math.nan,
        "force": True,
        "frequency": math.inf,
        "restitution": 1.5,
        "gab": 0.1,
    }
    with pytest.raises(ParameterError) as caught:
        IMPACT(**wrong)
    assert caught.value.errors == (
        "gab: not a parameter of impact; did you mean gap?",
        "mass: got -1, expected a positive number",
        "damping: got '0.1', expected a number not below 0",
        "stiffness: got nan, expected a positive number",
        "force: got True, expected a positive number",
        "frequency: got inf, expected a positive number",
        "restitution: got 1.5, expected a positive number, at most 1",
    )


@pytest.mark.parametrize("value", [10**400, 10**5000, "g" * 900], ids=range(3))
@pytest.mark.parametrize("name", ["gap", "cycles"])
def test_a_long_value_is_not_repeated_in_full(name: str, value: object) -> None:
    with pytest.raises(ParameterError, match=f"{name}: got .*, expected a") as caught:
        IMPACT(**{name: value})
    assert len(str(caught.value)) < 140


def test_what_the_scene_requires_is_checked_with_numbers() -> None:
    with pytest.raises(ParameterError) as caught:
        DAMPED(mu_s=0.2, mu_k=0.3)
    (line,) = caught.value.errors
    assert line == "parameters: got mu_s = 0.2, mu_k = 0.3, expected that mu_k is at most mu_s"


def test_units_beyond_float64_are_refused() -> None:
    with pytest.raises(ParameterError, match=r"unit of length .*; force = 1e-300 makes it so"):
        IMPACT(force=1e-300, mass=1e100)
    with pytest.raises(ParameterError, match=r"; frequency = 1e-300 makes it so, frequency ="):
        IMPACT(frequency=1e-300)
    with pytest.raises(ParameterError, match="gap in their units"):
        IMPACT(gap=1e300, force=1e-20)


def test_the_parameter_that_leaves_no_unit_is_named_not_the_one_farthest_off() -> None:
    m, k, W = sp.symbols("m k W", positive=True)
    c, F = sp.symbols("c F", nonnegative=True)
    flight = Phase(
        "flight", m * a + c * v + k * x - F * forcing, ends=Event(x, jump={v: -v / 2})
    )
    own = parameters(
        mass=(m, "kg", 1.0), damping=(c, "N s/m", 0.1), stiffness=(k, "N/m", 1.0),
        force=(F, "N", 0.4), frequency=(W, "rad/s", 1.0),
    )  # fmt: skip
    scene = scene_of("bouncing", own, flight)
    with pytest.raises(ParameterError, match=r"; force = 0.0 makes it so, force ="):
        scene(force=0.0, mass=3.0)


@pytest.mark.parametrize(
    ("mass", "length", "time"),
    [
        (1e150, 1.0, 1.0),
        (1e-150, 1e50, 1e-45),
        (1e150, 1e-100, 1e30),
        (1e-150, 1e-100, 1e-160),  # the square of the frequency is beyond float64
    ],
)
def test_numbers_do_not_depend_on_the_units(mass, length, time) -> None:
    for scene in (IMPACT, DAMPED):
        values = {
            q.name: product_of_powers(q.default, *zip((mass, length, time), p, strict=True))
            for q, p in zip(scene.parameters, scene.powers, strict=True)
        }
        assert scene(**values).numbers == pytest.approx(scene().numbers, rel=1e-14)
        units, plain = scene(**values).units, scene().units
        assert units.time / time == pytest.approx(plain.time, rel=1e-14)
        assert units.length / length == pytest.approx(plain.length, rel=1e-14)


def test_powers_of_four_change_no_digit() -> None:
    scaled = IMPACT(mass=4.0**200, damping=0.1 * 4.0**200, stiffness=4.0**200, force=4.0**200)
    assert scaled.numbers == IMPACT().numbers
    assert scaled.units.time == IMPACT().units.time


def test_fractional_powers_of_units() -> None:
    # N/m^(3/2) is kg m^(-1/2) s^(-2)
    assert _in_units(12.0, (1, -0.5, -2), (3.0, 4.0, 5.0)) == pytest.approx(12 / 3 * 2 * 25)
    assert _in_units(1e-300, (0, -1.5, 0), (1.0, 1e200, 1.0)) == pytest.approx(1.0)


def test_cases_are_values() -> None:
    case = IMPACT(gap=0.2)
    assert case == IMPACT(gap=0.2) != IMPACT()
    assert hash(case) == hash(IMPACT(gap=0.2))
    assert pickle.loads(pickle.dumps(case)) == case
    assert case.values["gap"] == 0.2
    with pytest.raises(TypeError):
        case.values["gap"] = 0.3  # type: ignore[index]
    assert "g = 0.2 m" in case.description
    assert "gap=0.2" in repr(case)


@pytest.mark.parametrize("scene", [IMPACT, *registry.load("dry-friction").each_motion])
def test_scenes_are_values(scene: LoadedScene) -> None:
    for again in (pickle.loads(pickle.dumps(scene)), copy.copy(scene), copy.deepcopy(scene)):
        assert again == scene
        assert again.motion == scene.motion
        assert again() == scene()


def test_dimensionless_equations_are_of_order_one() -> None:
    (phase,) = IMPACT(mass=7, frequency=3, force=11).cell.phases
    assert (phase.m, phase.g) == pytest.approx((1, 1))
    assert IMPACT(frequency=3).cell.duration == pytest.approx(2 * math.pi)
    assert DAMPED().cell.phases[0].held
    with pytest.raises(ValueError, match="without forcing"):
        _ = DAMPED().cell.duration
