"""Ctrl-C ends the program with one line and status 130, wherever it strikes.

Python raises `KeyboardInterrupt` at whatever it is about.  In a destructor or in a callback
from C, both of which a compiler has many, that is printed and forgotten, and the program goes
on or fails later by what was left undone.
"""

import contextlib
import os
import signal
import sys
import types
from collections.abc import Callable
from typing import NoReturn

#: The exit status of what SIGINT ended, as shells count.
INTERRUPTED = 130

#: Seconds until a Ctrl-C that was forgotten is raised again.
_AGAIN = 0.01


def end_on_interrupt(program: Callable[[], NoReturn]) -> NoReturn:
    """Run the program to its `SystemExit`; after Ctrl-C every failure is an interruption.

    Then the process ends at once, after all ``finally``, but without the destructors of
    what was half made.
    """
    heard = ended = False

    def interrupt(_signal: int, frame: types.FrameType | None) -> None:
        nonlocal heard
        if ended:
            return
        heard = True
        if frame is not None and frame.f_code is unraisable.__code__:  # there it would be lost
            signal.setitimer(signal.ITIMER_REAL, _AGAIN)
        else:
            raise KeyboardInterrupt

    def unraisable(lost: "sys.UnraisableHookArgs") -> None:
        if lost.exc_type is KeyboardInterrupt:
            signal.setitimer(signal.ITIMER_REAL, _AGAIN)
        elif not heard:
            sys.__unraisablehook__(lost)

    try:
        if signal.getsignal(signal.SIGINT) is signal.default_int_handler:
            signal.signal(signal.SIGINT, interrupt)
            if hasattr(signal, "setitimer"):  # not so on Windows, where Python's ways remain
                signal.signal(signal.SIGALRM, interrupt)
                sys.unraisablehook = unraisable
        program()
    except BaseException as error:
        ended = True  # first: until a call is made, no signal is handled
        if not heard:
            raise
        _leave(error.code if isinstance(error, SystemExit) else None)


def _leave(status: object) -> NoReturn:
    with contextlib.suppress(OSError):
        sys.stdout.flush()
        if status not in (0, INTERRUPTED):
            print("nonsmooth: interrupted", file=sys.stderr)
        sys.stderr.flush()
    os._exit(0 if status == 0 else INTERRUPTED)
