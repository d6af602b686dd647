"""The options of commands about a scene, beside its parameters."""

from pathlib import Path
from typing import TYPE_CHECKING

import click

from nonsmooth.solver.kernels.registry import methods
from nonsmooth.solver.scenes.methods import in_order, shown

from ..about import PREFIX, flag
from ..aliases import Aliased, Once, OneOrder

if TYPE_CHECKING:
    from nonsmooth.solver.scenes.loaded import LoadedScene, Parameter

#: N of a command about one order, and the orders of a sweep, where none are named.
ORDER, ORDERS = 10, "1-20"

#: Periods that a diagram leaves out.
TRANSIENT = 200

FUNCTIONS = "Functions of hb-ck at each switch, 1 to 3.  [default: 1; 2 where x' jumps]"


def method_names(scene: "LoadedScene") -> list[str]:
    """Return the methods of a scene as they are shown, in their order."""
    return [shown(scene, method) for method in in_order(methods(scene))]


def range_of(q: "Parameter") -> str:
    """Return a range of a parameter up to its default, as ``--vary`` takes it."""
    return f"{flag(q.name)[2:]}={q.default / 2:g}:{q.default or 1:g}"


def of_motion(scene: "LoadedScene") -> list[click.Parameter]:
    """Return the options that say which motion of a scene is meant."""
    found: list[click.Parameter] = []
    if scene.motions:
        words = f"{', '.join(scene.motions)}; without it, the one that occurs."
        found.append(click.Option(["--motion", f"{PREFIX}motion"], help=words))
    words = "The sequence of phases: names joined by commas, a minus before a mirror image."
    found.append(click.Option(["--phases", f"{PREFIX}phases"], metavar="NAMES", help=words))
    if scene.frequency is not None:
        odd = ", an odd number" if scene.half_period else ""
        found.append(_cycles(f"{PREFIX}cycles", odd))
    return found


def _cycles(name: str, more: str = "") -> click.Option:
    words = f"Periods of the forcing in one period of the motion{more}.  [default: 1]"
    return click.Option(["--cycles", name], type=int, metavar="n", help=words)


def of_solve(scene: "LoadedScene") -> list[click.Parameter]:
    """Return the options of ``nonsmooth solve``."""
    names = ", ".join(method_names(scene))
    return [
        Aliased(["--method"], alias="--methods", help=f"{names}; without it, all."),
        Aliased(
            ["--order"], alias="--orders", type=OneOrder(),
            help=f"N: number of harmonics, or degree of polynomials.  [default: {ORDER}]",
        ),
        click.Option(["--functions"], type=int, metavar="K", help=FUNCTIONS),
        *of_motion(scene),
        click.Option(
            ["--tol"], type=float,
            help="Choose N: the lowest whose estimated relative errors are within this.",
        ),
        click.Option(
            ["--budget"],
            help="Choose the most accurate orbit within this time, like 200us, 1ms, 2s.",
        ),
        click.Option(
            ["--all", "every"], is_flag=True,
            help="List every orbit that is found, of every motion.",
        ),
    ]  # fmt: skip


def of_sweep(scene: "LoadedScene") -> list[click.Parameter]:
    """Return the options of ``nonsmooth sweep``."""
    names = ",".join(method_names(scene))
    return [
        Aliased(
            ["--methods"], alias="--method",
            help=f"Methods, joined by commas.  [default: {names}]",
        ),
        Aliased(
            ["--orders"], alias="--order",
            help="Orders N: numbers and ranges, as 4,8-12 or 10,20,...,80.  "
            f"[default: {ORDERS}]",
        ),
        click.Option(["--functions"], type=int, metavar="K", help=FUNCTIONS),
        *of_motion(scene),
        Once(
            ["--vary"], metavar="NAME=FROM:TO:POINTS",
            help="Vary a parameter instead, by one method at one order.",
        ),
        click.Option(["--log"], is_flag=True, help="Space the values by a constant factor."),
    ]  # fmt: skip


