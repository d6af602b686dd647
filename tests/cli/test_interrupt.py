"""Ctrl-C: during commands, and where Python would forget it."""

import os
import signal
import subprocess
import sys
import textwrap
import time
from pathlib import Path

import pytest

INTERRUPTED = (130, "nonsmooth: interrupted\n")

SHAPE = """
import ctypes, signal, sys, time
from nonsmooth.interrupt import end_on_interrupt

signal.signal(signal.SIGINT, signal.{handler})

class Interrupted:
    def __del__(self):
        signal.raise_signal(signal.SIGINT)

class Half:
    def __init__(self):
        signal.raise_signal(signal.SIGINT)
        self.handle = 1

    def __del__(self):
        self.handle

@ctypes.CFUNCTYPE(None)
def callback():
    signal.raise_signal(signal.SIGINT)

def program():
{body}

end_on_interrupt(program)
"""

#: An interrupt in the hook that reports what is lost.
IN_THE_HOOK = """
class Strikes:
    @classmethod
    def from_param(cls, lost):
        return signal.SIGINT

sys.__unraisablehook__ = ctypes.PyDLL(None)["raise"]
sys.__unraisablehook__.argtypes = [Strikes]

class Broken:
    def __del__(self):
        raise ValueError

Broken()
time.sleep(30)
"""

#: Further ones while the first is told.
WHILE_IT_ENDS = """
class Strikes:
    def write(self, text):
        signal.raise_signal(signal.SIGINT)
        sys.__stderr__.write(text)

    def flush(self):
        signal.raise_signal(signal.SIGINT)
        sys.__stderr__.flush()

sys.stdout = sys.stderr = Strikes()
signal.raise_signal(signal.SIGINT)
"""


def ends(body: str, handler: str = "default_int_handler") -> tuple[int, str]:
    """Return status and stderr of a program with this body, started with this handler."""
    indented = textwrap.indent(textwrap.dedent(body).strip(), "    ")
    program = SHAPE.format(body=indented, handler=handler)
    command = [sys.executable, "-c", program]
    # less than a program here sleeps: it is to be woken
    done = subprocess.run(command, capture_output=True, text=True, check=False, timeout=20)
    return done.returncode, done.stderr


@pytest.mark.parametrize(
    "body",
    [
        "signal.raise_signal(signal.SIGINT)",
        "Interrupted(); time.sleep(30)",
        "callback(); time.sleep(30)",
        "callback(); raise RuntimeError('no compiled object yet')",
        "callback(); sys.exit(2)",
        "try:\n    Half()\nexcept KeyboardInterrupt:\n    pass\nsys.exit(2)",
        "Interrupted(); Interrupted(); time.sleep(30)",
        "[Interrupted() for _ in range(100000)]; time.sleep(30)",
        IN_THE_HOOK,
        WHILE_IT_ENDS,
    ],
)
def test_an_interrupt_is_heeded_wherever_it_strikes(body: str) -> None:
    assert ends(body) == INTERRUPTED


def test_what_is_done_before_or_after_is_done() -> None:
    struck = "signal.raise_signal(signal.SIGINT)"
    undone = "try:\n    callback(); time.sleep(30)\nfinally:\n    sys.stderr.write('undone, ')"
    assert ends(undone) == (130, "undone, nonsmooth: interrupted\n")
    caught = f"try:\n    {struck}\nexcept KeyboardInterrupt:\n    sys.exit(0)"
    assert ends(caught) == (0, "")
    last = f"lambda: ({struck}, sys.stderr.write('done'))"
    assert ends(f"import atexit; atexit.register({last}); sys.exit(3)") == (3, "done")
    assert ends(f"{struck}; sys.exit(0)", "SIG_IGN") == (0, "")  # as in the background


@pytest.mark.skipif(not os.path.exists("/dev/full"), reason="a device of Linux")
def test_an_interrupt_that_cannot_be_reported_is_in_the_status() -> None:
    body = """
    sys.stdout = sys.stderr = open("/dev/full", "w")
    print("more than the disk takes")
    signal.raise_signal(signal.SIGINT)
    """
    assert ends(body) == (130, "")


def test_without_an_interrupt_nothing_is_hidden() -> None:
    body = """
    class Broken:
        def __del__(self):
            raise ValueError("shown")
    Broken()
    sys.exit(3)
    """
    status, err = ends(body)
    assert status == 3
    assert "ValueError: shown" in err


@pytest.mark.skipif(os.name != "posix", reason="signals are POSIX")
@pytest.mark.parametrize(
    "arguments",
    [
        ("equations", "-o", "equations.tex"),
        pytest.param(("digits", "-o", "digits.json"), marks=pytest.mark.long),
    ],
    ids=lambda arguments: arguments[0],
)
def test_an_interrupt_leaves_nothing_half_written(
    interruptible, arguments, tmp_path: Path
) -> None:
    *command, name = arguments
    process = interruptible(*command, tmp_path / name)
    time.sleep(1)
    process.send_signal(signal.SIGINT)
    out, err = process.communicate(timeout=30)
    assert process.returncode == 130
    assert err.endswith("nonsmooth: interrupted\n")
    assert out == ""
    assert list(tmp_path.iterdir()) == []
