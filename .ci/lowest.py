"""Print pip constraints: every dependency in the lowest version that pyproject.toml allows."""

import tomllib
from pathlib import Path

project = tomllib.loads(Path("pyproject.toml").read_text("utf-8"))["project"]
extras = project["optional-dependencies"]
needed = [*project["dependencies"], *(line for lines in extras.values() for line in lines)]
print("\n".join(line.replace(">=", "==") for line in needed))
