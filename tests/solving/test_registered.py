"""A method is registered wherever methods are listed: what a new expansion must not miss."""

import re
from collections.abc import Iterable

import numpy as np
import pytest
from paper import METHODS
from shown import PAGES

import nonsmooth as ns
from nonsmooth import codegen, style
from nonsmooth.cli.shortcuts import equations
from nonsmooth.codegen.shortcuts import emit
from nonsmooth.files.shortcuts import origin
from nonsmooth.report import paper
from nonsmooth.shortcuts import tradeoff
from nonsmooth.solver.shortcuts.choice import budget
from nonsmooth.solver.shortcuts.orbit import methods
from nonsmooth.solver.shortcuts.orbit.oscillator import DEFAULT
from nonsmooth.solver.shortcuts.search import kernels

#: Lists of methods that are to be the same, in the order of the guide in CONTRIBUTING.md.
LISTS: dict[str, Iterable[str]] = {
    "solver/shortcuts/orbit/methods.py: METHODS": methods.METHODS,
    "solver/shortcuts/choice/budget.py: ORDERS": budget.ORDERS,
    "src/nonsmooth/shortcuts/tradeoff.py: ORDERS": dict.fromkeys(
        name for name, _ in tradeoff.ORDERS if name in codegen.METHODS
    ),
    "src/nonsmooth/cli/shortcuts/equations.py: METHODS": equations.METHODS,
    "src/nonsmooth/style.py: STYLES": style.STYLES,
    "src/nonsmooth/style.py: LABELS": style.LABELS,
    "src/nonsmooth/report/paper.py: METHODS": paper.METHODS,
    "src/nonsmooth/files/shortcuts/origin.py: COEFFICIENTS": origin.COEFFICIENTS,
    "tests/paper.py: METHODS": METHODS,
}


@pytest.mark.parametrize("place", LISTS)
def test_every_derived_method_is_registered(place: str) -> None:
    assert list(LISTS[place]) == list(codegen.METHODS)


def test_the_command_knows_what_is_solved() -> None:
    assert tuple(codegen.SOLVED) == equations.SOLVED


@pytest.mark.parametrize("method", codegen.METHODS)
def test_every_method_has_loops_and_a_module_of_kernels(method: str) -> None:
    assert method in emit.LOOPS
    assert method in kernels.MODULES


@pytest.mark.parametrize("method", codegen.METHODS)
def test_family_and_amplitude_are_those_of_the_method(method: str) -> None:
    orbit = ns.solve(DEFAULT, method, 5)
    family = ns.family(DEFAULT, "belt_speed", [DEFAULT.belt_speed], method, 5)
    x = orbit.displacement(np.linspace(0, orbit.period, 10_001))
    assert family["period"] == pytest.approx(orbit.period, rel=1e-12)
    assert orbit.amplitude == pytest.approx((x.max() - x.min()) / 2, rel=1e-6)


def test_every_method_is_in_the_table_of_its_page() -> None:
    table = PAGES["docs/method/paper.md"].split("## The three methods")[1].split("\n## ")[0]
    assert re.findall(r"^\| `([\w-]+)` \|", table, re.MULTILINE) == list(codegen.METHODS)
