"""Read a scene file by running it as Python; every error becomes a message of one line."""

import os
import sys
from contextlib import redirect_stdout
from pathlib import Path
from traceback import walk_tb
from types import CodeType, ModuleType
from typing import TYPE_CHECKING

from .error import SceneFileError, one_line

if TYPE_CHECKING:
    from nonsmooth.codegen.scene import Scene

#: The name that a scene file assigns its scene to.
NAME = "SCENE"

#: Endings of other files that are given in its place, and how these are given.
OTHERS = {
    ".toml": "a case file is given by --case",
    ".json": "a saved orbit is given by --from-orbit of branch, or read by load",
    ".nc": "a saved orbit is given by --from-orbit of branch, or read by load",
}


def is_path(text: str) -> bool:
    """Whether a text is the path of a file, and not the name of a scene.

    Examples
    --------
    >>> is_path("impact"), is_path("./impact"), is_path("impact.py")
    (False, True, True)
    """
    return text.endswith((".py", *OTHERS)) or any(q in text for q in (os.sep, os.altsep) if q)


def text_of(path: Path) -> bytes:
    """Return the bytes of a scene file.

    A `SceneFileError` is raised if its name has another ending, it does not exist or cannot be
    read.
    """
    if path.is_dir():
        raise SceneFileError(f"{path}: a folder, expected a scene file")
    if path.suffix != ".py":
        hint = f"; {OTHERS[path.suffix]}" if path.suffix in OTHERS else ""
        raise SceneFileError(f"{path}: expected a scene file, with a name in .py{hint}")
    try:
        return path.read_bytes()
    except FileNotFoundError:
        raise SceneFileError(f"{path}: there is no such file") from None
    except (OSError, ValueError) as error:
        reason = error.strerror if isinstance(error, OSError) else str(error)
        raise SceneFileError(f"{path}: cannot be read: {reason}") from None


def read_scene(path: Path, text: bytes) -> "Scene":
    """Run the text of a scene file and return the scene that it defines.

    A `SceneFileError` is raised if it is not Python, raises an exception, or does not define a
    scene.
    """
    from nonsmooth.codegen.scene import Scene  # noqa: PLC0415  (SymPy)

    names = _run(path, _compiled(path, text))
    if NAME not in names:
        raise SceneFileError(f"{path}: defines no {NAME}, expected {NAME} = Scene(...)")
    scene = names[NAME]
    if not isinstance(scene, Scene):
        kind = type(scene).__name__
        raise SceneFileError(f"{path}: {NAME}: got a value of type {kind}, expected a Scene")
    return scene


def _compiled(path: Path, text: bytes) -> CodeType:
    try:
        return compile(text, str(path), "exec", dont_inherit=True)
    except SyntaxError as error:
        where = f", line {error.lineno}" if error.lineno else ""
        raise SceneFileError(f"{path}{where}: {error.msg}") from None
    except (ValueError, RecursionError, MemoryError) as error:
        raise SceneFileError(f"{path}: no Python: {one_line(error)}") from None


def _run(path: Path, code: CodeType) -> dict[str, object]:
    """Run the code of a scene file and return its names; its output goes to stderr."""
    from nonsmooth.codegen.scene import SceneError  # noqa: PLC0415  (SymPy)

    module = ModuleType("nonsmooth_scene_file")
    module.__file__ = str(path)
    try:
        with redirect_stdout(sys.stderr):
            exec(code, vars(module))
    except (Exception, SystemExit) as error:
        reason = str(error) if isinstance(error, SceneError) else one_line(error)
        raise SceneFileError(f"{path}{_line(error, path)}: {reason}") from error
    return vars(module)


def _line(error: BaseException, path: Path) -> str:
    """Return in words the line of a file in which an error occurred; empty if in none."""
    lines = [
        line
        for frame, line in walk_tb(error.__traceback__)
        if frame.f_code.co_filename == str(path)
    ]
    return f", line {lines[-1]}" if lines else ""
