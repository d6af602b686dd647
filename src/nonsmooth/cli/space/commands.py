"""The commands about a structure as the command line shows them; `scenes.commands` is alike."""

from typing import Any

import click

from nonsmooth.solver.space.structure import Structure

from ..about import PREFIX, CommandAbout, Verb, flag, option
from ..aliases import Once
from ..values import ORDERS, SEVERAL


def _of_modes(structure: Structure) -> list[click.Parameter]:
    """Return the options of ``nonsmooth modes``."""
    k, most = structure.k, structure.most_forced
    order = "N: number of sines, or degree of polynomials.  [default: 8]"
    forced = f"Forced modes of ritz-c{k}, 1 to {most}.  [default: 1]"
    vary = "Vary a parameter or the position."
    shapes = "Mass-normalised shapes at this number of points, to -o FILE or as --json."
    return [
        option("--method", str, f"ritz, ritz-c{k}, c{k}, or all.  [default: ritz-c{k}]"),
        option("--order", int, order),
        option("--forced", int, forced, metavar="K"),
        option("--count", int, "How many modes.  [default: 6]"),
        option("--tol", float, "Choose N: largest relative error of a frequency."),
        option("--vary", str, vary, Once, metavar="NAME=FROM:TO:POINTS"),
        option("--log", None, "Space its values by a constant factor."),
        option("--shapes", int, shapes, metavar="POINTS"),
    ]


def _of_sweep(structure: Structure) -> list[click.Parameter]:
    """Return the options of ``nonsmooth sweep``."""
    k, most = structure.k, structure.most_forced
    names = f"Methods, joined by commas.  [default: ritz,ritz-c{k},c{k}]"
    forced = f"Numbers of forced modes of ritz-c{k}, 1 to {most}.  [default: 1]"
    return [
        option("--methods", str, names),
        option("--orders", str, f"{SEVERAL}.  [default: {ORDERS}]"),
        option("--forced", str, forced, metavar="K,K"),
        option("--mode", int, "Number of the mode.  [default: 1]"),
    ]


#: By the name of the command.
VERBS = {
    "modes": Verb(
        ".space.modes.run",
        """Compute the lowest modes of {name}.

{title}; its modes are of class C{k}. The methods are those of the paper, in space: ritz has
sines, ritz-c{k} sines and forced modes, c{k} functions of class C{k} only. Every mode comes
with its error against the exact one and, where they are available, with proved bounds.""",
        """  nonsmooth modes{said} --position 3/10 {flag} 10
  nonsmooth modes{said} --method all --order 12 -o modes.png
  nonsmooth modes{said} --forced 2 --tol 1e-12 --count 3
  nonsmooth modes{said} --vary position=1/20:1/2:10
  nonsmooth modes{said} --shapes 101 -o shapes.csv
""",
        options=_of_modes,
        file="the modes: .json, .csv, .nc",
    ),
    "sweep": Verb(
        ".space.sweep.run",
        """Compute one mode of {name} for many orders and compare it with the exact one.

{title}; its modes are of class C{k}.""",
        """  nonsmooth sweep{said}
  nonsmooth sweep{said} --methods ritz,ritz-c{k} --forced 1,2 --orders 4,8,16,32
  nonsmooth sweep{said} --mode 3 -o convergence.png
""",
        options=_of_sweep,
        file="the rows: .csv, .json",
    ),
}


def command(verb: str, structure: Structure, said: str) -> click.Command:
    """Return a command of a structure, which the user called so."""
    words = {"k": structure.k, "flag": flag(structure.attached.name)}
    place = (
        "a: place of the attachment divided by the length, as a fraction or a decimal; with a "
        "fraction, nodes are recognised exactly.  [default: 3/10]"
    )
    flags = [
        option(f"--position {PREFIX}position", str, place),
        *(
            option(f"{flag(q.name)} {PREFIX}{q.name}", float, _help(structure, q))
            for q in structure.parameters
        ),
    ]
    return CommandAbout(structure, said, VERBS[verb], flags, words)


def _help(structure: Structure, q: Any) -> str:
    spring = structure.kind == "stiffness" and q.name == structure.attached.name
    admitted = "above the critical one, not 0" if spring else "above 0"
    return f"{q.symbol} in {q.unit}: {q.what}, {admitted}.  [default: {q.default:g}]"
