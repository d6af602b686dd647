"""A scene in another order of phases: its symbols say what the solver makes of its numbers."""

from dataclasses import replace

import pytest

import nonsmooth as ns
from nonsmooth.codegen import scenes
from nonsmooth.codegen.scene import in_order, v, x
from nonsmooth.codegen.scenes.impact_two_sided import g as gap
from nonsmooth.solver.in_order import cases_in_order

ORDERS = [
    ("impact", "flight,flight"),
    ("dry-friction", "slide,stop,-slide,stop,mirrored"),
    ("elastic-plastic", "elastic,plastic,-elastic,-plastic"),
    ("elastic-plastic", "elastic,plastic,elastic,plastic,mirrored"),
]


@pytest.mark.parametrize(("name", "order"), ORDERS)
def test_the_numbers_are_those_of_the_solver(name: str, order: str) -> None:
    ordered = replace(in_order(scenes.load(name), order), name="ordered", motion="")
    own = ns.scene(ordered)().cell
    cases = {case.scene.motion: case for case in cases_in_order(ns.scene(name)(), order)}
    other = cases[order].cell
    assert (own.sign, own.memory, own.classes) == (other.sign, other.memory, other.classes)
    assert [_nameless(phase) for phase in own.phases] == [_nameless(q) for q in other.phases]


def test_a_rest_sets_what_suits_the_phase_before_it() -> None:
    """It is named by how it ends: behind the mirror image it begins as the mirror image."""
    order = "slip,stick,-slip,stick,mirrored"
    ordered = replace(in_order(scenes.load("jenkins-absorber"), order), name="o", motion="")
    (case,) = cases_in_order(ns.scene("jenkins-absorber")(), order)
    assert ns.scene(ordered)().cell.memory == case.cell.memory
    first, second = (q.value[3] for q in case.cell.memory)
    assert first == -second < 0


def _nameless(phase):
    """Return a phase of a cell without its name and the words of its demands."""
    demands = tuple(("", form) for _, form in phase.demands)
    at_the_switch = tuple(("", form) for _, form in phase.switch_demands)
    return replace(phase, name="", demands=demands, switch_demands=at_the_switch)


def test_a_scene_may_be_odd_without_saying_so() -> None:
    whole = in_order(scenes.load("impact-two-sided"), "crossing,-crossing")
    half = in_order(whole, "crossing,mirrored")
    assert half.half_period
    assert half.phases == whole.phases[:1]
    first, second = whole.phases
    for change in ({"zero": x - 2 * gap}, {"jump": {v: -v / 3}}):
        other = replace(second, ends=replace(second.ends, **change))
        uneven = replace(whole, phases=(first, other))
        with pytest.raises(ValueError, match="a mirror image is no motion of impact-two-sided"):
            in_order(uneven, "crossing,mirrored")


@pytest.mark.parametrize(
    ("name", "order", "words"),
    [
        ("dry-friction", "slid,stop", "got 'slid', expected one of slide, stop"),
        ("dry-friction", "stop,stop", "got stop,stop, which is no order: .* only held ones"),
        ("impact", "flight,-flight", "got '-flight', expected one of flight"),
        ("impact", "flight,mirrored", "got mirrored, but a mirror image is no motion"),
        ("chain-impact", "flight,mirrored", "got mirrored"),
        ("elastic-plastic", "plastic", "expected elastic among them: it sets displacement"),
    ],
)
def test_what_is_no_order_is_refused(name: str, order: str, words: str) -> None:
    with pytest.raises(ValueError, match=f"phases: {words}"):
        in_order(scenes.load(name), order)
