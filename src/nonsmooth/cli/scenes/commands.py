"""The commands about a scene as the command line shows them; what runs is imported to run."""

from typing import TYPE_CHECKING

import click
from click.shell_completion import CompletionItem

from ..about import PREFIX, CommandAbout, Output, Verb, completed, flag
from ..named import scene_names
from ..output import DATA, FOR_REPORTS, PICTURES
from ..problems import Verbose
from . import options

if TYPE_CHECKING:
    from nonsmooth.solver.scenes.loaded import LoadedScene, Parameter

SOLVE = Verb(
    ".scenes.solve",
    options.of_solve,
    Output(
        "Write the orbit: .json, .nc, its motion .csv; or a picture .png, .svg, .pdf.",
        (*DATA, *PICTURES),
    ),
    """Compute the periodic orbit of {name} by one method, or by each.

{title}. With a tolerance, the lowest order of the method, without one of {best}, whose
estimated errors of times and period are within it. With a budget, the best orbit that fits,
timed on this machine.""",
    """\b
Examples:
  nonsmooth solve {said}
  nonsmooth solve {said} --method {best} --tol 1e-9
  nonsmooth solve {said} {flag} {value:g} -o orbit.png
""",
)

SWEEP = Verb(
    ".scenes.sweep",
    options.of_sweep,
    Output(
        "Write the rows: .csv, .json, .nc; or a picture .png, .svg, .pdf.", (*DATA, *PICTURES)
    ),
    """Compute the orbit of {name} for many orders and compare it with the exact one.

{title}.""",
    """\b
Examples:
  nonsmooth sweep {said}
  nonsmooth sweep {said} --methods hb,{best} --orders 1-10,20,40 -o rows.csv
  nonsmooth sweep {said} --orders 2-16 -o convergence.png
  nonsmooth sweep {said} --vary {vary}:40 -o along.png
""",
)

BRANCH = Verb(
    ".scenes.branch",
    options.of_branch,
    Output(
        "Write the branch: .csv, .json, .nc; or a picture .png, .svg, .pdf.", (*DATA, *PICTURES)
    ),
    """Follow the orbit of {name} along a parameter, stable or not, through folds.

{title}. The orbits are exact. Where the order of the phases changes the branch goes on with the
new one. Folds, flips, grazings and beginnings and ends of a rest are located to rounding.""",
    """\b
Examples:
  nonsmooth branch {said} --vary {vary}
  nonsmooth branch {said} --vary {vary} -o branch.svg
  nonsmooth branch {said} --vary {vary} --all --json
""",
)

MAP = Verb(
    ".scenes.map",
    options.of_map,
    Output(
        "Write the map: .csv, .json, .nc; or a picture .png, .svg, .pdf.", (*DATA, *PICTURES)
    ),
    """Map the motions of {name} over two parameters, and the curves between them.

{title}. Each point has an exact orbit, stable or not, or is empty. Curves of folds, flips,
grazings and rests are followed in both parameters. It uses all cores.""",
    """\b
Examples:
  nonsmooth map {said} --vary {vary}:60 --vary {other}:40
  nonsmooth map {said} --json -o map.png \\
    --vary {vary}:60 --vary {other}:40
""",
)

SIMULATE = Verb(
    ".scenes.simulate",
    options.of_simulate,
    Output(
        "Write the motion: .json, .csv; or a picture .png, .svg, .pdf.",
        (".json", ".csv", *PICTURES),
    ),
    """Simulate {name} from a given state, from event to event.

{title}. Each phase is the exact flow of its equation, and no event can be stepped over. Which
phase follows is decided by what each demands.""",
    """\b
Examples:
  nonsmooth simulate {said} --cycles 50
  nonsmooth simulate {said} --state 0,0.1 -o transient.png
  nonsmooth simulate {said} {flag} {value:g} --json
{of_many}""",
)

#: Further examples of simulations, of scenes that something forces.
OF_MANY = """  nonsmooth simulate {said} --vary {vary}:200 -o diagram.png
  nonsmooth simulate {said} --grid x=-2:2:50 --grid v=-2:2:50
"""

DIGITS = Verb(
    ".scenes.digits",
    options.of_digits,
    Output("Write the digits: .json, or a picture .png, .svg, .pdf.", (".json", *PICTURES)),
    """Measure the digits that float64 keeps of the times of orbits of {name}.

{title}. At the given parameters and at each extreme that the scene names, the exact equations
and those of each method are solved in float64, and the same equations again in ball arithmetic.
Needs python-flint.""",
    """\b
Examples:
  nonsmooth digits {said}
  nonsmooth digits {said} --methods {best} --orders 5,10,20 -o digits.png
""",
    needs=(("flint", "precise", "digits", "python-flint"),),
)

TRADEOFF = Verb(
    ".scenes.tradeoff",
    options.of_none,
    Output("Write the points: .json, or a picture .png, .svg, .pdf.", (".json", *PICTURES)),
    """Measure time against error of the times: each method of {name}, and its exact flow.

{title}. A time is that of a whole solve: from rough times, with its checks, and not the first.
A point on the front (marked *) is the best in its time.""",
    """\b
Examples:
  nonsmooth tradeoff {said}
  nonsmooth tradeoff {said} {flag} {value:g} -o tradeoff.png
""",
)

REPORT = Verb(
    ".scenes.report",
    options.of_none,
    Output("Folder to make: index.html, and every figure as .svg and .pdf."),
    """Write a page on {name}: what it is, its orbit, and how fast each expansion finds it.

{title}. The page needs nothing from outside.""",
    """\b
Examples:
  nonsmooth report {said} -o {name}
  nonsmooth report {said} {flag} {value:g} -o {name}
""",
    needs=FOR_REPORTS,
)

#: By the name of the command; `stability` is the old name of `digits`.
VERBS = {
    "solve": SOLVE,
    "sweep": SWEEP,
    "branch": BRANCH,
    "map": MAP,
    "simulate": SIMULATE,
    "digits": DIGITS,
    "stability": DIGITS,
    "tradeoff": TRADEOFF,
    "report": REPORT,
}


class CommandOfScene(CommandAbout):
    """A command built for a scene."""

    def shell_complete(self, ctx: click.Context, incomplete: str) -> list[CompletionItem]:
        """Complete options, and scenes where none is named."""
        scenes = () if " " in (ctx.info_name or "") else scene_names()
        return [*completed(scenes, incomplete), *super().shell_complete(ctx, incomplete)]


def command(verb: str, scene: "LoadedScene", said: str) -> click.Command:
    """Return a command of a scene, which the user called so."""
    before, last = scene.parameters[-2:][0], scene.parameters[-1]
    words = {
        "best": options.method_names(scene)[-1],
        "flag": flag(last.name),
        "value": last.default,
        "vary": options.range_of(last),
        "other": options.range_of(before),
    }
    words["of_many"] = OF_MANY.format(said=said, **words) if scene.frequency else ""
    parameters = [
        *(click.Option([flag(q.name), PREFIX + q.name], type=float, help=_help(q))
          for q in scene.parameters),
        Verbose(),
    ]  # fmt: skip
    return CommandOfScene(scene, said, VERBS[verb], parameters, words)


def _help(q: "Parameter") -> str:
    unit = f" in {q.unit}" if q.unit else ""
    return f"{q.symbol}{unit}: {q.what}; {q.expected}.  [default: {q.default:g}]"
