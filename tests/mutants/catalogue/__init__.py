"""The mistakes, a module for each of what they break."""

import importlib
import pkgutil

from ..mutant import Mutant


def areas() -> dict[str, tuple[Mutant, ...]]:
    """Return the mutants of each area, in the order of their names."""
    names = sorted(module.name for module in pkgutil.iter_modules(__path__))
    return {name: importlib.import_module(f"{__name__}.{name}").MUTANTS for name in names}
