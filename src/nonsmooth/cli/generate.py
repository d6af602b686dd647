"""``nonsmooth generate``: derive the equations and write the kernels."""

from types import ModuleType

import click

from .problems import Problem
from .progress import busy
from .scenes.command import SceneCommand

EPILOG = """\b
Examples:
  nonsmooth generate
  nonsmooth generate impact
  nonsmooth generate --check      for a continuous integration
"""


@click.command(cls=SceneCommand, module="generate", all_without=True, epilog=EPILOG)
@click.option(
    "--check", is_flag=True, help="Only compare, write nothing; exit 1 on a difference."
)
def generate(check: bool) -> int:
    """Derive the equations with SymPy and write generated/.

    A file is written only when its text changes. With SCENE, a name of 'nonsmooth scenes'
    or the path of a scene file, of that scene alone. A scene file is Python and is run.
    """
    with busy("deriving the equations"):
        from nonsmooth.codegen import generate as stage

        return _compare(stage) if check else _write(stage)


def _compare(stage: ModuleType) -> int:
    found = stage.differences()
    click.echo("\n".join(found) if found else f"{stage.FOLDER.name}/ is up to date")
    return 1 if found else 0


def _write(stage: ModuleType) -> int:
    try:
        changes = stage.write()
    except OSError as error:
        raise Problem(f"cannot write {stage.FOLDER}: {error.strerror}") from error
    click.echo("\n".join(changes) if changes else f"{stage.FOLDER.name}/ was up to date")
    return 0
