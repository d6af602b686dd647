"""Whatever is compiled is of types that numba finds: of every family, on real arguments.

Compiling all of them takes minutes, and most of that goes to machine code.  Here numba goes as
far as the types of each function, where it refuses what it does not know, and the function then
runs as plain Python.  That takes half a minute: `.ci/run` runs these, `make test` does not.
"""

import sys
from collections.abc import Callable, Iterator

import pytest

import nonsmooth as ns
from nonsmooth.solver.branch import walk
from nonsmooth.solver.branch.bodies.course import BODIES
from nonsmooth.solver.charts import block
from nonsmooth.solver.kernels import bodies, polynomials, series
from nonsmooth.solver.kernels.account import Account
from nonsmooth.solver.kernels.compiling import rebuilt
from nonsmooth.solver.kernels.family import Family
from nonsmooth.solver.solve import solve_case


def typed_only():
    """Return what makes functions of which numba finds the types, and makes no code."""
    import numba
    from numba.core import compiler, typing
    from numba.core.compiler_machinery import FunctionPass, PassManager, register_pass
    from numba.core.typed_passes import NopythonTypeInference

    @register_pass(mutates_CFG=False, analysis_only=True)
    class SignatureAlone(FunctionPass):
        _name = "signature_alone"

        def __init__(self) -> None:
            super().__init__()

        def run_pass(self, state) -> bool:
            unset = dict.fromkeys(compiler.CR_FIELDS)
            found = typing.signature(state.return_type, *state.args)
            known = {
                "typing_context": state.typingctx,
                "target_context": state.targetctx,
                "signature": found,
                "entry_point": [].append,  # any builtin that is no other's
                "objectmode": False,
                "metadata": {},
            }
            state.cr = compiler.compile_result(**unset | known)
            return False

    class TypesAlone(compiler.CompilerBase):
        def define_pipelines(self) -> list[PassManager]:
            untyped = compiler.DefaultPassBuilder.define_untyped_pipeline(self.state)
            found = PassManager("types")
            found.passes.extend(untyped.passes)
            found.add_pass(NopythonTypeInference, "types")
            found.add_pass(SignatureAlone, "the signature")
            found.finalize()
            return [found]

    def make(function, names, counted):
        options = {"pipeline_class": TypesAlone, "error_model": "numpy"}
        return numba.njit(**options)(rebuilt(function, names))

    return make


pytestmark = pytest.mark.long


@pytest.fixture
def looked_at(monkeypatch: pytest.MonkeyPatch) -> Iterator[Callable[..., set[str]]]:
    """Return a function that has numba look at what Python calls of a family, and its names."""
    import numba

    make, plain, typed, known = typed_only(), Family.plain.__wrapped__, {}, set()

    def dispatchers(family: Family, name: str):
        if (family, name) not in typed:
            typed[family, name] = family.link(sys.modules[name], make)
        return typed[family, name]

    def looking(function, dispatcher):
        def call(*arguments):
            if not dispatcher.overloads:
                dispatcher.compile(tuple(map(numba.typeof, arguments)))
                known.add(function.__name__)
            return function(*arguments)

        return call

    def begin(family: Family) -> set[str]:
        def both(of: Family, name: str):
            found, own = plain(of, name), dispatchers(of, name) if of is family else {}
            return found | {
                key: looking(found[key], q)
                for key, q in own.items()
                if hasattr(q, "overloads") and key != "motion"  # which no kernel has compiled
            }

        monkeypatch.setattr(Family, "plain", both)
        return known

    for form in ("inner", "compiled"):
        monkeypatch.setattr(Family, form, dispatchers)
    monkeypatch.setattr(Account, "pays", lambda account: False)
    monkeypatch.setattr(Account, "is_cached", lambda account: False)
    Family.kernel.cache_clear()
    yield begin
    Family.kernel.cache_clear()


@pytest.mark.parametrize(
    ("family", "method", "last"),
    [
        (polynomials.FAMILY, "ck-tau", "iterate_together"),
        (series.FAMILY, "hb-ck", "iterate_scene"),
    ],
)
def test_methods(family: Family, method: str, last: str, looked_at) -> None:
    names = looked_at(family)
    solve_case(ns.scene("clearance")(), method, 4)
    assert last in names


def test_branches(looked_at) -> None:
    names = looked_at(walk.FAMILY)
    ns.branch(ns.scene("impact")(damping=0.1, restitution=0.8), "frequency", 2.4, 2.5)
    assert "asked" in names


def test_branches_of_bodies(looked_at) -> None:
    names = looked_at(BODIES)
    ns.branch(ns.scene("chain-impact")(frequency=0.5), "gap", 0.5, 1.0)
    assert "asked" in names


def test_force_series(looked_at) -> None:
    names = looked_at(bodies.FAMILY)
    solve_case(ns.scene("beam-clearance")(modes=2), "ck-tau", 4)
    solve_case(ns.scene("jenkins-absorber")(), "ck-tau", 4)
    assert {"iterate_scene"} <= names


def test_maps(looked_at) -> None:
    names = looked_at(block.FAMILY)
    stop = ns.scene("impact")(damping=0.1, restitution=0.8)
    ns.chart(stop, {"frequency": (2.0, 2.1, 2), "gap": (0.0, 0.02, 2)})
    assert {"sown", "fill"} <= names


def test_maps_of_bodies(looked_at) -> None:
    names = looked_at(block.OF_BODIES)
    row = ns.scene("chain-impact")()
    ns.chart(row, {"gap": (0.4, 0.41, 2), "restitution": (0.6, 0.61, 2)})
    assert {"sown", "fill"} <= names
