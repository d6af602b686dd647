"""Bad arguments from Python: an error that names the argument, the value, what was expected."""

from collections.abc import Callable

import numpy as np
import pytest

import nonsmooth as ns
from nonsmooth.kim_perkins import SECTION_4 as GOOD


@pytest.mark.parametrize("name", GOOD)
@pytest.mark.parametrize("value", ["1", None, True, [1.0], 1j, np.nan, np.inf, -1.0])
def test_python_names_a_wrong_parameter(name: str, value: object) -> None:
    with pytest.raises(ns.ParameterError, match=f"{name}: got"):
        ns.StickSlip(**(GOOD | {name: value}))  # type: ignore[arg-type]


def test_python_names_all_wrong_parameters() -> None:
    with pytest.raises(ValueError, match=r"mass.*stiffness.*mu_k") as caught:
        ns.StickSlip(**(GOOD | {"mass": 0, "stiffness": -1, "mu_k": -1}))
    assert len(caught.value.errors) == 3


@pytest.mark.parametrize("number", [np.float32(10), np.int64(10), 10])
def test_python_takes_any_real_number(number) -> None:
    belt = ns.StickSlip(**(GOOD | {"mass": number}))
    assert type(belt.mass) is float


@pytest.mark.parametrize("order", [0, -1, 10**6, 2.0, "3", True])
def test_python_names_a_wrong_order(order: object, belt: ns.StickSlip) -> None:
    with pytest.raises(ValueError, match="order: got"):
        ns.solve(belt, "c1", order)  # type: ignore[arg-type]


@pytest.mark.parametrize("method", ["C1", "", 3])
def test_python_names_a_wrong_method(method: object, belt: ns.StickSlip) -> None:
    with pytest.raises(ValueError, match="method: got"):
        ns.solve(belt, method, 5)  # type: ignore[arg-type]


@pytest.mark.parametrize("budget", [True, 0, -1.0, float("nan"), float("inf"), "1", "1ms"])
def test_budgets_that_are_no_seconds(budget: object) -> None:
    with pytest.raises(ValueError, match="budget: got"):
        ns.solve(ns.StickSlip(**GOOD), budget=budget)  # type: ignore[arg-type]


def test_numbers_of_numpy_are_numbers() -> None:
    belt = ns.StickSlip(**GOOD)
    orbit = ns.solve(belt, "hb-ck", np.int64(8), functions=np.int64(2))  # type: ignore[arg-type]
    assert orbit.functions == 2
    assert type(orbit.functions) is int
    assert ns.solve(belt, tol=np.float32(1e-6)).method == "ck-tau"  # type: ignore[arg-type]


@pytest.mark.parametrize("times", [1j, [0.1 + 1j], np.array([0.1 + 0j])])
def test_times_that_are_not_real(times: object) -> None:
    orbit = ns.exact(ns.StickSlip(**GOOD))
    with pytest.raises(ValueError, match=r"t: got .*, expected finite times"):
        orbit.displacement(times)  # type: ignore[arg-type]
    with pytest.raises(ValueError, match=r"values: got .*, expected"):
        ns.family(orbit.case, "mass", times)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    "belt", [GOOD, None, "belt", "impact", ns.StickSlip, ns.scene("impact"), 1.0, 3]
)
@pytest.mark.parametrize(
    "function",
    [
        ns.exact,
        ns.sweep,
        lambda belt: ns.solve(belt, "c1", 7),
        lambda belt: ns.solve(belt, tol=1e-6),
        lambda belt: ns.solve(belt, budget=1.0),
        lambda belt: ns.family(belt, "mass", [1.0]),
    ],
)
def test_what_is_no_oscillator(function: Callable[[object], object], belt: object) -> None:
    with pytest.raises(TypeError, match=r"case: got .*, expected a case of ns.scene"):
        function(belt)


@pytest.mark.parametrize(
    ("wrong", "words"),
    [
        ({"orders": [0]}, r"^order: got 0, expected a whole number from 1 to"),
        ({"orders": [0, 4]}, r"^order: got 0, expected a whole number from 1 to"),
        ({"orders": []}, r"^orders: got \[\], expected whole numbers in a sequence$"),
        ({"orders": 5}, r"^orders: got 5, expected whole numbers in a sequence$"),
        ({"orders": "3-5"}, r"^orders: got '3-5', expected whole numbers in a sequence$"),
        ({"methods": []}, r"^methods: got \[\], expected names of methods in a sequence$"),
        ({"methods": 5}, r"^methods: got 5, expected names of methods in a sequence$"),
    ],
)
def test_a_sweep_of_nothing_is_refused(wrong, words, belt: ns.StickSlip) -> None:
    with pytest.raises(ValueError, match=words):
        ns.sweep(belt, **wrong)


def test_a_family_without_a_drop_of_friction_is_refused(belt: ns.StickSlip) -> None:
    with pytest.raises(ns.ParameterError, match=r"mu_k: got 0\.5, expected less than mu_s"):
        ns.family(belt, "mu_k", [0.4, 0.5])
