"""A copy of the project in which a mistake is made, tried and taken back."""

import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from .mutant import Mutant

ROOT = Path(__file__).resolve().parents[2]

#: Pytest's status where a test module cannot be imported, as with a derivation that is refused.
COLLECTION = 2

#: Seconds after which a run counts as one that hangs.
PATIENCE = 400.0


class CatalogueError(Exception):
    """A mutant that cannot be made, or whose tests do not run."""


class Workplace:
    """A copy that outlives the run, so that what numba has compiled is found again.

    Parameters
    ----------
    number : int
        Each worker has its own copy.
    """

    def __init__(self, number: int) -> None:
        self.folder = Path(tempfile.gettempdir()) / f"nonsmooth-mutants-{os.getuid()}-{number}"
        self._copy()

    def _copy(self) -> None:
        listed = subprocess.run(
            ["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
            cwd=ROOT,
            check=True,
            capture_output=True,
            text=True,
        ).stdout.split("\0")
        names = {name for name in listed if name and os.path.lexists(ROOT / name)}
        for name in sorted(names):
            source, target = ROOT / name, self.folder / name
            target.parent.mkdir(parents=True, exist_ok=True)
            if os.path.lexists(target):
                target.unlink()
            shutil.copy2(source, target, follow_symlinks=False)
        for path in self.folder.rglob("*.py"):
            if "__pycache__" not in path.parts and not _listed(path, self.folder, names):
                path.unlink()

    def _run(
        self, *arguments: str, patience: float | None = PATIENCE
    ) -> subprocess.CompletedProcess[str]:
        environment = os.environ | {
            "PYTHONPATH": str(self.folder / "src"),
            "PYTHONDONTWRITEBYTECODE": "1",  # a mistake of the same size and second is read
        }
        return subprocess.run(
            [sys.executable, *arguments],
            cwd=self.folder,
            env=environment,
            capture_output=True,
            text=True,
            timeout=patience,
            check=False,
        )

    def pytest(
        self, tests: tuple[str, ...], patience: float | None = PATIENCE
    ) -> tuple[int, str]:
        """Run tests up to the first failure and return pytest's status and its output.

        As `make test` does, without those that are long: nothing that catches a mistake is
        left to them.
        """
        options = ("-x", "-rfE", "-p", "no:cacheprovider", "-m", "not long")
        done = self._run("-m", "pytest", *options, *tests, patience=patience)
        return done.returncode, done.stdout + done.stderr

    def caught_by(self, mutant: Mutant) -> str:
        """Make the mistake, run its tests, take it back; what failed, or nothing.

        Raises
        ------
        CatalogueError
            If the text to replace does not stand there once, or the tests cannot be run.
        """
        path = self.folder / mutant.file
        text = path.read_text("utf-8")
        if text.count(mutant.old) != 1:
            raise CatalogueError(
                f"{mutant.file} has {text.count(mutant.old)} of {mutant.old!r}"
            )
        before = {path: (text, path.stat())}
        for generated in (self.folder / "generated").rglob("*.py"):
            before[generated] = (generated.read_text("utf-8"), generated.stat())
        try:
            path.write_text(text.replace(mutant.old, mutant.new), "utf-8")
            if mutant.regenerate:
                done = self._run("-m", "nonsmooth", "generate")
                if done.returncode:
                    return "nonsmooth generate: " + done.stderr.strip()[-200:]
            status, output = self.pytest(mutant.tests)
        except subprocess.TimeoutExpired:
            return "hangs"
        finally:
            for name, (old, stat) in before.items():
                name.write_text(old, "utf-8")
                os.utime(name, ns=(stat.st_atime_ns, stat.st_mtime_ns))
        if status == COLLECTION and "during collection" in output:
            return "cannot be imported"
        if status not in {0, 1}:
            raise CatalogueError(f"pytest ended with {status}: {output[-600:]}")
        if status == 0:
            return ""
        failed = [line for line in output.splitlines() if line.startswith(("FAILED", "ERROR"))]
        return failed[0].split(" - ")[0] if failed else "a test"


def _listed(path: Path, folder: Path, names: set[str]) -> bool:
    """Whether the project has this file, or it stands behind a link of the project."""
    relative = path.relative_to(folder)
    return str(relative) in names or any(str(parent) in names for parent in relative.parents)
