"""The page on one oscillator: the results put into the template."""

import cmath
from collections.abc import Callable, Mapping
from functools import partial
from pathlib import Path
from typing import Any

from nonsmooth.codegen import equations as derived
from nonsmooth.codegen.printing.html import fragment_of
from nonsmooth.described import document
from nonsmooth.solver.accuracy.rates import rate
from nonsmooth.solver.exact import ExactOrbit
from nonsmooth.solver.kernels.registry import mathematics, methods
from nonsmooth.solver.scenes.case import Case
from nonsmooth.solver.scenes.methods import about
from nonsmooth.solver.scenes.ordered import OrderedScene
from nonsmooth.solver.stability.in_words import count_shown, in_words
from nonsmooth.solver.stability.monodromy import NoMultipliersError

from ..checks.fourier import GIBBS
from ..html import filled, folded, inline
from ..pictures import figure, files, write_report
from ..words import listed, signed
from .collected import Collected, collect, steps
from .scene_figures import FIGURES, figures_of, theory

#: Size of a number, relative to the largest of its kind, that is shown as 0.
ROUNDING = 1e-14

#: The errors of an orbit that the page shows.
ERRORS = ("times", "discontinuous")


def page(results: Collected, equations: str, pictures: Mapping[str, str]) -> str:
    """Return the page as self-contained HTML.

    Parameters
    ----------
    results : Collected
        The results.
    equations : str
        The derived equations, as a fragment.
    pictures : dict of str to str
        SVG by name.
    """
    case, scene = results.case, results.case.scene
    *smooth, jumps = ("x" + "\N{PRIME}" * order for order in range(scene.k + 2))
    return filled(
        "scenes/scene.html.jinja",
        scene=document(scene),
        order=scene.motion,
        is_body=scene.has_body,
        values=case.values,
        description=case.description,
        exact=results.exact,
        beside=beside,
        multipliers=multipliers(results.exact),
        k=scene.k,
        smooth=listed(smooth),
        jumps=jumps,
        ringing=results.ringing,
        beyond=results.beyond,
        gibbs=f"{100 * GIBBS:.2f}",
        rates=rates(results),
        curves=results.curves,
        pictures={name: inline(svg, name, FIGURES[name][1]) for name, svg in pictures.items()},
        equations=equations,
        mathematics=mathematics(scene, methods(scene)),
    )


def beside(value: float, ends: tuple[float, float]) -> str:
    """Return a number as text; 0 if it is rounding relative to the larger of `ends`."""
    return f"{value if abs(value) > ROUNDING * max(map(abs, ends)) else 0.0:.8g}"


def multipliers(exact: ExactOrbit) -> dict[str, Any]:
    """Return the Floquet multipliers of the exact orbit for the page, largest modulus first.

    `rows` has one entry each, `smaller` counts those left out, `verdict` is the stability or
    the reason why there are none, `shift` whether the trivial multiplier 1 is left out.
    """
    _, _, verdict = in_words(exact).partition(": ")
    try:
        stability = exact.stability
    except NoMultipliersError:
        return {"rows": [], "smaller": 0, "verdict": verdict, "shift": False}
    count = min(count_shown(stability.multipliers), len(stability.multipliers))
    rows = [
        _multiplier(complex(value), stability.rounding)
        for value in stability.multipliers[:count]
    ]
    return {
        "rows": rows, "smaller": len(stability.multipliers) - count, "verdict": verdict,
        "shift": stability.trivial_multiplier is not None,
    }  # fmt: skip


def _multiplier(value: complex, rounding: float) -> dict[str, str]:
    """Return one multiplier as texts; within rounding of modulus 1 it is neither, in words."""
    modulus = abs(value)
    stable = "stable" if modulus < 1 else "unstable"
    if abs(modulus - 1) <= rounding:
        stable = "neither, to rounding"
    argument = f"{cmath.phase(value):.5g}" if value else "none"
    return {"modulus": f"{modulus:.5g}", "argument": signed(argument), "stable": stable}


def rates(results: Collected) -> list[dict[str, str]]:
    """Return measured rates of convergence and those of theory, a row for each way."""
    rows = []
    for way, curve in results.curves.items():
        errors = [(order, vars(each)) for order, each in curve.items()]
        measured, power = rate(way.method, errors), about(way.method).power
        row = {"name": way.name}
        for name in ERRORS:
            fall = theory(results, way, name)
            expected = "" if fall is None else f"N^-{fall:g}"
            expected = expected if power else "faster than any power"
            row |= {name: measured.text(name), f"{name}_theory": expected}
        rows.append(row)
    return rows


#: All possible files of a report on a scene.
FILES = files(FIGURES)


def count(case: Case) -> int:
    """Return the number of steps of which `build` reports progress."""
    return steps(case) + 1 + len(figures_of(case)) + 1


def build(
    case: Case, exact: ExactOrbit, source: str, folder: Path, done: Callable[[str], None]
) -> None:
    """Write the report on a case into an empty folder.

    Parameters
    ----------
    case : Case
        The oscillator.
    source : str
        The name of its scene, or the path of its file: its equations are derived from it.
    exact : ExactOrbit
        Its exact orbit.
    folder : Path
        An empty folder.
    done : callable
        Called with the step just done in words.
    """
    results = collect(case, exact, done)
    order = case.scene.motion if isinstance(case.scene, OrderedScene) else None
    equations = folded(fragment_of(derived.sections(source, phases=order)))
    done("equations")
    pictures = {name: partial(figure, draw, results) for name, draw in figures_of(case).items()}
    write_report(folder, pictures, partial(page, results, equations), done)
