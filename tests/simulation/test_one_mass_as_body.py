"""Bodies of one degree of freedom move as the scenes of one mass: two ways, the same motion."""

import numpy as np
import pytest
from every_run import tried
from integrated import STARTS, random_case
from one_mass import NAMES
from one_mass_bodies import as_body, free_phase, state_of
from stops import between_two, resting

from nonsmooth.solver.kernels import registry
from nonsmooth.solver.scenes.ordered import of_all_phases
from nonsmooth.solver.simulation.bodies.machine import BodyMachine
from nonsmooth.solver.simulation.machine import Machine
from nonsmooth.solver.simulation.simulate import cycle
from nonsmooth.solver.simulation.steps.state import State
from nonsmooth.solver.simulation.walk import Place, walk

MOTIONS = [motion for name in NAMES for motion in registry.load(name).each_motion]

#: Differences of times and states: rounding of some hundred phases of a motion that is stable.
NEAR = 1e-12


def followed(case, start, cycles):
    """Return a motion as that of one mass, and as that of a body."""
    cell = case.cell
    one, other = Machine(cell), BodyMachine(as_body(cell))
    start = one.at_rest(0.3 * cell.forced) if start is None else one.remembered(start)
    begun = state_of(start, other.cell, free_phase(cell).m)
    until = cycles * cycle(cell)
    own, _, ended, _ = walk(case, one, Place.first(one, start), until)
    found, _, other_ended, _ = walk(case, other, Place.first(other, begun), until)
    return own, ended, found, other_ended


def check(own, found, near=NEAR) -> None:
    """Check that phases are the same, with their names, what ends them, times and states."""
    assert [(q.index, q.mirrored) for q in found] == [(q.index, q.mirrored) for q in own]
    assert [q.step for q in found] == [q.step for q in own]
    size = max(1.0, *(max(abs(q.x), abs(q.v)) for q in own))
    for one, other in zip(own, found, strict=True):
        assert float(other.t) == pytest.approx(float(one.t), rel=near, abs=near)
        assert [other.x, other.v] == pytest.approx([one.x, one.v], rel=0, abs=near * size)


@pytest.mark.parametrize("motion", MOTIONS, ids=lambda motion: motion.label)
def test_a_shipped_scene_as_a_body(motion) -> None:
    own, ended, found, other_ended = followed(motion(), None, 30)
    assert ended == other_ended == ""
    check(own, found)


@pytest.mark.parametrize(("gap", "frequency"), [(0.3, 0.45), (0.0005, 0.35), (0.01, 0.35)])
def test_a_rest_that_holds_all_of_a_body(gap: float, frequency: float) -> None:
    """Its place and its velocity are known where it ends: the event is one of time alone."""
    case = registry.load("impact-inelastic")(gap=gap, frequency=frequency)
    own, ended, found, other_ended = followed(case, None, 30)
    assert ended == other_ended == ""
    check(own, found)


@pytest.mark.parametrize(
    ("scene", "seed"),
    tried(
        [(scene, seed) for scene in STARTS for seed in range(25)],
        every_run=[(scene, seed) for scene in STARTS for seed in (0, 1)],
    ),
)
def test_random_parameters(scene, seed) -> None:
    """Among them gaps down to 1e-12 of the default, and impacts that accumulate."""
    rng = np.random.default_rng([seed, tuple(STARTS).index(scene)])
    case = of_all_phases(random_case(scene, rng))
    x, v = np.array(STARTS[scene]) + rng.uniform(-0.1, 0.1, 2)
    if scene == "backlash":
        x -= case.values["gap"] / case.units.length
    angle = float(rng.uniform(0, 6)) if case.cell.forced else 0.0
    own, ended, found, other_ended = followed(case, State(float(x), float(v), angle), 3)
    assert other_ended[:7] == ended[:7]
    if ended:  # impacts that accumulate, of which the last are as short as rounding
        own = [q for q in own if q.s > 1e-3]
        found = found[: len(own)]
    check(own, found, 1e-11)


@pytest.mark.parametrize("made", [resting, between_two], ids=lambda made: made.__name__)
def test_impacts_that_end_in_a_rest(made) -> None:
    """Where impacts accumulate both go over to the rest: one a few impacts before the other."""
    own, ended, found, other_ended = followed(made(0.4), None, 6)
    assert ended == other_ended == ""
    long, others = ([q for q in motion if q.s > 1e-3] for motion in (own, found))
    assert len(long) < len(own)
    check(long, others, 1e-9)


@pytest.mark.parametrize(("mu", "angle"), [(0.4, 4.0), (0.6, 1.0)])
def test_what_was_held_leaves_once_and_stops_at_the_last_digit(mu, angle) -> None:
    """With one coefficient of friction nothing but the force's rate says where it leaves to."""
    values = {"damping": 0.3, "stiffness": 2.0, "frequency": 0.6, "mu_s": mu, "mu_k": mu}
    case = of_all_phases(registry.load("dry-friction")(**values))
    own, ended, found, other_ended = followed(case, State(0.0, 0.0, angle), 6)
    assert ended == other_ended == ""
    check(own, found, 1e-14)


@pytest.mark.parametrize(
    ("restitution", "damping"),
    [(1e-9, 0.3), (1e-6, 0.3), (1e-3, 0.3), (0.3, 0.3), (0.5, 1.98), (0.5, 2 + 1e-4)],
)
def test_impacts_that_are_too_low_to_be_located_accumulate(restitution, damping) -> None:
    """Of a body a flight that is lower than rounding takes far longer than it should.

    Where its damping is almost critical, rounding is that of poles that are nearly one.
    """
    case = registry.load("impact")(restitution=restitution, frequency=0.3, damping=damping)
    own, ended, found, other_ended = followed(case, None, 6)
    assert ended.startswith("chatter: flight ends ever sooner")
    assert other_ended[:50] == ended[:50]
    one, other = (
        float(words.split("t = ")[1].split(" s")[0]) for words in (ended, other_ended)
    )
    assert other == pytest.approx(one, rel=3e-8)
    assert len(found) <= len(own)
