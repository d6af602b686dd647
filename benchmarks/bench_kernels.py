"""The compiled kernels by pytest-benchmark: residual, Jacobian and whole iteration."""

import numpy as np
import pytest

from nonsmooth.solver.shortcuts.search import kernels
from nonsmooth.solver.shortcuts.search.start import cubic_slip, rough_times, with_coefficients

ALPHA = 1.0
CASES = [("hb-symmetric", 0), ("hb-symmetric", 1), ("hb-symmetric", 3), ("c1", None)]


def _problem(module: str, terms: int | None, order: int):
    kernel, times = kernels.compiled(module), rough_times(ALPHA)
    if terms is None:
        return kernel, ALPHA, with_coefficients(kernel, ALPHA, order, *times)
    return kernel, (ALPHA, terms), cubic_slip(kernel, terms, order, *times)


@pytest.mark.parametrize("order", [10, 40])
@pytest.mark.parametrize(("module", "terms"), CASES)
def bench_residual(benchmark, module: str, terms: int | None, order: int) -> None:
    """Time one residual."""
    kernel, case, z = _problem(module, terms, order)
    benchmark(kernel.residual, case, z, np.empty(len(z)))


@pytest.mark.parametrize("order", [10, 40])
@pytest.mark.parametrize(("module", "terms"), CASES)
def bench_jacobian(benchmark, module: str, terms: int | None, order: int) -> None:
    """Time one Jacobian."""
    kernel, case, z = _problem(module, terms, order)
    benchmark(kernel.jacobian, case, z, np.empty((len(z), len(z))))


@pytest.mark.parametrize("order", [10, 40])
@pytest.mark.parametrize(("module", "terms"), CASES)
def bench_iteration(benchmark, module: str, terms: int | None, order: int) -> None:
    """Time Newton's method from the start to convergence."""
    kernel, case, z = _problem(module, terms, order)
    benchmark(lambda: kernel.iterate(case, z.copy(), 40))


@pytest.mark.parametrize("order", [5, 13])
def bench_c1_reduced(benchmark, order: int) -> None:
    """Time one orbit by the scalar equation, called from Python."""
    functions = kernels.compiled_functions("c1-reduced")
    table = functions["series_coefficients"](order)
    benchmark(functions["orbit_times"], ALPHA, order, table)
