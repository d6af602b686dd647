"""numba's cache of one function, guarded so that only code that was written there is run.

numba itself notices neither files that were cut or changed nor files that were interchanged.
So each entry has a hash of its content, function and types, and one that does not match is
compiled anew.  A forged file with a matching hash is not noticed; against this, the folder must
be writable only for those who may change the source.
"""

import glob
import hashlib
import os
import pickle
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any

from ..scenes.sealed import OTHERS, check_private


@contextmanager
def owned() -> Iterator[None]:
    """Make files created in a ``with`` block writable for their owner only."""
    before = os.umask(OTHERS)
    os.umask(before | OTHERS)
    try:
        yield
    finally:
        os.umask(before)


def check_cache(cached: Any, source: Path) -> None:
    """Check that only users who may change the source can have written to a cache of numba.

    Raises
    ------
    NotPrivate
        Naming the folder or file that others may write to.
    """
    folder, names = Path(cached.cache_path), glob.escape(cached._impl.filename_base)
    check_private(folder, source)
    for path in folder.glob(f"{names}.*"):
        with suppress(FileNotFoundError):  # another process has replaced it
            check_private(path, source)


def guard(cached: Any, name: str, say: Callable[[str, str], None]) -> None:
    """Seal the entries of a cache of numba, and disable it if it cannot be read or written.

    numba has no hook for this, and its errors do not name the folder.  So two methods of this
    cache object, and two of its (de)serialiser, are replaced.

    Parameters
    ----------
    name : str
        Name of the function, part of the hash.
    say : callable
        Called with folder and cause if the cache cannot be read or written.
    """
    types = [""]
    _seal(cached._impl, lambda content: _hash(name, types[0], content))

    def guarded(action: Callable[..., Any]) -> Callable[..., Any]:
        def or_none(signature: Any, *rest: Any) -> Any:
            types[0] = str(signature)
            try:
                with owned():
                    return _or_flushed(cached, action, signature, *rest)
            except OSError as error:
                cached.disable()
                say(cached.cache_path, error.strerror or str(error))
                return None  # neither loaded nor saved

        return or_none

    cached.load_overload = guarded(cached.load_overload)
    cached.save_overload = guarded(cached.save_overload)


def _or_flushed(cached: Any, action: Callable[..., Any], *arguments: Any) -> Any:
    """Return the result of an action of a cache; if its content is damaged, empty it: None."""
    try:
        return action(*arguments)
    except OSError:
        raise
    except Exception:  # pickle raises any, of bytes that are not its own
        cached.flush()
        return None


def _seal(impl: Any, hash_of: Callable[[bytes], str]) -> None:
    """Make a (de)serialiser of compiled code write a hash with it, and check it on reading."""
    from numba.core.serialize import dumps  # noqa: PLC0415  (numba takes 750 ms)

    reduce, rebuild = impl.reduce, impl.rebuild
    as_bytes: Callable[[Any], bytes] = dumps

    def sealed(result: Any) -> tuple[str, bytes]:
        content = as_bytes(reduce(result))
        return hash_of(content), content

    def checked(context: Any, entry: tuple[str, bytes]) -> Any:
        digest, content = entry
        if digest != hash_of(content):
            raise ValueError("not what was kept")
        return rebuild(context, pickle.loads(content))

    impl.reduce, impl.rebuild = sealed, checked


def _hash(name: str, types: str, content: bytes) -> str:
    """Return the hash of a function's name, its argument types and its compiled code."""
    return hashlib.sha256(f"{name}\0{types}\0".encode() + content).hexdigest()
