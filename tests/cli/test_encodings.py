"""Where a terminal does not have a character, the rest is printed, and nothing fails."""

import os
import subprocess
import sys


def printed(encoding: str, *arguments: str) -> tuple[int, str, str]:
    """Return status, stdout and stderr of the command line with an encoding."""
    done = subprocess.run(
        [sys.executable, "-m", "nonsmooth", *arguments],
        capture_output=True,
        env=os.environ | {"PYTHONIOENCODING": encoding},
        check=False,
    )
    return done.returncode, done.stdout.decode(encoding), done.stderr.decode(encoding)


def test_the_verdicts_of_all_solutions_are_printed() -> None:
    status, out, err = printed("ascii", "roots", "--order", "9")
    assert (status, "Traceback" in err) == (0, False)
    assert "the orbit" in out
    assert "?" not in out  # nothing is cut: there is no sign of an ellipsis


def test_a_page_has_references_for_what_is_not_there() -> None:
    status, out, err = printed("latin-1", "equations", "--format", "html", "--method", "hb")
    assert (status, "Traceback" in err) == (0, False)
    assert "213&#8211;224" in out
    assert "?" not in out.partition("<body>")[2].replace("\u00bf", "")
