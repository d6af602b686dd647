"""Load a generated module by its path, wherever it lies."""

import hashlib
import importlib.util
import marshal
import sys
import types
from pathlib import Path

from .sealed import Kept

#: The ending of what this Python has compiled of a module, and what that begins with.
CODE, MAGIC = f".{sys.implementation.cache_tag}.code", importlib.util.MAGIC_NUMBER

#: Those that were loaded, by path and hash of the text.
_LOADED: dict[tuple[Path, str], types.ModuleType] = {}


def module_of(path: Path, kept: Kept | None = None) -> types.ModuleType:
    """Return the module of a file; a file that has changed is another module.

    Parameters
    ----------
    kept : mapping of str to bytes, optional
        What was read of its folder: then the files themselves, and what Python keeps of them in
        ``__pycache__``, are not looked at.
    """
    text = path.read_bytes() if kept is None else kept[path.name]
    key = path, hashlib.sha256(text).hexdigest()
    if key not in _LOADED:
        name = f"nonsmooth_generated_{path.stem}_{key[1][:16]}"
        _LOADED[key] = _imported(name, path) if kept is None else _made(name, path, kept)
    return _LOADED[key]


def with_code(files: Kept, folder: Path) -> Kept:
    """Return files, and beside each module what Python compiles of it in `folder`."""
    codes = {
        place.removesuffix(".py") + CODE: MAGIC + marshal.dumps(_compiled(folder / place, text))
        for place, text in files.items()
        if place.endswith(".py")
    }
    return {**files, **codes}


def _imported(name: str, path: Path) -> types.ModuleType:
    spec = importlib.util.spec_from_file_location(name, path)
    if spec is None or spec.loader is None:
        raise ImportError(f" {str(path)!r} is not a Python module")
    module = importlib.util.module_from_spec(spec)
    sys.modules[name] = module  # where numba looks for it
    spec.loader.exec_module(module)
    return module


def _made(name: str, path: Path, kept: Kept) -> types.ModuleType:
    module = types.ModuleType(name)
    module.__file__ = str(path)
    sys.modules[name] = module  # where numba looks for it
    exec(_code(path, kept), vars(module))
    return module


def _code(path: Path, kept: Kept) -> types.CodeType:
    """Return the code of a module: as it was kept, or, of another Python or place, compiled."""
    found = kept.get(path.stem + CODE, b"")
    if found.startswith(MAGIC):
        code: types.CodeType = marshal.loads(found[len(MAGIC) :])
        if code.co_filename == str(path):
            return code
    return _compiled(path, kept[path.name])


def _compiled(path: Path, text: bytes) -> types.CodeType:
    return compile(text, str(path), "exec", dont_inherit=True)
