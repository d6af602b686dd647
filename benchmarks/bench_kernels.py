"""The compiled kernels of the belt by pytest-benchmark: residual, Jacobian, iteration."""

import numpy as np
import pytest

import nonsmooth as ns
from nonsmooth.solver.kernels import registry
from nonsmooth.solver.kernels.start import with_coefficients

METHODS = ("hb", "hb-c1", "ck", "ck-tau")


def _problem(method: str, order: int):
    case = ns.scene("stick-slip")()
    kernel = registry.kernel(case.scene, method, compile_it=True)
    times = np.array([2.1, 4.6])
    start = np.zeros(kernel.size(order))
    start[-2:] = times
    given = kernel.given(case, order)
    if not kernel.condensed:
        start = with_coefficients(kernel, given, kernel.size(order), times)
    return kernel, given, start


@pytest.mark.parametrize("order", [10, 40])
@pytest.mark.parametrize("method", METHODS)
def bench_residual(benchmark, method: str, order: int) -> None:
    """Time one residual."""
    kernel, case, z = _problem(method, order)
    benchmark(kernel.residual, case, z, np.empty(len(z)))


@pytest.mark.parametrize("order", [10, 40])
@pytest.mark.parametrize("method", METHODS)
def bench_jacobian(benchmark, method: str, order: int) -> None:
    """Time one Jacobian."""
    kernel, case, z = _problem(method, order)
    benchmark(kernel.jacobian, case, z, np.empty((len(z), len(z))))


@pytest.mark.parametrize("order", [10, 40])
@pytest.mark.parametrize("method", METHODS)
def bench_iteration(benchmark, method: str, order: int) -> None:
    """Time Newton's method from the start to convergence."""
    kernel, case, z = _problem(method, order)
    benchmark(lambda: kernel.iterate(case, z.copy(), 40))
