"""Saltation as SymPy derives it, against perturbed crossings that are followed to the end."""

import numpy as np
import pytest
import sympy as sp
from small_scene import belt, scene

from nonsmooth.codegen import scenes
from nonsmooth.codegen.scene import forcing, saltation, saltations, v, x


def followed(case, start, a_before, a_after, turning, held):
    """Return where a perturbed state is behind the event, at the time of the unperturbed one.

    Motions are parabolas, the forcing changes at a constant rate; time 0 is that of the event.
    """
    zero, law = case
    low, high = -0.1, 0.1

    def at(time):
        speed = start[1] + a_before * time
        place = start[0] + start[1] * time + a_before * time**2 / 2
        return zero(place, speed, turning * time), place, speed

    for _ in range(200):
        middle = (low + high) / 2
        if (at(middle)[0] > 0) == (at(high)[0] > 0):
            high = middle
        else:
            low = middle
    _, place, speed = at(low)
    after = law(speed) if held is None else held
    back = -low
    return np.array([place + after * back + a_after * back**2 / 2, after + a_after * back])


#: Zero of the event, law, held speed behind it, speed at it, accelerations, turning.
CROSSED = {
    "impact": (x - 0.0, {v: -0.6 * v}, None, 0.7, 0.3, -0.9, 0.0),
    "prescribed impulse": (x - 0.0, {v: v + 0.4}, None, 0.7, 0.3, -0.9, 0.0),
    "kink": (x - 0.0, {}, None, 0.7, 0.3, 0.3, 0.0),
    "reversal": (v, {}, None, 0.0, -0.4, -0.9, 0.0),
    "stick begins": (v - 0.5, {}, 0.5, 0.5, 0.3, 0.0, 0.0),
    "inelastic stop": (x - 0.0, {v: 0.0}, 0.0, 0.7, 0.3, 0.0, 0.0),
    "forced event": (x - 2 * forcing, {}, None, 0.7, 0.3, -0.9, 0.8),
    "released from rest": (x - 2 * forcing, {}, None, 0.0, 0.0, -0.9, 0.8),
    "all in one": (x + 0.5 * v - 2 * forcing, {v: -0.3 * v}, None, 0.7, 0.3, -0.9, 0.8),
}


@pytest.mark.parametrize("name", CROSSED)
def test_it_is_what_perturbed_crossings_come_to(name) -> None:
    zero, jump, held, speed, a_before, a_after, turning = CROSSED[name]
    place = float(sp.solve(zero.subs({v: speed, forcing: 0}), x)[0]) if zero.has(x) else 0.0
    left = scene().phases[0]
    left = type(left)("left", left.equation, type(left.ends)(zero, jump))
    matrix = saltation.saltation(left, left, 0)
    values = {
        v: speed, saltation.before: a_before, saltation.after: a_after,
        saltation.turning: turning,
    }  # fmt: skip
    found = np.array(matrix.subs(values), dtype=float)
    case = (
        sp.lambdify((x, v, forcing), zero),
        sp.lambdify(v, jump.get(v, v)),
    )
    step = 1e-5
    for column, unit in enumerate(np.eye(2)):
        ends = [
            followed(
                case, [place, speed] + sign * step * unit, a_before, a_after, turning, held
            )
            for sign in (1, -1)
        ]
        difference = (ends[0] - ends[1]) / (2 * step)
        assert found[:, column] == pytest.approx(difference, abs=1e-8)


def test_the_scenes_of_the_program() -> None:
    """The table of the field, each entry as it is known there."""
    r, V = sp.symbols("r V", positive=True)
    a_after, a_before = saltation.after, saltation.before
    (impact,) = saltations(scenes.load("impact"))
    assert impact == sp.Matrix([[-r, 0], [(a_after + a_before * r) / v, -r]])
    assert sp.factor(impact.det()) == r**2
    lands, lifts_off = saltations(scenes.load("impact-inelastic"))
    assert lands == sp.zeros(2)
    assert lifts_off == sp.eye(2)
    for name in ("stick-slip", "stick-slip-damped"):
        stick, slip = saltations(scenes.load(name))
        assert stick == sp.Matrix([[1, 0], [a_after / V, 1]])
        assert slip == sp.diag(1, 0)
        assert (sp.factor(stick.det()), slip.det()) == (1, 0)


def test_what_a_constraint_says_is_put_in() -> None:
    stick, slip = saltations(belt())
    assert stick.free_symbols == {sp.Symbol("V", positive=True), saltation.after}
    assert slip == sp.diag(1, 0)
