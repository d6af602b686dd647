"""Write ``generated/``: a file only when its text changes.

Input: the scenes and the expansions.  Output: the folder, complete and with nothing else: a
table of the methods, their kernels, a folder for each scene, and one for the structures of
`space`.
"""

from collections.abc import Iterator
from pathlib import Path

from ..whole import whole
from . import expansions, scenes
from .emission import force_formulas, one_function, phase_maps, scene_numbers, whole_period
from .emission import method_table as methods
from .galerkin import force_harmonics, force_series
from .scene import Scene
from .space import emission as space

#: The folder of the generated modules, beside the folder of this file.
FOLDER = Path(__file__).resolve().parent.parent / "generated"

INIT = '"""Kernels, and scenes in numbers, written by ``nonsmooth generate``."""\n'

#: Of the folder of a scene.
SCENE_INIT = '"""{name}: {title}; written by ``nonsmooth generate``."""\n'


#: What a generated file holds: text, or the matrices of a body.
Content = str | bytes


def sources() -> dict[str, Content]:
    """Derive everything and return the content of each generated file, by its place."""
    files: dict[str, Content] = {"__init__.py": INIT, "methods.py": methods.methods_source()}
    files |= {"hb.py": whole_period.module_source(), "hb_c1.py": one_function.module_source()}
    for record, kind in ((force_series, "recurrences"), (force_harmonics, "harmonics")):
        name = record.__name__.rpartition(".")[2]
        files[f"{name}.py"] = force_formulas.module_source(record, kind)
    for name, expansion in expansions.modules().items():
        if expansions.kernel_name(expansion) == name and hasattr(expansion, "test"):
            files[f"{name}.py"] = phase_maps.module_source(expansion)
    for name in scenes.names():
        files |= _in_its_folder(name)
    return files | space.sources()


def _in_its_folder(name: str) -> dict[str, Content]:
    """Return the content of each file of a scene's folder, by its place."""
    files, folder = scene_sources(scenes.load(name)), name.replace("-", "_")
    return {f"{folder}/{place}": content for place, content in files}


def scene_sources(scene: Scene) -> Iterator[tuple[str, Content]]:
    """Yield place and content of each file of the folder of a scene: what it is in numbers.

    Several motions have a folder each, as if each were a scene of its own.
    """
    yield "__init__.py", SCENE_INIT.format(name=scene.label, title=scene.title)
    yield "scene.py", scene_numbers.scene_source(scene)
    if scene.body is not None:
        yield "body.npz", scene_numbers.matrices(scene)
    for motion in scene.declared:
        folder = motion.replace("-", "_")
        for name, content in scene_sources(scene.of_motion(motion)):
            yield f"{folder}/{name}", content


def _present(folder: Path) -> dict[str, Content]:
    files: dict[str, Content] = {}
    for path in sorted(q for q in folder.rglob("*") if q.suffix in (".py", ".npz")):
        text = path.suffix == ".py"
        name = path.relative_to(folder).as_posix()
        files[name] = path.read_text("utf-8") if text else path.read_bytes()
    return files


def _both(folder: Path, scene: str | None) -> tuple[dict[str, Content], dict[str, Content]]:
    """Return what is derived and what is there, of everything or of one scene."""
    present = _present(folder)
    if scene is None:
        return sources(), present
    name = scene.replace("_", "-")
    prefix = f"{name.replace('-', '_')}/"
    return _in_its_folder(name), {q: v for q, v in present.items() if q.startswith(prefix)}


def differences(folder: Path, scene: str | None = None) -> list[str]:
    """Return what `folder` and a fresh derivation do not agree on, a line each.

    Of one scene alone, if it is named; a `ValueError` if there is none of this name.
    """
    fresh, present = _both(folder, scene)
    missing = [f"{name}: missing" for name in fresh.keys() - present.keys()]
    extra = [f"{name}: not generated" for name in present.keys() - fresh.keys()]
    common = fresh.keys() & present.keys()
    changed = [f"{name}: differs" for name in common if fresh[name] != present[name]]
    return sorted(missing + extra + changed)


def write(folder: Path, scene: str | None = None) -> list[str]:
    """Bring `folder` up to date and return what changed, a line each; see `differences`.

    An `OSError` is raised if the folder cannot be written.
    """
    fresh, present = _both(folder, scene)
    changes = []
    for name, content in fresh.items():
        if present.get(name) != content:
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            with whole(folder / name) as temporary:
                encoded = content.encode() if isinstance(content, str) else content
                temporary.write_bytes(encoded)
            changes.append(f"{name}: written")
    for name in sorted(present.keys() - fresh.keys()):
        (folder / name).unlink()
        changes.append(f"{name}: removed")
    return changes
