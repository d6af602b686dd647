"""Functions of bodies compiled by numba give what they give as plain Python.

Compiling takes a minute each: `.ci/run` runs these, `make test` does not.
"""

import numpy as np
import pytest
from bodies.reference_bodies import case

import nonsmooth as ns
from nonsmooth.solver.branch import walk
from nonsmooth.solver.branch.bodies.course import BodyCourse
from nonsmooth.solver.kernels import registry

#: Springs, a memory, nothing that forces, several impulses, several contacts.
KINDS = (
    *("clearance-2", "jenkins-absorber", "belt-2", "impact-3-two-impacts"),
    "two-stops-six-phases",
)


@pytest.mark.long
def test_compiled_force_series() -> None:
    for name in KINDS:
        own, values = case(name), []
        times = ns.exact(own).times
        for compile_it in (False, True):
            kernel = registry.kernel(own.scene, "ck-tau", compile_it=compile_it)
            R, J = np.empty(len(times)), np.empty((len(times), len(times)))
            for order in (1, 8, 40):  # of the last pieces
                kernel.residual(kernel.given(own, order), times, R)
                kernel.jacobian(kernel.given(own, order), times, J)
                values.append(np.append(R, J))
        plain, compiled = np.split(np.array(values), 2)
        assert compiled == pytest.approx(plain, abs=1e-11 * np.abs(plain).max())


@pytest.mark.long
def test_compiled_branches(monkeypatch) -> None:
    own, found = case("jenkins-absorber"), []
    for form in ("plain", "compiled"):
        functions = getattr(BodyCourse.family, form)(walk.__name__)
        by = lambda course, name, *given, own=functions: own[name](*given)  # noqa: E731
        monkeypatch.setattr(BodyCourse, "by", by)
        middle = own.values["frequency"]
        branch = ns.branch(own, "frequency", 0.95 * middle, 1.02 * middle)
        found.append([(row.value, row.period, *row.durations) for row in branch.rows])
    assert np.array(found[1]) == pytest.approx(np.array(found[0]), rel=1e-9)
