"""Bad arguments from Python: an error that names the argument, the value, what was expected."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import nonsmooth as ns
from nonsmooth.kim_perkins import SECTION_4 as GOOD


def test_python_names_all_wrong_parameters() -> None:
    with pytest.raises(ValueError, match=r"mass.*stiffness.*mu_k") as caught:
        ns.StickSlip(**(GOOD | {"mass": 0, "stiffness": -1, "mu_k": -1}))
    assert len(caught.value.errors) == 3


@pytest.mark.parametrize("number", [np.float32(10), np.int64(10), 10])
def test_python_takes_any_real_number(number) -> None:
    belt = ns.StickSlip(**(GOOD | {"mass": number}))
    assert type(belt.mass) is float


#: What `solve` does not take, and what is said of it.
REFUSED = [
    *(({"order": order}, "order: got") for order in (0, -1, 10**6, 2.0, 2.5, "3", True)),
    *(({"method": method}, f"method: got {method!r}") for method in ("C1", "c1", "", 3)),
    *(
        ({"budget": budget}, "budget: got")
        for budget in (True, 0, -1.0, float("nan"), float("inf"), "1", "1ms")
    ),
    *(
        ({"tol": tol}, f"tol: got {tol}")
        for tol in (0.0, True, float("nan"), float("inf"), -0.1)
    ),
    *(({"tol": tol}, "tol: got") for tol in (np.True_, "1e-3")),
    ({"tol": 0.1, "order": 3}, "order: got 3 beside"),
    ({"budget": 1.0, "order": 3}, "order: got 3 beside a budget"),
    ({"budget": 1.0, "tol": 1e-3}, "beside a tolerance"),
    ({"method": "hb", "functions": 2}, "functions: got 2"),
]


@pytest.mark.parametrize(("arguments", "words"), REFUSED, ids=str)
def test_python_names_a_wrong_argument(arguments: dict[str, Any], words: str) -> None:
    with pytest.raises(ValueError, match=words):
        ns.solve(ns.scene("impact")(), **arguments)


def test_numbers_of_numpy_are_numbers() -> None:
    belt = ns.StickSlip(**GOOD)
    orbit = ns.solve(belt, "hb-ck", np.int64(8), functions=np.int64(2))  # type: ignore[arg-type]
    assert orbit.functions == 2
    assert type(orbit.functions) is int
    assert ns.solve(belt, tol=np.float32(1e-6)).method == "ck-tau"  # type: ignore[arg-type]


@pytest.mark.parametrize("times", [1j, [0.1 + 1j], np.array([0.1 + 0j]), "a"])
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
    with pytest.raises(TypeError, match=r"case: got .*, expected a case, such as ns.scene"):
        function(belt)


@pytest.mark.parametrize(
    ("wrong", "words"),
    [
        ({"orders": [0]}, r"^order: got 0, expected a whole number from 1 to"),
        ({"orders": [0, 4]}, r"^order: got 0, expected a whole number from 1 to"),
        ({"orders": []}, r"^orders: got \[\], expected whole numbers in a sequence$"),
        ({"orders": 5}, r"^orders: got 5, expected whole numbers in a sequence$"),
        ({"orders": "3-5"}, r"^orders: got '3-5', expected whole numbers in a sequence$"),
        ({"orders": b"35"}, r"^orders: got b'35', expected whole numbers in a sequence$"),
        ({"functions": np.array([1, 2])}, r"^functions: got array.*, expected a whole number"),
        ({"functions": True}, r"^functions: got True, expected a whole number from 1$"),
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
