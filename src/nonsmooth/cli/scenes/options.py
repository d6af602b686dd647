"""The options of commands about a scene, beside its parameters."""

from collections.abc import Iterable
from pathlib import Path
from typing import Any

import click

from nonsmooth.solver.kernels.registry import generic_method, methods
from nonsmooth.solver.scenes.loaded import LoadedScene, Parameter
from nonsmooth.solver.scenes.methods import in_order, shown

from ..about import PREFIX, flag, option
from ..aliases import Aliased, Once, OneOrder
from ..values import ORDERS, SEVERAL

#: N of a command about one order, where none is named.
ORDER = 10

#: Periods that a diagram leaves out and keeps, and that a motion from a grid is followed.
TRANSIENT, KEPT, FOLLOWED = 200, 50, 100


def method_names(scene: LoadedScene) -> list[str]:
    """Return the methods of a scene as they are shown, in their order."""
    return [shown(scene, method) for method in in_order(methods(scene))]


def generic_methods(scene: LoadedScene, names: Iterable[str]) -> list[str]:
    """Return the named methods, each once, by the names that all scenes share.

    A `ValueError` names one that the scene does not have.
    """
    return list(dict.fromkeys(generic_method(scene, name) for name in names))


def range_of(q: Parameter) -> str:
    """Return a range of a parameter up to its default, as ``--vary`` takes it."""
    return f"{flag(q.name)[2:]}={q.default / 2:g}:{q.default or 1:g}"


def _functions() -> click.Option:
    words = "Functions of hb-ck at each switch, 1 to 3.  [default: 1; 2 where x' jumps]"
    return option("--functions", int, words, metavar="K")


def of_motion(scene: LoadedScene) -> list[click.Parameter]:
    """Return the options that say which motion of a scene is meant."""
    options: list[click.Parameter] = []
    if scene.motions:
        words = f"{', '.join(scene.motions)}; without it, the one that occurs."
        options.append(option(f"--motion {PREFIX}motion", str, words))
    words = "The sequence of phases: names joined by commas, a minus before a mirror image, "
    words += "'3 x ' before one that occurs three times in a row."
    options.append(option(f"--phases {PREFIX}phases", str, words, metavar="NAMES"))
    if scene.frequency is not None:
        odd = ", an odd number" if scene.half_period else ""
        options.append(_cycles(odd))
    return options


def _cycles(suffix: str = "") -> click.Option:
    words = f"Periods of the forcing in one period of the motion{suffix}.  [default: 1]"
    return option(f"--cycles {PREFIX}cycles", int, words, metavar="n")


def of_solve(scene: LoadedScene) -> list[click.Parameter]:
    """Return the options of ``nonsmooth solve``."""
    names = f"{', '.join(method_names(scene))}; without it, all."
    order = f"N: number of harmonics, or degree of polynomials.  [default: {ORDER}]"
    tol = "Choose N: the lowest whose estimated relative errors are within this."
    budget = "Choose the most accurate orbit within this time, like 200us, 1ms, 2s."
    return [
        option("--method", str, names, Aliased, alias="--methods"),
        option("--order", OneOrder(), order, Aliased, alias="--orders"),
        _functions(),
        *of_motion(scene),
        option("--tol", float, tol),
        option("--budget", str, budget),
        option("--all every", None, "List every orbit that is found, of every motion."),
    ]


def of_sweep(scene: LoadedScene) -> list[click.Parameter]:
    """Return the options of ``nonsmooth sweep``."""
    names = f"Methods, joined by commas.  [default: {','.join(method_names(scene))}]"
    vary = "Vary a parameter instead, by one method at one order."
    return [
        option("--methods", str, names, Aliased, alias="--method"),
        option("--orders", str, f"{SEVERAL}.  [default: {ORDERS}]", Aliased, alias="--order"),
        _functions(),
        *of_motion(scene),
        option("--vary", str, vary, Once, metavar="NAME=FROM:TO:POINTS"),
        option("--log", None, "Space the values by a constant factor."),
    ]


def of_branch(scene: LoadedScene) -> list[click.Parameter]:
    """Return the options of ``nonsmooth branch``."""
    file = click.Path(path_type=Path, dir_okay=False)
    start = "Start from an orbit that solve has written as .json or .nc."
    every = (
        "Follow every orbit that is found at a few values, and at flips those of twice the "
        "period."
    )
    attractors = (
        "Also draw the states on which simulations settle, once a period of the forcing."
    )
    beside = f"Also solve this expansion at each orbit: {', '.join(method_names(scene))}."
    order = f"N of this expansion.  [default: {ORDER}]"
    return [
        option(
            "--vary", str, "The parameter, and its range.", Once,
            metavar="NAME=FROM:TO", required=True,
        ),
        *of_motion(scene),
        option("--from-orbit", file, start, metavar="FILE"),
        option("--all every", None, every),
        *([option("--attractors", None, attractors)] if scene.frequency else ()),
        option("--method", str, beside, Aliased, alias="--methods"),
        option("--order", int, order, Aliased, alias="--orders"),
        _functions(),
    ]  # fmt: skip


def of_map(scene: LoadedScene) -> list[click.Parameter]:
    """Return the options of ``nonsmooth map``."""
    words = "Given twice: a parameter, its range, and how many values it takes."
    form: dict[str, Any] = {"metavar": "NAME=FROM:TO:COUNT", "required": True, "multiple": True}
    vary = option("--vary", str, words, **form)
    return [vary, *([_cycles()] if scene.frequency else ())]


def of_simulate(scene: LoadedScene) -> list[click.Parameter]:
    """Return the options of ``nonsmooth simulate``; some look once a period of the forcing."""
    state = (
        "Displacement in m and velocity in m/s at the start; for a structure, of its first "
        "contact.  [default: at rest at 0 or, where the scene does not admit that, near it]"
    )
    cycles = (
        "How many periods of the forcing; without forcing, how many times 2 pi of the scene's "
        "unit of time.  [default: 20"
    )
    cycles += f"; {KEPT} with --vary; {FOLLOWED} with --grid]" if scene.frequency else "]"
    vary = (
        "Draw a bifurcation diagram: the states once a period of the forcing, after a "
        "transient, at values of a parameter."
    )
    transient = f"Periods of transient at each value of --vary.  [default: {TRANSIENT}]"
    grid = "Draw basins of attraction from these initial states: given twice, for x and for v."
    phase = "Phase of the forcing at the start in rad.  [default: 0]"
    once_a_period = [
        option("--vary", str, vary, Once, metavar="NAME=FROM:TO:COUNT"),
        option("--transient", int, transient, metavar="CYCLES"),
        option("--grid", str, grid, metavar="x=FROM:TO:COUNT", multiple=True),
    ]
    return [
        option("--state", str, state, metavar="X,V"),
        option("--cycles", float, cycles),
        option("--time", float, "How long in s, in place of --cycles."),
        *(once_a_period if scene.frequency else ()),
        option("--forcing-phase", float, phase, default=0.0),
    ]


def of_digits(scene: LoadedScene) -> list[click.Parameter]:
    """Return the options of ``nonsmooth digits``."""
    names = f"Methods, joined by commas.  [default: {','.join(method_names(scene))}]"
    return [
        option("--methods", str, names),
        option("--orders", str, "Orders N: numbers and ranges.  [default: 5,10,20,40]"),
        option("--quick", None, "Order 10 only."),
        *of_motion(scene),
    ]
