"""The commands about a scene as the command line shows them; what runs is imported to run."""

from dataclasses import replace

import click

from nonsmooth.solver.scenes.loaded import LoadedScene, Parameter

from ..about import PREFIX, CommandAbout, Verb, flag, option
from ..commands import paper
from ..named import DEFAULT, SCENES
from ..output import FOR_REPORTS
from ..problems import Verbose
from . import options

#: Further examples of simulations, of scenes that something forces.
OF_MANY = """  nonsmooth simulate{said} --vary {vary}:200 -o diagram.png
  nonsmooth simulate{said} --grid x=-2:2:50 --grid v=-2:2:50
"""

#: By the name of the command.
VERBS = {
    "solve": Verb(
        ".scenes.solve.run",
        """Compute the periodic orbit of {name} by one method, or by each.

{title}. With --tol: the lowest order of the method ({best} unless --method names another)
whose estimated errors are within the tolerance. With --budget: the most accurate orbit that
can be computed in this time, measured on this machine.""",
        """  nonsmooth solve{said}
  nonsmooth solve{said} --method {best} --tol 1e-9
  nonsmooth solve{said} {flag} {value:g} -o orbit.png
""",
        options=options.of_solve,
        file="the orbit: .json, .nc, its motion .csv",
    ),
    "sweep": Verb(
        ".scenes.sweep.run",
        """Compute the orbit of {name} for many orders and compare it with the exact one.

{title}. With --vary: the orbit at given values of a parameter.""",
        """  nonsmooth sweep{said}
  nonsmooth sweep{said} --methods hb,{best} --orders 1-10,20,40 -o rows.csv
  nonsmooth sweep{said} --orders 2-16 -o convergence.png
  nonsmooth sweep{said} --vary {vary}:40 -o along.png
""",
        options=options.of_sweep,
        file="the rows: .csv, .json, .nc",
    ),
    "branch": Verb(
        ".scenes.branch.run",
        """Follow an orbit of {name} along a parameter, stable or not, through folds.

{title}. The orbits are exact. Where a phase begins or ends, the branch goes on with the new
sequence of phases. Folds, flips (period doublings), grazings, and beginnings and ends of a
rest are located to rounding error.""",
        """  nonsmooth branch{said} --vary {vary}
  nonsmooth branch{said} --vary {vary} -o branch.svg
  nonsmooth branch{said} --vary {vary} --all --json
""",
        options=options.of_branch,
        file="the branch: .csv, .json, .nc",
    ),
    "map": Verb(
        ".scenes.branch.chart",
        """Map the motions of {name} over two parameters, and the curves between them.

{title}. Each point has an exact orbit, stable or not, or is empty if none is found. Curves of
folds, flips, grazings and rests are followed in both parameters. All cores are used.""",
        """  nonsmooth map{said} --vary {vary}:60 --vary {other}:40
  nonsmooth map{said} --json -o map.png \\
   --vary {vary}:60 --vary {other}:40
""",
        options=options.of_map,
        file="the map: .csv, .json, .nc",
    ),
    "simulate": Verb(
        ".scenes.simulate.run",
        """Simulate {name} from a given state, from event to event.

{title}. Each phase is the exact solution of its equation, and no event is stepped over. The
next phase is one whose demands hold after the event.""",
        """  nonsmooth simulate{said} --cycles 50
  nonsmooth simulate{said} --state 0,0.1 -o transient.png
  nonsmooth simulate{said} {flag} {value:g} --json
""",
        options=options.of_simulate,
        file="the motion: .json, .csv",
    ),
    "digits": Verb(
        ".scenes.digits.run",
        """Measure how many digits float64 keeps of the times of orbits of {name}.

{title}. At the given parameters and at extreme ones that the scene names, the exact equations
and those of each method are solved in float64, and again in ball arithmetic. Needs
python-flint.""",
        """  nonsmooth digits{said}
  nonsmooth digits{said} --methods {best} --orders 5,10,20 -o digits.png
""",
        options=options.of_digits,
        file="the digits: .json",
        needs=(("flint", "precise", "digits", "python-flint"),),
    ),
    "tradeoff": Verb(
        ".scenes.sweep.trade",
        """Measure time against error: each method of {name}, and its exact orbit.

{title}. A time is that of a whole solve with compiled kernels: search, checks and errors. A
point marked * is on the Pareto front: no other is both faster and more accurate.""",
        """  nonsmooth tradeoff{said}
  nonsmooth tradeoff{said} {flag} {value:g} -o tradeoff.png
""",
        file="the points: .json",
    ),
    "report": Verb(
        ".commands.paper.report_on",
        """Write a page on {name}: what it is, its orbit, and how fast each expansion finds it.

{title}. The page needs no network.""",
        """  nonsmooth report{said} -o {name}
  nonsmooth report{said} {flag} {value:g} -o {name}
""",
        folder="Folder to make: index.html, and every figure as .svg and .pdf.",
        needs=FOR_REPORTS,
    ),
}
VERBS["stability"] = VERBS["digits"]  # its old name

#: What the default scene has in their place, or alone.
OF_DEFAULT = {"report": paper.REPORT, "roots": paper.ROOTS}


#: What the help of a command without a scene says of others.
OF_OTHERS = """

For another SCENE, a name that 'nonsmooth scenes' lists or the path of a scene file, the
parameters are in 'nonsmooth {verb} SCENE --help'."""


def command(verb: str, scene: LoadedScene, said: str) -> click.Command:
    """Return a command of a scene, which the user called so."""
    before, last = scene.parameters[-2:][0], scene.parameters[-1]
    words = {
        "best": options.method_names(scene)[-1],
        "flag": flag(last.name),
        "value": last.default,
        "vary": options.range_of(last),
        "other": options.range_of(before),
    }
    parameters = [
        *(
            option(f"{flag(q.name)} {PREFIX}{q.name}", float, _help(q))
            for q in scene.parameters
        ),
        Verbose(),
    ]
    about = (VERBS | OF_DEFAULT if scene.name == DEFAULT else VERBS)[verb]
    if verb == "simulate" and scene.frequency:
        about = replace(about, examples=about.examples + OF_MANY)
    others = () if said or verb not in VERBS else (SCENES,)
    if others:
        about = replace(about, help=about.help + OF_OTHERS.format(verb=verb))
    return CommandAbout(scene, said, about, parameters, words, others)


def _help(q: Parameter) -> str:
    unit = f" in {q.unit}" if q.unit else ""
    return f"{q.symbol}{unit}: {q.what}; {q.expected}.  [default: {q.default:g}]"