def of_branch(scene: "LoadedScene") -> list[click.Parameter]:
    """Return the options of ``nonsmooth branch``."""
    attractors = click.Option(
        ["--attractors"], is_flag=True,
        help="Also draw the states on which simulations settle, once a period of the forcing.",
    )  # fmt: skip
    names = ", ".join(method_names(scene))
    return [
        Once(
            ["--vary"], metavar="NAME=FROM:TO", required=True,
            help="The parameter, and its range.",
        ),
        *of_motion(scene),
        click.Option(
            ["--from-orbit"], type=click.Path(path_type=Path, dir_okay=False), metavar="FILE",
            help="Start from an orbit that solve has written as .json or .nc.",
        ),
        click.Option(
            ["--all", "every"], is_flag=True,
            help="Follow every orbit that is found at a few values, and at flips those of "
            "twice the period.",
        ),
        *([attractors] if scene.frequency else ()),
        Aliased(
            ["--method"], alias="--methods",
            help=f"Also solve this expansion at each orbit: {names}.",
        ),
        Aliased(
            ["--order"], alias="--orders", type=int,
            help=f"N of this expansion.  [default: {ORDER}]",
        ),
        click.Option(["--functions"], type=int, metavar="K", help=FUNCTIONS),
    ]  # fmt: skip


def of_map(scene: "LoadedScene") -> list[click.Parameter]:
    """Return the options of ``nonsmooth map``."""
    vary = click.Option(
        ["--vary"], metavar="NAME=FROM:TO:COUNT", required=True, multiple=True,
        help="Given twice: a parameter, its range, and how many values it takes.",
    )  # fmt: skip
    return [vary, *([_cycles("cycles")] if scene.frequency else ())]


def of_simulate(scene: "LoadedScene") -> list[click.Parameter]:
    """Return the options of ``nonsmooth simulate``; some look once a period of the forcing."""
    once_a_period = [
        Once(
            ["--vary"], metavar="NAME=FROM:TO:COUNT",
            help="Draw a bifurcation diagram: the states once a period of the forcing, after a "
            "transient, at values of a parameter.",
        ),
        click.Option(
            ["--transient"], type=int, metavar="CYCLES",
            help=f"Periods of transient at each value of --vary.  [default: {TRANSIENT}]",
        ),
        click.Option(
            ["--grid"], multiple=True, metavar="x=FROM:TO:COUNT",
            help="Draw basins of attraction from these initial states: given twice, for x and "
            "for v.",
        ),
    ]  # fmt: skip
    return [
        click.Option(
            ["--state"], metavar="X,V",
            help="Displacement in m and velocity in m/s at the start; for a structure, of its "
            "first contact.  [default: at rest at 0 or, where the scene does not admit that, "
            "near it]",
        ),
        click.Option(
            ["--cycles"], type=float,
            help="How many periods of the forcing; without forcing, how many times 2 pi of the "
            "scene's unit of time.  [default: 20]",
        ),
        click.Option(["--time"], type=float, help="How long in s, in place of --cycles."),
        *(once_a_period if scene.frequency else ()),
        click.Option(
            ["--forcing-phase"], type=float, default=0.0,
            help="Phase of the forcing at the start in rad.  [default: 0]",
        ),
    ]  # fmt: skip


def of_digits(scene: "LoadedScene") -> list[click.Parameter]:
    """Return the options of ``nonsmooth digits``."""
    names = ",".join(method_names(scene))
    return [
        click.Option(["--methods"], help=f"Methods, joined by commas.  [default: {names}]"),
        click.Option(["--orders"], help="Orders N: numbers and ranges.  [default: 5,10,20,40]"),
        click.Option(["--quick"], is_flag=True, help="Order 10 only."),
        *of_motion(scene),
    ]


def of_none(_: "LoadedScene") -> list[click.Parameter]:
    """Return no options: a command has those of a scene's parameters."""
    return []
