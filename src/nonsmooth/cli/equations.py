"""``nonsmooth equations``: the derived equations, numbered as in the paper."""

from pathlib import Path

import click

from .output import check_target, write_text

METHODS = ("hb", "hb-c1", "c1")


@click.command()
@click.option(
    "--method", type=click.Choice(METHODS), help="Section 3.1, 3.2 or 3.3; without it, all."
)
@click.option(
    "--format", "format_", type=click.Choice(["text", "latex"]), default="text",
    help="Text for the terminal, or a LaTeX document.",
)  # fmt: skip
@click.option("-o", "--output", type=click.Path(path_type=Path), help="Write to this file.")
def equations(method: str | None, format_: str, output: Path | None) -> None:
    """Print the equations that SymPy derives, with the numbers of the paper."""
    check_target(output, ())
    from nonsmooth.codegen import printing  # noqa: PLC0415

    document = {"text": printing.text_document, "latex": printing.latex_document}[format_]
    text = document([method] if method else METHODS)
    if output is None:
        click.echo(text, nl=False)
    else:
        write_text(output, text)
