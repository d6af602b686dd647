"""``nonsmooth equations``: the derived equations of any scene, numbered as in the paper."""

import os
import sys
from collections.abc import Callable, Iterable
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from nonsmooth.scene_files.error import SceneFileError

from . import tex
from .output import check_target, write_bytes, write_text
from .problems import Problem
from .progress import busy
from .space.named import is_structure

if TYPE_CHECKING:
    from nonsmooth.codegen.printing.sections import Section

METHODS = ("hb", "hb-c1", "c1")

#: What is solved in place of the first two and of the third.
SOLVED = ("hb-symmetric", "c1-reduced")

#: The scene of the paper, whose methods these are.
SCENE = "stick-slip"

#: What the suffix of a file says about its format.
SUFFIXES = {".txt": "text", ".tex": "latex", ".html": "html", ".pdf": "pdf"}

FORMATS = tuple(SUFFIXES.values())

EPILOG = """\b
Examples:
  nonsmooth equations --method hb
  nonsmooth equations -o equations.html
  nonsmooth equations --format latex --fragment -o equations.tex
  nonsmooth equations --method c1 --expand 2
  nonsmooth equations --method hb-symmetric    what is solved for hb, hb-c1
  nonsmooth equations impact --method ck-tau -o impact.pdf
  nonsmooth equations beam-mass
"""


class _Method(click.Choice[str]):
    """The methods of the paper; with another scene, those that it can be derived in."""

    def convert(
        self, value: Any, param: click.Parameter | None, ctx: click.Context | None
    ) -> Any:
        scene = ctx.params.get("scene") if ctx else None
        ours = isinstance(scene, str) and not (scene == SCENE and value in self.choices)
        return value if ours else super().convert(value, param, ctx)


@click.command(epilog=EPILOG)
@click.argument("scene", required=False, is_eager=True)
@click.option(
    "--method",
    type=_Method((*METHODS, *SOLVED)),
    help="Section 3.1, 3.2 or 3.3, without it all; or what is solved in place of the first "
    "two, about mid-stick, and of the third in batches, as one equation.  With a SCENE: hb, "
    "hb-ck, ck or ck-tau, also spelled with its class, as c0-tau.",
)
@click.option(
    "--functions",
    type=int,
    metavar="K",
    help="With a SCENE and hb-ck: functions with a break at each switch; without it one, at "
    "an impact two.",
)
@click.option(
    "--format", "format_", type=click.Choice(FORMATS),
    help="Text for the terminal, a LaTeX document, a page, or a PDF made by the TeX installed; "
    "without it, what the name of the file says, or text.",
)  # fmt: skip
@click.option("--fragment", is_flag=True, help=r"LaTeX without a preamble, to \input.")
@click.option(
    "--expand", "order", type=int, metavar="N",
    help="The equations of order N, 1 to 5, written out in full.",
)  # fmt: skip
@click.option("-o", "--output", type=click.Path(path_type=Path), help="Write to this file.")
def equations(
    scene: str | None, method: str | None, functions: int | None, format_: str | None,
    fragment: bool, order: int | None, output: Path | None,
) -> None:  # fmt: skip
    """Print the equations that SymPy derives, with the numbers of the paper.

    SCENE is the name of an oscillator, or the path of its file, a program that is run, or a
    structure of 'nonsmooth modes'; without it the equations are those of the paper.
    Text is plain ASCII where the terminal has no other characters, or with LC_ALL=C.
    """
    check_target(output, ())
    chosen = _format(format_, output)
    if fragment and chosen != "latex":
        raise Problem(f"--fragment: got format {chosen}, expected latex")
    ours = scene is not None and not (scene == SCENE and method in (None, *METHODS, *SOLVED))
    if functions is not None and not ours:
        raise Problem(f"--functions: got {functions}, expected a SCENE and hb-ck with it")
    if order is not None and ours:
        raise Problem(
            f"--expand: got {order}, expected no SCENE: only the paper's are written out"
        )
    try:
        with busy("deriving the equations"):
            if ours and scene is not None:
                text = _of_scene(scene, method, functions, chosen, fragment, output is not None)
            else:
                document = _document(chosen, fragment, output is not None)
                text = document([method] if method else METHODS, order)
    except SceneFileError as error:
        raise Problem(str(error)) from error
    except ValueError as error:
        name, _, expected = str(error).partition(": ")
        option = {"order": "--expand", "scene": "SCENE"}.get(name, f"--{name}")
        raise Problem(f"{option}: {expected}") from error
    if output is None:
        click.echo(text, nl=False)
    elif chosen == "pdf":
        write_bytes(output, tex.pdf(text))
    else:
        write_text(output, text)


def _format(format_: str | None, output: Path | None) -> str:
    """Return the format that the flag or the name of the file asks for.

    Raises
    ------
    Problem
        If they contradict each other, if the name says nothing that is known, or if a PDF
        has no file or no TeX.
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


def _document(
    format_: str, fragment: bool, to_file: bool
) -> Callable[[Iterable[str], int | None], str]:
    """Return what makes the document of this format."""
    if format_ == "html":
        from nonsmooth.codegen.printing.html import html_document  # noqa: PLC0415

        return html_document
    if format_ == "text":
        from nonsmooth.codegen.printing.text import text_document  # noqa: PLC0415

        return partial(text_document, unicode=to_file or _terminal_has_unicode())
    from nonsmooth.codegen.printing import latex  # noqa: PLC0415

    return latex.latex_fragment if fragment else latex.latex_document


def _of_scene(
    scene: str, method: str | None, functions: int | None, format_: str, fragment: bool,
    to_file: bool,
) -> str:  # fmt: skip
    """Return the document of a scene."""
    from nonsmooth.codegen.printing import html, latex, text  # noqa: PLC0415

    shown, title = _sections(scene, [method] if method else [], functions)
    if format_ == "html":
        return html.page_of(shown, title)
    if format_ == "text":
        return text.text_of(shown, to_file or _terminal_has_unicode())
    return latex.fragment_of(shown) if fragment else latex.document_of(shown, title)


def _sections(
    scene: str, methods: list[str], functions: int | None
) -> "tuple[list[Section], str]":
    """Return the sections on a scene, or on a structure, and their title."""
    if is_structure(scene):
        from nonsmooth.codegen.space import structure_named  # noqa: PLC0415
        from nonsmooth.codegen.space.show import sections  # noqa: PLC0415

        if functions is not None:
            raise ValueError(f"functions: got {functions}, {scene} has forced modes, all shown")
        name = scene.replace("_", "-")
        return sections(name, methods), f"Modes of {structure_named(name).title}"
    from nonsmooth.codegen import show  # noqa: PLC0415

    title = f"Galerkin equations of {show.scene_named(scene).title}"
    return show.sections(scene, methods, functions), title


def _terminal_has_unicode() -> bool:
    """Whether the characters of the equations can be printed, and are wanted."""
    if os.environ.get("LC_ALL") in {"C", "POSIX"}:
        return False
    try:
        "ωₙ²⋅∑∫⎛⎞⟨⟩".encode(sys.stdout.encoding or "ascii")
    except UnicodeEncodeError:
        return False
    return True
