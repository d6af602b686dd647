"""What is installed is what there is: setuptools is told every folder by name."""

import tomllib
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


def test_every_package_is_listed():
    project = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))
    listed = project["tool"]["setuptools"]["packages"]
    top = ROOT / "src"
    folders = [
        *(path.parent for path in (top / "nonsmooth").glob("**/__init__.py")),
        *(
            link / path.parent.relative_to(link.resolve())
            for link in (top / "nonsmooth").iterdir()
            if link.is_symlink() and link.is_dir()
            for path in link.resolve().glob("**/__init__.py")
        ),
    ]
    there = {".".join(folder.relative_to(top).parts) for folder in folders}
    assert sorted(listed) == sorted(there)
