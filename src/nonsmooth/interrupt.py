"""Ctrl-C ends the program with one line and status 130, wherever it strikes.

Python raises `KeyboardInterrupt` at whatever it is about.  In a destructor or in a callback
from C, both of which a compiler has many, that is printed and forgotten, and the program goes
on or fails later by what was left undone.
"""

import _thread
import contextlib
import os
import signal
import sys
import threading
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
    heard = threading.Event()

    def interrupt(_signal: int, _frame: types.FrameType | None) -> None:
        heard.set()
        raise KeyboardInterrupt

    def unraisable(lost: "sys.UnraisableHookArgs") -> None:
        if lost.exc_type is KeyboardInterrupt:
            threading.Timer(_AGAIN, _interrupt_main_thread).start()
        elif not heard.is_set():
            sys.__unraisablehook__(lost)

    if signal.getsignal(signal.SIGINT) is signal.default_int_handler:
        signal.signal(signal.SIGINT, interrupt)
    sys.unraisablehook = unraisable
    try:
        program()
    except BaseException as error:
        if not heard.is_set():
            raise
        _leave(error.code if isinstance(error, SystemExit) else None)


def _interrupt_main_thread() -> None:
    """Send SIGINT to the main thread, which wakes it where it waits for the system."""
    if hasattr(signal, "pthread_kill"):
        signal.pthread_kill(threading.main_thread().ident or 0, signal.SIGINT)
    else:
        _thread.interrupt_main()


def _leave(status: object) -> NoReturn:
    with contextlib.suppress(OSError):
        sys.stdout.flush()
        if status not in (0, INTERRUPTED):
            print("nonsmooth: interrupted", file=sys.stderr)
        sys.stderr.flush()
    os._exit(0 if status == 0 else INTERRUPTED)
