"""Load a generated module by its path, wherever it lies."""

import hashlib
import sys
import types
from pathlib import Path

from .sealed import Kept

#: Those that were loaded, by path and hash of the text.
_LOADED: dict[tuple[Path, str], types.ModuleType] = {}


def module_of(path: Path, kept: Kept | None = None) -> types.ModuleType:
    """Return the module of a file; a file that has changed is another module.

    Of what was read of its folder before, `kept`, if that is given: then the files themselves
    are not looked at.
    """
    text = path.read_bytes() if kept is None else kept[path.name]
    key = path, hashlib.sha256(text).hexdigest()
    if key not in _LOADED:
        name = f"nonsmooth_generated_{path.stem}_{key[1][:16]}"
        module = types.ModuleType(name)
        module.__file__ = str(path)
        sys.modules[name] = module  # where numba looks for it
        exec(compile(text, str(path), "exec", dont_inherit=True), vars(module))
        _LOADED[key] = module
    return _LOADED[key]
