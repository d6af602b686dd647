"""Any scene in any expansion for a reader: the records that text, LaTeX and HTML print.

Input: a `Scene`, of one mass or of a body, and its `GalerkinConditions` in an expansion.
Output: `scene_equations`, the oscillator; `method_equations`, a `GalerkinSystem` with every
condition from its statement to its closed form, what it looks up, and what each unknown is.
`derive_scene` and `sections` find scene and expansion by their names.

Nothing here names a scene; an expansion is told by what its conditions hold.
"""

from .method import method_equations
from .of_scene import scene_equations
from .registry import derive_scene, scene_named, sections

__all__ = ["derive_scene", "method_equations", "scene_equations", "scene_named", "sections"]
