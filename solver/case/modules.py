"""Load a generated module by its path, wherever it lies."""

import hashlib
import importlib.util
import sys
import types
from functools import cache
from pathlib import Path


def module_of(path: Path) -> types.ModuleType:
    """Return the module of a file; a file that has changed is another module."""
    return _module_of_text(path, hashlib.sha256(path.read_bytes()).hexdigest())


@cache
def _module_of_text(path: Path, digest: str) -> types.ModuleType:
    name = f"nonsmooth_generated_{path.stem}_{digest[:16]}"
    spec = importlib.util.spec_from_file_location(name, path)
    if spec is None or spec.loader is None:
        raise ImportError(f" {str(path)!r} is not a Python module")
    module = importlib.util.module_from_spec(spec)
    sys.modules[name] = module  # where numba looks for it
    spec.loader.exec_module(module)
    return module
