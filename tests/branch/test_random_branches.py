"""Branches of random oscillators along a random parameter: every orbit on them is one."""

import numpy as np
import pytest
from branch.test_events import exactly
from one_mass import NAMES

import nonsmooth as ns
from nonsmooth.solver.kernels import registry
from nonsmooth.solver.no_orbit import NoOrbit

#: Scenes of bodies, and how many modes these have.
BODIES = sorted(set(registry.names()) - set(NAMES))
MODES = 4.0

#: Branches of one block, and orbits of each that are found again.
BRANCHES, ORBITS = 3, 4


def drawn(random, names):
    """Return a case of a shipped scene, a parameter of it, and a range of that."""
    scene = ns.scene(random.choice(names))
    values = {}
    for q in scene.parameters:
        value = q.default * np.exp(random.uniform(-0.5, 0.5)) if q.default else 0.0
        values[q.name] = float(value if q.most is None else min(value, q.most))
    if "mu_k" in values:
        values["mu_k"] = min(values["mu_k"], 0.9 * values["mu_s"])
    if "modes" in values:
        values["modes"] = MODES
    varied = [q for q in scene.parameters if q.name != "modes" and values[q.name]]
    vary = varied[random.integers(len(varied))]
    low, high = 0.6 * values[vary.name], 1.6 * values[vary.name]
    if vary.name in {"mu_k", "mu_s"}:
        low, high = 0.95 * values[vary.name], 1.05 * values[vary.name]
    high = high if vary.most is None else min(high, vary.most)
    return scene(**values), vary.name, low, high


def seeds(names, most: int, count: int):
    """Return parameters of a test: what is drawn from, how many branches, seeds."""
    first, *others = ((names, most, seed) for seed in range(1, count))
    return [first, *(pytest.param(*other, marks=pytest.mark.long) for other in others)]


@pytest.mark.parametrize(
    ("names", "most", "seed"), [*seeds(NAMES, BRANCHES, 40), *seeds(BODIES, 1, 20)]
)
def test_every_orbit_of_a_random_branch_is_one(names, most: int, seed: int) -> None:
    random = np.random.default_rng(seed)
    count = 0
    while count < most:
        case, parameter, low, high = drawn(random, names)
        try:
            branch = ns.branch(case, parameter, low, high)
        except (NoOrbit, ns.ParameterError):
            continue
        count += 1
        assert low <= branch["value"].min() <= branch["value"].max() <= high
        special = {
            event.parameter for event in branch.events
        }  # folds: times alone are not found
        rows = [
            q for q in list(branch)[1:-1] if q.stable is not None and q.value not in special
        ]
        rows = [q for q in rows if not (q.motion or "").startswith("only ")]
        for i in random.permutation(len(rows))[:ORBITS]:
            exact = exactly(branch, rows[i])
            if exact.stable is None:  # what rounding may change is judged by other states
                largest = np.abs(rows[i].multipliers).max()
                assert np.abs(exact.multipliers).max() == pytest.approx(largest, rel=1e-8)
            else:
                assert exact.stable == rows[i].stable
            total = sum(rows[i].durations)
            assert exact.durations == pytest.approx(rows[i].durations, abs=1e-8 * total)
