"""``--method`` and ``--methods``, ``--order`` and ``--orders``: one thing by either name."""

import json

import pytest

from nonsmooth.cli.aliases import OneOrder, split_methods

SCENES = [(), ("impact",)]


@pytest.mark.parametrize("scene", SCENES, ids=["paper", "impact"])
@pytest.mark.parametrize(
    ("command", "shown", "other"),
    [
        ("solve", ("--method", "--order"), ("--methods", "--orders")),
        ("sweep", ("--methods", "--orders"), ("--method", "--order")),
    ],
)
def test_both_names_are_understood_and_one_is_shown(
    run, command: str, scene: tuple[str, ...], shown: tuple[str, ...], other: tuple[str, ...]
) -> None:
    found = []
    for method, order in (shown, other):
        status, out, _ = run(command, *scene, method, "hb", order, 4, "--json")
        document = json.loads(out)
        for each in (document, *document.get("rows", ())):
            for name in ("seconds", "sha256"):
                each.pop(name, None)
        found.append((status, document))
    assert found[0][0] == 0
    assert found[0] == found[1]
    _, help_, _ = run(command, *scene, "--help")
    words = help_.split("Options:")[1].split()
    assert set(shown) <= {*words}
    assert not {*other} & {*words}


@pytest.mark.parametrize("scene", SCENES, ids=["paper", "impact"])
def test_solve_takes_several_methods(run, scene: tuple[str, ...]) -> None:
    names = "hb,ck"
    status, out, _ = run("solve", *scene, "--method", names, "--order", 5, "--json")
    orbits = json.loads(out)["orbits"]
    assert status == 0
    _, every, _ = run("solve", *scene, "--order", 5, "--json")
    every = {each["method"]: each for each in json.loads(every)["orbits"]}
    assert len(orbits) == 2
    for each in orbits:
        assert each["period"] == every[each["method"]]["period"]
    status, _, err = run("solve", *scene, "--method", names, "--tol", 1e-3)
    assert status == 2
    assert "expected one method" in err


@pytest.mark.parametrize("scene", SCENES, ids=["paper", "impact"])
@pytest.mark.parametrize("orders", ["4-6", "4,8", "10,20,...,80"])
def test_several_orders_are_left_to_sweep(run, scene: tuple[str, ...], orders: str) -> None:
    status, out, err = run("solve", *scene, "--method", "hb", "--orders", orders)
    assert (status, out) == (2, "")
    assert f"--order: got {orders!r}, expected one order" in err
    assert f"nonsmooth sweep --orders {orders}" in err


@pytest.mark.parametrize("text", ["7", "7-7", "7,7", "07"])
def test_one_order_however_it_is_written(text: str) -> None:
    assert OneOrder()(text) == 7


def test_a_list_of_methods_has_each_once() -> None:
    assert split_methods("hb , c1,hb") == ["hb", "c1"]
