"""A PDF from a LaTeX document, by the TeX that is installed; nothing is fetched."""

import os
import shutil
import subprocess
import tempfile
from pathlib import Path

from ..problems import Problem

#: One run suffices: the documents refer to nothing.
COMMAND = ("-interaction=nonstopmode", "-halt-on-error", "-no-shell-escape")

#: Seconds after which TeX is taken to hang; the longest document takes two.
PATIENCE = 120


def engine() -> str:
    """Return the path of ``pdflatex``; a `Problem` says what to install."""
    path = shutil.which("pdflatex")
    if path is None:
        raise Problem(
            "--format: pdf needs pdflatex, which is not on the PATH (Debian: apt-get install "
            "texlive-latex-base); --format latex writes the document without it"
        )
    return path


def pdf(document: str) -> bytes:
    """Return the PDF that ``pdflatex`` makes of `document`.

    A `Problem` is raised if there is no TeX, or with the first error of its log.
    """
    with tempfile.TemporaryDirectory(prefix="nonsmooth-") as name:
        folder = Path(name)
        (folder / "equations.tex").write_text(document, "utf-8")
        finished = _run([engine(), *COMMAND, "equations.tex"], folder)
        file = folder / "equations.pdf"
        if finished.returncode != 0 or not file.is_file():
            raise Problem(f"--format: pdflatex failed: {first_error(finished.stdout)}")
        return file.read_bytes()


def _run(command: list[str], folder: Path) -> subprocess.CompletedProcess[str]:
    # Lines of the log are not to be broken: its first error is shown.
    environment = os.environ | {"max_print_line": "1000"}
    try:
        return subprocess.run(
            command, cwd=folder, env=environment, stdin=subprocess.DEVNULL, check=False,
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=PATIENCE,
            encoding="utf-8", errors="replace",
        )  # fmt: skip
    except subprocess.TimeoutExpired as error:
        raise Problem(f"--format: pdflatex was not done after {PATIENCE} s") from error


def first_error(log: str) -> str:
    r"""Return the first error in a log of TeX, with the line where it is, or its last line.

    Examples
    --------
    >>> first_error("This is pdfTeX\n! Undefined control sequence.\nl.3 \\foo\n")
    '! Undefined control sequence. l.3 \\foo'
    """
    lines = [line.strip() for line in log.splitlines() if line.strip()]
    place = next((i for i, line in enumerate(lines) if line.startswith("!")), None)
    if place is None:
        return lines[-1] if lines else "without a message"
    where = next((line for line in lines[place:] if line.startswith("l.")), "")
    return f"{lines[place]} {where}".strip()
