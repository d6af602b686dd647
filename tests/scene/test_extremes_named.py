"""The extremes that a scene names: checked when it is made, and written as numbers."""

from dataclasses import replace

import pytest
import sympy as sp

from nonsmooth.codegen import scenes
from nonsmooth.codegen.emission.scene_numbers import scene_source
from nonsmooth.codegen.scene import SceneError
from nonsmooth.solver.kernels import registry

IMPACT = scenes.load("impact")
m, c, k, F, Omega, g, r = IMPACT.symbols


@pytest.mark.parametrize(
    ("extremes", "words"),
    [
        ({"far": {sp.Symbol("q"): 1}}, "extremes 'far': q is not a parameter of the scene"),
        ({"far": {g: sp.Symbol("q")}}, "extremes 'far': q is not a parameter of the scene"),
        ({"far": {g: F}}, "extremes 'far': g is set to F, which is in kg m/s^2, expected m"),
        ({"far": {r: 1.5}}, "r is 1.5 of the default parameters, expected a number above 0"),
        ({"far": {c: -c}}, "c is -c of the default parameters, expected a number 0 or more"),
        (
            {"far": {g: "wide"}},
            "extremes 'far': got 'wide', expected a number or an expression",
        ),
        ({"far": {}}, "extremes 'far': expected text, and a mapping {symbol: value}"),
        ({"far": 3}, "extremes 'far': expected text, and a mapping {symbol: value}"),
        ([], "extremes: expected a mapping {words: {symbol: value}}"),
    ],
)
def test_a_wrong_one_is_one_line(extremes, words) -> None:
    with pytest.raises(SceneError) as caught:
        replace(IMPACT, extremes=extremes)
    assert words in str(caught.value)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("name", scenes.names())
def test_the_numbers_are_those_of_the_scene(name) -> None:
    """At parameters that are not the defaults, each formula by SymPy and by the module."""
    scene, found = scenes.load(name), registry.load(name)
    values = {q.symbol: q.default * (0.9 + 0.01 * i) for i, q in enumerate(scene.parameters)}
    rows = found.numbers("extremes", tuple(values.values()))
    assert tuple(scene.extremes) == found.module.EXTREMES
    for row, changed in zip(rows, scene.extremes.values(), strict=True):
        for symbol, value in zip(scene.symbols, row, strict=True):
            expected = sp.sympify(changed.get(symbol, symbol)).subs(values)
            assert value == pytest.approx(float(expected), rel=1e-13)


def test_they_are_no_part_of_the_mathematics() -> None:
    """An orbit that is saved stays the orbit of its scene where one is added."""
    other = replace(IMPACT, extremes={"no damping": {c: 0}})
    texts = [scene_source(scene) for scene in (IMPACT, other)]
    assert texts[0] != texts[1]
    hashes = [text.partition("\nBODY = ")[2].partition("\n")[0] for text in texts]
    assert hashes[0] == hashes[1] != ""
