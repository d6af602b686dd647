"""numba's cache of one function, so guarded that nothing in it is run but what was kept there.

numba itself looks neither for files that were cut or changed nor for files in each other's
place.  So what is kept has a hash of itself, of its function and of its types, and what is not
so is compiled anew.  A file that is forged, with its hash, cannot be told: against that stands
that only who may change the source may write to the folder.
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
    """Let no one else write to the files that are made within."""
    before = os.umask(OTHERS)
    os.umask(before | OTHERS)
    try:
        yield
    finally:
        os.umask(before)


def check_cache(cached: Any, source: Path) -> None:
    """Check that no one can have written to a cache of numba who cannot change the source.

    Raises
    ------
    NotPrivate
        Naming the folder, or a file in it.
    """
    folder, names = Path(cached.cache_path), glob.escape(cached._impl.filename_base)
    check_private(folder, source)
    for path in folder.glob(f"{names}.*"):
        with suppress(FileNotFoundError):  # another process has replaced it
            check_private(path, source)


def guard(cached: Any, name: str, say: Callable[[str, str], None]) -> None:
    """Use a cache of numba only as it was kept, and let compiling go on where it cannot be.

    numba has no place for that, and raises what the system says, with no folder in it: so two
    methods of this one cache, and two of what it writes with, are replaced.

    Parameters
    ----------
    name : str
        Of its function: it is part of the hash.
    say : callable
        Takes the folder and the cause if it can be neither read nor written.
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
                return None  # not cached, or not kept

        return or_none

    cached.load_overload = guarded(cached.load_overload)
    cached.save_overload = guarded(cached.save_overload)


def _or_flushed(cached: Any, action: Callable[..., Any], *arguments: Any) -> Any:
    """Return what an action of a cache does; None, and the cache is empty, if it is damaged."""
    try:
        return action(*arguments)
    except OSError:
        raise
    except Exception:  # pickle raises any, of bytes that are not its own
        cached.flush()
        return None


def _seal(impl: Any, hash_of: Callable[[bytes], str]) -> None:
    """Let what writes and reads compiled code put a hash beside it, and look at that first."""
    from numba.core.serialize import dumps  # noqa: PLC0415  (numba takes 750 ms)

    reduce, rebuild = impl.reduce, impl.rebuild
    as_bytes: Callable[[Any], bytes] = dumps

    def sealed(result: Any) -> tuple[str, bytes]:
        content = as_bytes(reduce(result))
        return hash_of(content), content

    def checked(context: Any, kept: tuple[str, bytes]) -> Any:
        found, content = kept
        if found != hash_of(content):
            raise ValueError("not what was kept")
        return rebuild(context, pickle.loads(content))

    impl.reduce, impl.rebuild = sealed, checked


def _hash(name: str, types: str, content: bytes) -> str:
    return hashlib.sha256(f"{name}\0{types}\0".encode() + content).hexdigest()
