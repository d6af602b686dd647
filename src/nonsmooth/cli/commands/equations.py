"""``nonsmooth equations``: the derived equations of any scene, numbered as in the paper."""

import os
import sys
from pathlib import Path
from typing import TYPE_CHECKING

import click

from nonsmooth.scene_files.error import SceneFileError

from ..named import DEFAULT, structure_names
from ..output import check_target, write_text, write_whole
from ..problems import Problem
from ..progress import busy
from . import tex

if TYPE_CHECKING:
    from nonsmooth.codegen.system import Section

#: What the suffix of a file says about its format.
SUFFIXES = {".txt": "text", ".tex": "latex", ".html": "html", ".pdf": "pdf"}

FORMATS = tuple(SUFFIXES.values())

EPILOG = """\b
Examples:
  nonsmooth equations --method hb
  nonsmooth equations -o equations.html
  nonsmooth equations --format latex --fragment -o equations.tex
  nonsmooth equations impact --method ck-tau -o impact.pdf
  nonsmooth equations dry-friction --phases slide,stop,-slide,stop,mirrored
  nonsmooth equations beam-mass
"""


@click.command(epilog=EPILOG)
@click.argument("scene", required=False, is_eager=True)
@click.option(
    "--method",
    help="hb, hb-ck, ck or ck-tau, also with the class of the scene for ck, as c0-tau. For the "
    "default scene hb, hb-c1, c1 are Sections 3.1, 3.2, 3.3 of the paper.  [default: all]",
)
@click.option(
    "--functions",
    type=int,
    metavar="K",
    help="Functions of hb-ck at each switch, 1 to 3.  [default: 1; 2 where x' jumps]",
)
@click.option("--motion", help="One motion of a SCENE that has several.  [default: all]")
@click.option(
    "--phases",
    metavar="NAMES",
    help="The sequence of phases: names joined by commas, a minus before a mirror image, "
    "'3 x ' before one that occurs three times in a row; ends in 'mirrored' if it is half a "
    "period; as solve prints it.",
)
@click.option(
    "--format", "format_", type=click.Choice(FORMATS),
    help="Output format; default: from the file extension, else text. pdf needs pdflatex.",
)  # fmt: skip
@click.option("--fragment", is_flag=True, help=r"LaTeX without a preamble, to \input.")
@click.option("-o", "--output", type=click.Path(path_type=Path), help="Write to this file.")
def equations(
    scene: str | None, method: str | None, functions: int | None, motion: str | None,
    phases: str | None, format_: str | None, fragment: bool, output: Path | None,
) -> None:  # fmt: skip
    """Print the equations that SymPy derives.

    SCENE is a name that 'nonsmooth scenes' or 'nonsmooth modes' lists, or the path of a scene
    file, which is executed. Without it the equations are those of the paper's oscillator, with
    the paper's numbers. Text is plain ASCII where the terminal has no other characters, or
    with LC_ALL=C.
    """
    check_target(output, ())
    chosen = _format(format_, output)
    if fragment and chosen != "latex":
        raise Problem(f"--fragment: got format {chosen}, expected latex")
    try:
        with busy("deriving the equations"):
            unicode = output is not None or _terminal_has_unicode()
            name = DEFAULT if scene is None else scene
            parts, title = _sections(name, method, functions, motion=motion, phases=phases)
            text = _text_of(parts, title, chosen, fragment, unicode)
    except SceneFileError as error:
        raise Problem(str(error)) from error
    except ValueError as error:
        name, _, expected = str(error).partition(": ")
        option = "SCENE" if name == "scene" else f"--{name}"
        raise Problem(f"{option}: {expected}") from error
    if output is None:
        if chosen == "html":  # with references for what stdout has no character for
            encoding = sys.stdout.encoding or "ascii"
            text = text.encode(encoding, "xmlcharrefreplace").decode(encoding)
        click.echo(text, nl=False)
    elif chosen == "pdf":
        content = tex.pdf(text)
        write_whole(output, lambda target: target.write_bytes(content))
    else:
        write_text(output, text)


def _format(format_: str | None, output: Path | None) -> str:
    """Return the format that the flag or the name of the file asks for.

    A `Problem` is raised if they contradict each other, if the name says nothing that is known,
    or if a PDF has no file or no TeX.
    """
    suffix = "" if output is None else output.suffix.lower()
    named = SUFFIXES.get(suffix)
    if format_ is not None and named not in {None, format_}:
        expected = ", ".join(q for q, name in SUFFIXES.items() if name == format_)
        raise Problem(f"-o: got {output} with --format {format_}, expected {expected}")
    if format_ is None and named is None and suffix:
        expected = ", ".join(SUFFIXES)
        raise Problem(f"-o: got {output}, expected a name that ends in one of {expected}")
    chosen = format_ or named or "text"
    if chosen == "pdf":
        if output is None:
            raise Problem("--format: got pdf without a file, expected -o FILE.pdf")
        tex.engine()
    return chosen


def _sections(
    scene: str, method: str | None, functions: int | None, **order: str | None
) -> "tuple[list[Section], str]":
    """Return the sections on a scene, or on a structure, and their title."""
    methods = [] if method is None else [method]
    name = scene.replace("_", "-")
    if name in structure_names():
        from nonsmooth.codegen.space import structure_named
        from nonsmooth.codegen.space.equations import sections as of_structure

        if functions is not None:
            raise ValueError(f"functions: got {functions}, {scene} has forced modes, all shown")
        for flag, value in order.items():
            if value is not None:
                raise ValueError(f"{flag}: got {value!r}, expected a SCENE that has several")
        return of_structure(name, methods), f"Modes of {structure_named(name).title}"
    from nonsmooth.codegen.equations import scene_named, sections

    if None not in order.values():
        words = "got {phases} beside --motion {motion}, expected one of them"
        raise ValueError(f"phases: {words.format(**order)}")
    title = f"Galerkin equations of {scene_named(scene).title}"
    return sections(scene, methods, functions, **order), title


def _text_of(
    shown: "list[Section]", title: str, format_: str, fragment: bool, unicode: bool
) -> str:
    """Return the document of some sections."""
    from nonsmooth.codegen.printing import html, latex, text

    if format_ == "html":
        return html.page_of(shown, title)
    if format_ == "text":
        return text.text_of(shown, unicode)
    return latex.fragment_of(shown) if fragment else latex.document_of(shown, title)


def _terminal_has_unicode() -> bool:
    """Whether the characters of the equations can be printed, and are wanted."""
    if os.environ.get("LC_ALL") in {"C", "POSIX"}:
        return False
    try:
        "ωₙ²⋅∑∫⎛⎞⟨⟩".encode(sys.stdout.encoding or "ascii")
    except UnicodeEncodeError:
        return False
    return True
