"""A scene file for tests that write one, and a derivation that costs nothing."""

from collections.abc import Iterator
from pathlib import Path

from shown import ROOT

#: The text of a good scene file.
BALL = (ROOT / "examples" / "bouncing_ball.py").read_text("utf-8")

#: A folder of kernels that stands for those of any scene.
IMPACT = ROOT / "generated" / "impact"


def kernels_of_impact(scene) -> Iterator[tuple[str, str]]:
    """Yield the kernels of impact under the name of another scene."""
    for path in sorted(IMPACT.glob("*.py")):
        text = path.read_text("utf-8")
        yield path.name, text.replace("NAME = 'impact'", f"NAME = {scene.name!r}")


def write(folder: Path, text: str = BALL, name: str = "ball.py") -> Path:
    """Write a scene file and return its path."""
    path = folder / name
    path.write_text(text, "utf-8")
    return path
