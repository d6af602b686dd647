"""The equations of any scene in any expansion, as records to be printed: text, LaTeX, HTML.

Input: a `Scene`, of one mass or of a body, and its `GalerkinConditions` in an expansion.
Output: `scene_equations`, the oscillator; `method_equations`, a `GalerkinSystem` with every
condition from its statement to its closed form, the tables it uses, and a description of each
unknown.  `derive_scene` and `sections` find scene and expansion by their names.

No scene is named here; an expansion is recognised by its unknowns.
"""

from .method import method_equations
from .of_scene import scene_equations
from .registry import derive_scene, scene_named, sections

__all__ = ["derive_scene", "method_equations", "scene_equations", "scene_named", "sections"]
