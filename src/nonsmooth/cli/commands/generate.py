"""``nonsmooth generate``: derive the equations and write the kernels, of one scene or all."""

import click
from click.shell_completion import CompletionItem

from nonsmooth.scene_files.read import is_path

from ..about import completed
from ..named import scene_named, scene_names
from ..problems import Problem
from ..progress import busy

EPILOG = """\b
Examples:
  nonsmooth generate
  nonsmooth generate impact
  nonsmooth generate --check      for continuous integration
"""


def _names(_: click.Context, __: click.Parameter, incomplete: str) -> list[CompletionItem]:
    return completed(scene_names(), incomplete)


@click.command(epilog=EPILOG)
@click.argument("scene", required=False, shell_complete=_names)
@click.option(
    "--check", is_flag=True, help="Only compare, write nothing; exit 1 on a difference."
)
def generate(scene: str | None, check: bool) -> int:
    """Derive the equations and write generated/ (for developers).

    A file is written only when its text changes. With SCENE, a name that 'nonsmooth scenes'
    lists, only those of that scene. For the path of a scene file, which is executed, nothing
    is written there: its kernels are kept in the user's cache, and this says where.
    """
    if scene is not None and is_path(scene):
        loaded = scene_named(scene)
        click.echo(f"{loaded.name}: its kernels are in {loaded.folder}")
        return 0
    of_scene = "" if scene is None else f" of {scene}"
    with busy(f"deriving the equations{of_scene}"):
        from nonsmooth.codegen import generate as stage

        done = stage.differences if check else stage.write
        try:
            lines = done(stage.FOLDER, scene)
        except ValueError as error:
            raise click.UsageError(str(error), click.get_current_context()) from error
        except OSError as error:
            raise Problem(f"cannot write {stage.FOLDER}: {error.strerror}") from error
    folder = stage.FOLDER.name + ("" if scene is None else f"/{scene.replace('-', '_')}")
    click.echo("\n".join(lines) or f"{folder}/ {'is' if check else 'was'} up to date")
    return 1 if check and lines else 0
