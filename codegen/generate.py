"""Write ``generated/``: a file only when its text changes.

Input: the scenes and the expansions.  Output: the folder, complete and with nothing else: a
table of the methods, their kernels, a folder for each scene, and one for the structures of
`space`.
"""

import os
import tempfile
from collections.abc import Iterator
from pathlib import Path

from . import expansions, scenes
from .emission import method_table as methods
from .emission import one_function, phase_maps, scene_numbers, whole_period
from .scene import Scene
from .space import emission as space

#: The folder of the generated modules, beside the folder of this file.
FOLDER = Path(__file__).resolve().parent.parent / "generated"

INIT = '"""Kernels, and scenes in numbers, written by ``nonsmooth generate``."""\n'

#: Of the folder of a scene.
SCENE_INIT = '"""{name}: {title}; written by ``nonsmooth generate``."""\n'


def sources() -> dict[str, str]:
    """Derive everything and return the text of each generated file, by its place."""
    files = {"__init__.py": INIT, "methods.py": methods.methods_source()}
    files |= {"hb.py": whole_period.module_source(), "hb_c1.py": one_function.module_source()}
    for name, expansion in expansions.modules().items():
        if expansions.kernel_name(expansion) == name and hasattr(expansion, "test"):
            files[f"{name}.py"] = phase_maps.module_source(expansion)
    for scene in map(scenes.load, scenes.names()):
        folder = scene.name.replace("-", "_")
        files |= {f"{folder}/{name}": text for name, text in scene_sources(scene)}
    return files | space.sources()


def scene_sources(scene: Scene) -> Iterator[tuple[str, str]]:
    """Yield place and text of each file of the folder of a scene: what it is in numbers.

    Several motions have a folder each, as if each were a scene of its own.
    """
    yield "__init__.py", SCENE_INIT.format(name=scene.label, title=scene.title)
    yield "scene.py", scene_numbers.scene_source(scene)
    for motion in scene.motions:
        folder = motion.replace("-", "_")
        for name, text in scene_sources(scene.of_motion(motion)):
            yield f"{folder}/{name}", text


def _present(folder: Path) -> dict[str, str]:
    paths = sorted(folder.rglob("*.py"))
    return {path.relative_to(folder).as_posix(): path.read_text("utf-8") for path in paths}


def differences(folder: Path = FOLDER) -> list[str]:
    """Return what `folder` and a fresh derivation do not agree on, a line each."""
    fresh, present = sources(), _present(folder)
    missing = [f"{name}: missing" for name in fresh.keys() - present.keys()]
    extra = [f"{name}: not generated" for name in present.keys() - fresh.keys()]
    common = fresh.keys() & present.keys()
    changed = [f"{name}: differs" for name in common if fresh[name] != present[name]]
    return sorted(missing + extra + changed)


def write(folder: Path = FOLDER) -> list[str]:
    """Bring `folder` up to date and return what changed, a line each.

    Raises
    ------
    OSError
        If the folder cannot be written.
    """
    fresh, present = sources(), _present(folder)
    changes = []
    for name, text in fresh.items():
        if present.get(name) != text:
            _replace(folder / name, text)
            changes.append(f"{name}: written")
    for name in sorted(present.keys() - fresh.keys()):
        (folder / name).unlink()
        changes.append(f"{name}: removed")
    return changes


def _replace(path: Path, text: str) -> None:
    """Write `path` whole or not at all."""
    path.parent.mkdir(parents=True, exist_ok=True)
    handle, temporary = tempfile.mkstemp(dir=path.parent, suffix=".tmp")
    try:
        with os.fdopen(handle, "w", encoding="utf-8", newline="\n") as file:
            file.write(text)
        os.chmod(temporary, 0o644)
        os.replace(temporary, path)
    except BaseException:
        os.unlink(temporary)
        raise
