"""Scenes that the tests show, and the expansions of each."""

from functools import cache

from shown_numbers import Numbers

from nonsmooth.codegen.equations import scene_named
from nonsmooth.codegen.equations.registry import conditions, methods
from nonsmooth.codegen.scene import Scene
from nonsmooth.codegen.scenes import dry_friction
from nonsmooth.codegen.scenes.impact import SCENE as IMPACT

SCENES: dict[str, str | Scene] = {
    "impact": "impact",
    "stick-slip": "stick-slip",
    "stick-slip-damped": "stick-slip-damped",
    "clearance": "clearance",
    "stops": dry_friction.SCENE.of_motion("two-stops"),
    "impact-two-sided": "impact-two-sided",
    "elastic-plastic": "elastic-plastic",
    "impact-inelastic": "impact-inelastic",
}

#: Scenes of every run; those left out have phases of the same kinds.
EVERY_RUN = (
    "impact",
    "stick-slip",
    "stick-slip-damped",
    "stops",
    "elastic-plastic",
    "impact-inelastic",
)

#: Every method on a scene, and each kind of phase in the others.
CASES = [
    *(("impact", method) for method in methods(IMPACT)),
    *(("stick-slip", method) for method in ("hb", "hb-c1", "ck")),
    ("stick-slip-damped", "ck-tau"),
    ("stick-slip-damped", "hb"),
    ("clearance", "ck-tau"),
    ("clearance", "hb"),
    ("stops", "hb-ck"),
    ("stops", "ck"),
    ("impact-two-sided", "hb"),
    ("impact-two-sided", "ck-tau"),
    ("elastic-plastic", "hb"),
    ("elastic-plastic", "ck-tau"),
    ("impact-inelastic", "hb"),
    ("impact-inelastic", "hb-ck"),
    ("impact-inelastic", "ck-tau"),
]
CASES_OF_EVERY_RUN = [
    case for case in CASES if case[0] in EVERY_RUN and case != ("stops", "ck")
]


@cache
def numbers(scene: str, method: str, functions: int | None = None) -> Numbers:
    """Return what is shown of a scene in an expansion, with numbers."""
    return Numbers(conditions(scene_named(SCENES[scene]), method, functions), 3)
