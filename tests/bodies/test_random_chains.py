"""Chains of random parameters: their orbits close and keep their demands, by another way.

The whole chain is moved on by matrix exponentials in physical coordinates, without modes, poles
or the forces of the solver: from the periodic state that the times of the switches leave.
"""

import numpy as np
import pytest
import sympy as sp
from every_run import tried
from exponentials import generator, repeating
from made_scenes import in_a_row, parameters, scene_of
from scipy.linalg import expm

import nonsmooth as ns
from nonsmooth.scene import Body, Event, Phase
from nonsmooth.solver.scenes.loaded import LoadedScene

#: Masses of a chain, points of a phase at which demands are looked at, and chains drawn of one
#: seed: more until one has an orbit.
COUNT, POINTS, DRAWN = 4, 2000, 8
LINKS = in_a_row([1] * COUNT)

SEEDS = {f"seed {seed}": seed for seed in range(50)}


def chain(phases: str) -> LoadedScene:
    """Return the scene of a row of masses with an elastic or a rigid stop."""
    m, k, stop, g, F, Omega = sp.symbols("m k stop g F Omega", positive=True)
    c, r = sp.symbols("c r", nonnegative=True)
    row = Body(
        M=m * sp.eye(COUNT), K=k * sp.Matrix(LINKS), C=c * sp.Matrix(LINKS),
        forcing=sp.Matrix([F, *[0] * (COUNT - 1)]), at={"end": [0] * (COUNT - 1) + [1]},
    )  # fmt: skip
    end = row.at["end"]
    before = {"before the stop": g - end.x}
    rigid = Phase("flight", end.force, Event(end.x - g, jump={end.v: -r * end.v}), before)
    soft = (
        Phase("touch", end.force + stop * (end.x - g), Event(end.x - g), {"in": end.x - g}),
        Phase("free", end.force, Event(end.x - g), before),
    )
    own = parameters(
        mass=(m, "kg", 0.5), stiffness=(k, "N/m", 0.5), damping=(c, "N s/m", 0.5),
        force=(F, "N", 0.5), frequency=(Omega, "rad/s", 0.5), gap=(g, "m", 0.5),
    )  # fmt: skip
    if phases == "rigid":
        own += parameters(restitution=(r, "", 0.5))
        return scene_of("rigid-stop", own, rigid, body=row)
    return scene_of("elastic-stop", own + parameters(stop=(stop, "N/m", 0.5)), *soft, body=row)


@pytest.fixture(scope="module", params=["rigid", "elastic"])
def scene(request):
    """Return a chain, derived once."""
    return chain(request.param)


def moved(values, stop: float) -> np.ndarray:
    """Return the generator of a chain, on its stop where that has a stiffness."""
    first, last = np.eye(COUNT)[[0, -1]]
    K = values["stiffness"] * LINKS + stop * np.outer(last, last)
    return generator(
        values["mass"] * np.eye(COUNT), K, values["damping"] * LINKS, values["force"] * first,
        values["frequency"], stop * values["gap"] * last,
    )  # fmt: skip


@pytest.mark.parametrize("seed", tried(SEEDS, every_run=("seed 0", "seed 1")))
def test_an_orbit_closes_and_keeps_its_demands(scene, seed) -> None:
    random = np.random.default_rng(SEEDS[seed])
    rigid = scene.name == "rigid-stop"
    found, tries = 0, 0
    while tries < DRAWN or not found:
        tries += 1
        values = {q.name: random.uniform(0.3, 1.5) for q in scene.parameters}
        values["damping"] = random.uniform(0.02, 0.3)
        if rigid:
            values["restitution"] = random.uniform(0.2, 0.9)
        case = scene(**values)
        try:
            orbit = ns.exact(case)
        except ns.NoOrbit:
            continue
        found += 1
        assert off(orbit, values, rigid) < 1e-9


def off(orbit, values, rigid: bool) -> float:
    """Return how far an orbit is from its switches and beyond its demands, in gaps."""
    n, gap = COUNT, values["gap"]
    jump = np.eye(2 * n + 3)
    if rigid:
        jump[2 * n - 1, 2 * n - 1] = -values["restitution"]
    stops = [values["stop"] if phase.name == "touch" else 0.0 for phase in orbit.phases]
    flows = [moved(values, stop) for stop in stops]
    period = np.eye(2 * n + 3)
    for A, phase in zip(flows, orbit.phases, strict=True):
        period = jump @ expm(A * phase.duration) @ period
    X, worst = repeating(period, orbit.forcing_phase), 0.0
    for A, phase, stop in zip(flows, orbit.phases, stops, strict=True):
        step = expm(A * phase.duration / POINTS)
        side = -1.0 if stop else 1.0
        for _ in range(POINTS):
            worst = max(worst, side * (X[n - 1] - gap))
            X = step @ X
        worst = max(worst, abs(X[n - 1] - gap))
        X = jump @ X
    return float(worst / gap)
