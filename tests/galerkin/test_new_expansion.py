"""An expansion of one's own is one file: the guide of CONTRIBUTING.md, followed."""

import sys
import types
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from nonsmooth.codegen import expansions, generate
from nonsmooth.codegen.emission import phase_maps
from nonsmooth.codegen.emission.method_table import methods_source
from nonsmooth.codegen.expansions import ck
from nonsmooth.codegen.galerkin import polynomials
from nonsmooth.codegen.scenes import load
from nonsmooth.solver.kernels import registry
from nonsmooth.solver.scenes.methods import METHODS
from nonsmooth.solver.solve import solve_case

#: Step 1: the file.  The tests are sums of neighbouring Legendre polynomials, which span the
#: same space as the polynomials themselves but for the last; what none of them sees has
#: coefficients of alternating sign.
FILE = '''"""Functions of class C^k, tested with sums of neighbours (`ck-pairs`)."""

import sympy as sp

from nonsmooth.codegen.galerkin import GalerkinConditions, polynomials
from nonsmooth.codegen.scene import Scene

METHOD = "ck-pairs"
TITLE = "functions of class C^k, tested with sums of two Legendre polynomials"


def test(l: sp.Expr, k: int) -> dict[sp.Expr, sp.Expr]:
    """Return ``P_l* + P_(l+1)*``, whatever the class."""
    return {l: 2 * l + 1, l + 1: 2 * l + 3}


def rest(m: sp.Expr, l: sp.Expr, k: int) -> sp.Expr:
    """Return the weight of ``P_l*`` in the polynomial of degree m that no test below m sees."""
    return (-1) ** (m - l)


def derive(scene: Scene) -> GalerkinConditions:
    """Return the conditions of a scene in this expansion."""
    return polynomials.derive(scene, METHOD, TITLE, test, rest)
'''


@pytest.fixture
def own_expansion(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """Put the file beside the expansions that there are, and nothing else."""
    folder = tmp_path / "expansions"
    folder.mkdir()
    (folder / "ck_pairs.py").write_text(FILE, encoding="utf-8")
    monkeypatch.setattr(expansions, "__path__", [*expansions.__path__, str(folder)])
    expansions.modules.cache_clear()
    yield
    expansions.modules.cache_clear()


@pytest.mark.usefixtures("own_expansion")
def test_a_file_is_all_that_an_expansion_takes(monkeypatch: pytest.MonkeyPatch) -> None:
    made = types.ModuleType("nonsmooth.generated.ck_pairs")  # step 2: make generate
    made.__file__ = str(generate.FOLDER / "ck.py")
    exec(phase_maps.module_source(expansions.modules()["ck_pairs"]), vars(made))
    table: dict[str, Any] = {}
    exec(methods_source(), table)
    monkeypatch.setitem(sys.modules, made.__name__, made)
    monkeypatch.setitem(METHODS, "ck-pairs", table["METHODS"]["ck-pairs"])
    scene = registry.load("impact")
    assert "ck-pairs" in registry.methods(scene)
    orbit = solve_case(scene(), "ck-pairs", 12)
    best = solve_case(scene(), "ck-tau", 20)
    assert orbit.admissible
    assert orbit.period == pytest.approx(best.period, rel=1e-13)
    error = abs(orbit.forcing_phase - best.forcing_phase) / (2 * np.pi)
    assert 1e-9 < error < 1e-5  # an expansion of its own: neither wrong nor ck-tau
    assert orbit.estimate.times == pytest.approx(error, rel=0.01)


def test_what_the_tests_see_is_not_left_of_the_residual() -> None:
    with pytest.raises(ValueError, match="test 3 sees the polynomial of degree 4 at class C"):
        polynomials.derive(load("impact"), "ck", "", ck.test, lambda m, l, k: 1)
    with pytest.raises(ValueError, match="rest: got none, and a test of C\\^0 reaches beyond"):
        polynomials.derive(load("impact"), "ck", "", ck.test)
