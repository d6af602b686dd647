"""The page on one oscillator: what was computed, put into the template."""

from collections.abc import Mapping
from importlib.metadata import version
from typing import Any

from nonsmooth.codegen.printing.html import STYLE
from nonsmooth.described.scene_document import document
from nonsmooth.solver.accuracy.rates import rate
from nonsmooth.solver.kernels.registry import mathematics, methods
from nonsmooth.solver.scenes.methods import about

from ..html import inline, template
from .collected import Collected, overshoot
from .figures import FIGURES, theory
from .multipliers import multipliers

#: What Fourier series of a jump tend to go beyond it: Wilbraham's and Gibbs' constant.
GIBBS = 0.0894899


def page(found: Collected, pictures: Mapping[str, str], equations: str) -> str:
    """Return the page as HTML that needs nothing from outside.

    Parameters
    ----------
    found : Collected
        What was computed.
    pictures : dict of str to str
        SVG by name.
    equations : str
        The derived equations, as a fragment.
    """
    case, scene = found.case, found.case.scene
    return template("scenes/page.html.jinja").render(
        version=version("nonsmooth"),
        scene=document(scene),
        values=case.values,
        description=case.description,
        exact=_times(found),
        multipliers=multipliers(found.exact),
        k=scene.k,
        ringing=_overshoots(found),
        gibbs=f"{100 * GIBBS:.2f}",
        rates=rates(found),
        errors=_errors(found),
        pictures={name: inline(svg, name, FIGURES[name][1]) for name, svg in pictures.items()},
        equations=equations,
        equation_style=STYLE,
        mathematics=mathematics(scene, methods(scene)),
    )


def _times(found: Collected) -> dict[str, Any]:
    exact = found.exact
    turn = exact.forcing_phase
    return {
        "period": f"{exact.period:.12g}",
        "forcing_phase": None if turn is None else f"{turn:.12g}",
        "phases": [
            {
                "name": phase.name,
                "duration": f"{phase.duration:.12g}",
                "displacement": f"{phase.displacement:.8g}",
                "velocity": f"{phase.velocity:.8g}",
            }
            for phase in exact.phases
        ],
        "extremes": {
            name: tuple(f"{end:.8g}" for end in ends) for name, ends in exact.extremes.items()
        },
    }


def _overshoots(found: Collected) -> list[dict[str, str]]:
    return [
        {
            "name": name,
            "order": str(orbit.order),
            "percent": f"{100 * max(0.0, overshoot(orbit, found.exact)):.2g}",
        }
        for name, orbit in found.ringing.items()
    ]


def rates(found: Collected) -> list[dict[str, str]]:
    """Return the measured rate of each error of each way, and what theory has for it."""
    rows = []
    for way, points in found.curves.items():
        errors = [
            (p.order, {"times": p.times, "discontinuous": p.discontinuous}) for p in points
        ]
        measured = rate(way.method, errors)
        row = {"name": way.name}
        for name in ("times", "discontinuous"):
            row[name] = measured.text(name)
            power = about(way.method).power
            row[f"{name}_theory"] = (
                f"N^-{theory(found, way, name):g}" if power else "faster than any power"
            )
        rows.append(row)
    return rows


def _errors(found: Collected) -> list[dict[str, str]]:
    """Return the error of the times of each way at its lowest and its highest order."""
    return [
        {
            "name": way.name,
            "low": f"{points[0].times:.1e} at N = {points[0].order}",
            "high": f"{points[-1].times:.1e} at N = {points[-1].order}",
        }
        for way, points in found.curves.items()
        if points
    ]
