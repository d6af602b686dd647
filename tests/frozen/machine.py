"""What last bits depend on beside the program: libraries, and what the processor can do."""

import json
import platform
from importlib.metadata import version

from numpy._core._multiarray_umath import __cpu_features__

LIBRARIES = ("numpy", "scipy", "sympy", "numba", "latex2mathml", "python-flint")


def described() -> dict[str, str]:
    """Return the versions of the libraries, and the features of the processor."""
    features = " ".join(sorted(name for name, there in __cpu_features__.items() if there))
    versions = {name: version(name) for name in LIBRARIES}
    return {"python": platform.python_version(), "processor": features, **versions}


def text() -> str:
    """Return the description as JSON."""
    return json.dumps(described(), indent=1, sort_keys=True) + "\n"
