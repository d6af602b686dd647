"""``nonsmooth generate``: derive the equations and write the kernels, of one scene or all."""

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING

import click

from ..named import NamedCommand
from ..problems import Problem
from ..progress import busy
from .named import scene_named

if TYPE_CHECKING:
    from nonsmooth.solver.scenes.loaded import LoadedScene

CHECK = "Only compare, write nothing; exit 1 on a difference."

HELP = """Derive the equations of {name} with SymPy and write its kernels.

Of a shipped scene into generated/, a file only when its text changes. The kernels of a scene
file are derived when it is first used, and kept in the user's cache: this says where."""

EPILOG = """\b
Examples:
  nonsmooth generate
  nonsmooth generate impact
  nonsmooth generate --check      for a continuous integration
"""

EPILOG_OF = """\b
Examples:
  nonsmooth generate {name}
  nonsmooth generate {name} --check
"""


@click.command(cls=NamedCommand, default=None, epilog=EPILOG)
@click.option("--check", is_flag=True, help=CHECK)
def generate(check: bool) -> int:
    """Derive the equations with SymPy and write generated/.

    A file is written only when its text changes. With SCENE, a name of 'nonsmooth scenes'
    or the path of a scene file, of that scene alone. A scene file is Python and is run.
    """
    with busy("deriving the equations"):
        from nonsmooth.codegen import generate as stage

        if check:
            found = stage.differences()
        else:
            with _writing(stage.FOLDER):
                found = stage.write()
    otherwise = f"{stage.FOLDER.name}/ {'is' if check else 'was'} up to date"
    click.echo("\n".join(found) if found else otherwise)
    return 1 if check and found else 0


@dataclass(frozen=True)
class NotGenerated:
    """A scene that comes with the program, and has no kernels yet."""

    name: str

    @property
    def folder(self) -> Path:
        """The folder of its kernels; only its name counts."""
        return Path(self.name.replace("-", "_"))


def named(text: str) -> "LoadedScene | NotGenerated":
    """Return the scene of a name or of a file, also one that was never generated.

    Raises
    ------
    UsageError, Problem
        See `scene_named`.
    """
    try:
        return scene_named(text)
    except click.UsageError:
        new = NotGenerated(text.replace("_", "-"))
        codegen = find_spec("nonsmooth.codegen")  # not imported: it would load SymPy
        folders = [] if codegen is None else codegen.submodule_search_locations or []
        if not any((Path(q) / "scenes" / f"{new.folder}.py").is_file() for q in folders):
            raise
        return new


def command(scene: "LoadedScene | NotGenerated", said: str) -> click.Command:
    """Return ``nonsmooth generate`` of a scene, which the user called so."""
    return click.Command(
        scene.name,
        params=[click.Option(["--check"], is_flag=True, help=CHECK)],
        callback=lambda check: run(scene, check),
        help=HELP.format(name=scene.name),
        epilog=EPILOG_OF.format(name=said),
    )


def run(scene: "LoadedScene | NotGenerated", check: bool) -> int:
    """Derive the kernels of a scene, and compare or write them; the exit status."""
    from nonsmooth.solver.kernels.registry import names

    if not isinstance(scene, NotGenerated) and scene.name not in names():
        click.echo(f"{scene.name}: its kernels are in {scene.folder}")
        return 0
    with busy(f"deriving the equations of {scene.name}"):
        from nonsmooth.codegen import generate, scenes

        sources = generate.scene_sources(scenes.load(scene.name))
        fresh = {name: generate.encoded(content) for name, content in sources}
    folder = generate.FOLDER / scene.folder.name
    changed = [name for name, content in fresh.items() if _content(folder / name) != content]
    if not changed:
        click.echo(f"{generate.FOLDER.name}/{folder.name}/ is up to date")
        return 0
    if not check:
        with _writing(folder):
            _write(folder, {name: fresh[name] for name in changed})
    done = "differs" if check else "written"
    click.echo("\n".join(f"{folder.name}/{name}: {done}" for name in changed))
    return 1 if check else 0


@contextmanager
def _writing(folder: Path) -> Iterator[None]:
    try:
        yield
    except OSError as error:
        raise Problem(f"cannot write {folder}: {error.strerror}") from error


def _content(path: Path) -> bytes | None:
    return path.read_bytes() if path.is_file() else None


def _write(folder: Path, files: dict[str, bytes]) -> None:
    from nonsmooth.files.whole import whole

    for name, content in files.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        with whole(folder / name) as temporary:
            temporary.write_bytes(content)
