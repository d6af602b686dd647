"""``nonsmooth scenes`` and ``modes``: which scenes and structures there are, what one is."""

import textwrap
from collections.abc import Sequence
from typing import Any

import click

from ..named import STRUCTURES, NamedCommand, scene_named, scene_names

#: Columns of a line.
WIDTH = 80

EPILOG_OF_SCENES = """\b
Examples:
  nonsmooth scenes
  nonsmooth scenes impact
  nonsmooth scenes ./my_scene.py --json
"""

EPILOG_OF_MODES = """\b
Examples:
  nonsmooth modes
  nonsmooth modes beam-rotational-spring --position 3/10 --stiffness 10
  nonsmooth sweep beam-crack --orders 1-40
  nonsmooth equations beam-mass
"""


@click.command(epilog=EPILOG_OF_SCENES)
@click.argument("scene", required=False)
@click.option("--json", "json_", is_flag=True, help="Print one JSON document.")
def scenes(scene: str | None, json_: bool) -> None:
    """List the scenes, or parameters, phases and events of one.

    SCENE is a name of the list, or the path of a scene file. A scene file is a Python program
    and is run. Its equations are derived when it is first used, and kept.
    """
    from nonsmooth.described import brief, document

    listed: dict[str, Any]
    if scene is None:
        listed = {"scenes": [brief(scene_named(name)) for name in scene_names()]}
    else:
        listed = document(scene_named(scene))
    if json_:
        _print_json(listed)
    elif scene is None:
        rows = [(s["name"], s["class"], _phases(s), s["what"]) for s in listed["scenes"]]
        click.echo(_columns(("scene", "class", "phases", "what it is"), rows))
    else:
        _describe(listed)


@click.command(cls=NamedCommand, kinds=(STRUCTURES,), default=None, epilog=EPILOG_OF_MODES)
@click.option("--json", "json_", is_flag=True, help="Print one JSON document.")
def modes(json_: bool) -> None:
    """Compute modes of a beam or string with an attachment.

    Without STRUCTURE the names of all structures are listed; 'nonsmooth modes STRUCTURE
    --help' has the parameters of one.
    """
    structures = [STRUCTURES.named(name) for name in STRUCTURES.names()]
    if json_:
        listed = [
            {"name": q.name, "class": f"C{q.k}", "what": q.title, "source": q.source}
            for q in structures
        ]
        _print_json({"structures": listed})
        return
    rows = [(q.name, f"C{q.k}", f"--{q.attached.name}", q.title) for q in structures]
    click.echo(_columns(("structure", "class", "attached", "what it is"), rows))


def _print_json(contents: dict[str, Any]) -> None:
    from nonsmooth.files.json_text import as_json

    click.echo(as_json(contents))


def _phases(scene: dict[str, Any]) -> str:
    """Return the phases of a scene; those of several motions one after the other."""
    orders = scene["motions"] or [scene]
    return "; ".join(", ".join(order["phases"]) for order in orders)


def _columns(heads: tuple[str, ...], rows: Sequence[tuple[str, ...]]) -> str:
    """Return rows under their headings; the last column goes on in the next line."""
    widths = [max(map(len, column)) for column in zip(heads, *rows, strict=True)][:-1]
    lines = []
    for row in (heads, *rows):
        cells = [cell.ljust(width) for cell, width in zip(row, widths, strict=False)]
        head = "  ".join(cells) + "  "
        first, *following = textwrap.wrap(row[-1], max(WIDTH - len(head), 20)) or [""]
        lines += [(head + first).rstrip(), *(" " * len(head) + part for part in following)]
    return "\n".join(lines)


def _describe(scene: dict[str, Any]) -> None:
    click.echo(_wrapped(f"{scene['name']}: {scene['what']} ({scene['class']})", ""))
    if scene["source"]:
        click.echo(_wrapped(f"  {scene['source']}", "  "))
    click.echo()
    rows = [
        (f"--{q['name'].replace('_', '-')}", q["symbol"], q["unit"], f"{q['default']:g}",
         f"{q['what']}; {q['expected']}")
        for q in scene["parameters"]
    ]  # fmt: skip
    click.echo(_columns(("parameter", "symbol", "unit", "default", "what it is"), rows))
    for words in scene["requires"]:
        click.echo(_wrapped(f"  expected: {words}", "  "))
    if "body" in scene:
        click.echo("\n" + _wrapped(_body(scene["body"]), "  "))
    for phase in scene["phases"]:
        click.echo("\n" + _phase(phase))
    for motion in scene["motions"]:
        click.echo(f"\nmotion {motion['name']} ({motion['class']})")
        for phase in motion["phases"]:
            click.echo("\n" + _phase(phase))
    if scene["half_period"]:
        click.echo("\nThese phases are half a period: x(t + T/2) = -x(t).")
    names = (
        q["shown"] + (f" (K = {', '.join(map(str, q['functions']))})" if q["functions"] else "")
        for q in scene["methods"]
    )
    click.echo("\n" + _wrapped(f"methods: {', '.join(names)}", ""))


def _body(body: dict[str, Any]) -> str:
    """Return what moves: degrees of freedom, contacts, modes, damping."""
    modes, ratio = body["modes"] or "all", body["damping_ratio"]
    damped = f"damping ratio {ratio}" if ratio is not None else "damping by its matrix, if any"
    return (
        f"body: M q'' + C q' + K q = f cos(Omega t + phi) + w force, of "
        f"{body['degrees_of_freedom']} degrees of freedom; x = w^T q at "
        f"{', '.join(body['contacts'])}; modes kept: {modes}; {damped}"
    )


def _phase(phase: dict[str, Any]) -> str:
    begins = phase["begins"]
    lines = [
        f"{phase['name']}: {phase['held'] or phase['equation']}",
        f"  begins  {begins['class']}: {begins['jumps']} jumps" + _for_defaults(begins),
        *(f"  sets    {q['memory']} = {q['expression']}  ({q['what']})" for q in phase["sets"]),
        f"  ends    {phase['ends']}" + (f", then {phase['jump']}" if phase["jump"] else ""),
    ]
    lines += [f"  demands {q['expression']}  ({q['what']})" for q in phase["demands"]]
    lines += [
        f"  demands {q['expression']} at its end  ({q['what']})"
        for q in phase["switch_demands"]
    ]
    return "\n".join(_wrapped(line, "          ") for line in lines)


def _for_defaults(begins: dict[str, str]) -> str:
    """Return the class for the parameters' defaults, where it is another."""
    k = begins["class_of_defaults"]
    return f" ({k} for the default parameters)" if k != begins["class"] else ""


def _wrapped(text: str, indent: str) -> str:
    return textwrap.fill(text, WIDTH, subsequent_indent=indent, break_long_words=False)
