"""The file of a body's matrices, in the folder of its scene."""

import io
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from ..loaded import LoadedScene

#: Its name.
MATRICES = "body.npz"


def matrices_of(scene: "LoadedScene") -> Mapping[str, Any]:
    """Return the arrays of the file: of each matrix its shape and, if numeric, its entries."""
    kept = None if scene.kept is None else scene.kept[MATRICES]
    with np.load(scene.folder / MATRICES if kept is None else io.BytesIO(kept)) as file:
        return dict(file)
