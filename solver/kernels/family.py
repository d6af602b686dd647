"""Families of methods whose generated modules are linked alike, as plain Python or compiled."""

import hashlib
import sys
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache, partial
from types import ModuleType
from typing import Any

from ..iteration.iteration import iterate_scene
from ..scenes.methods import module_of
from . import compiling, linking
from .account import COMPILE, PLAIN_PHASES, Account
from .compiling import Entries, rebuilt
from .kernel import Kernel, for_others
from .linking import Make, text_of


@dataclass(frozen=True)
class Family:
    """Methods whose generated modules are linked in one way.

    Parameters
    ----------
    link : callable
        ``link(module, make)`` returns the functions of a generated module and their solver.
    modules : tuple of module
        Modules that are compiled with it.
    entry : function, optional
        The function whose compiled form stands for a whole kernel in numba's cache; without
        one, each function that is called has its own account.
    seconds : float
        Time that compiling takes.
    long_calls : bool
        Whether a call in plain Python may take seconds: what numba's cache has is used at once.
    """

    link: Callable[[ModuleType, Make], dict[str, Any]]
    modules: tuple[ModuleType, ...]
    entry: Any = None
    seconds: float = COMPILE
    long_calls: bool = False

    def account(self, method: str) -> Account:
        """Return the account of the generated module of a method."""
        return self.account_of(module_of(method).__name__)

    @cache  # noqa: B019  (there are as many families as methods of linking)
    def kernel(self, layout: Any, compile_it: bool) -> Kernel:
        """Return the kernel of a method for a scene, from the layout of its unknowns.

        Its functions are linked once for all scenes.
        """
        module = module_of(layout.method).__name__
        functions = (self.compiled if compile_it else self.plain)(module)
        return Kernel(
            method=layout.name,
            durations=len(layout.classes),
            forced=layout.scene.frequency is not None,
            lowest=layout.lowest,
            size=layout.size,
            coefficients=layout.coefficients,
            given=layout.given,
            condensed=layout.condensed,
            account=None if compile_it else self.account_of(module),
            starts=layout.starts,
            motion=self.plain(module)["motion"],  # of NumPy
            **{name: functions[name] for name in ("residual", "jacobian", "iterate")},
        )

    @cache  # noqa: B019
    def account_of(self, name: str, function: str | None = None) -> Account:
        """Return the account, one a process, of the module of a name or of a function of it."""
        entry = self.entry if function is None else self.plain(name)[function]
        entry_name = f"{entry.__name__}_{self.fingerprint(name)}"
        return Account(entry.__code__.co_filename, entry_name, self.seconds)

    def fingerprint(self, name: str) -> str:
        """Return a hash of the text of all modules that are compiled with that of a name."""
        text = text_of(sys.modules[name], *self.modules, compiling)
        return hashlib.sha256(name.encode() + text).hexdigest()[:16]

    def quicker(self, name: str, phases: int = 0) -> dict[str, Any]:
        """Return the functions of the module of a name, compiled if that pays by now.

        For many phases they are compiled if numba's cache has them.
        """
        account = self.account_of(name)
        pays = account.pays() or (phases > PLAIN_PHASES and account.is_cached())
        return (self.compiled if pays else self.plain)(name)

    def call(self, module: str, function: str, *arguments: Any) -> Any:
        """Call a function of a module, compiled if that pays by now; count the time if not.

        Each function has its own account: one that is called now and then is not compiled.

        Raises
        ------
        KeyboardInterrupt
            Of Ctrl-C while numba reads arguments or makes the result, too: Python says then
            that the function returned a result with an exception set.
        """
        account = self.account_of(module, function)
        if account.pays() or (self.long_calls and account.is_cached()):
            account.is_compiled = True
            try:
                return self.compiled(module)[function](*arguments)
            except SystemError as error:
                raise error.__cause__ or error from None
        with account.spending():
            return self.plain(module)[function](*arguments)

    @cache  # noqa: B019
    def plain(self, name: str) -> dict[str, Any]:
        """Return the functions of the module of a name, as plain Python."""
        return self.link(sys.modules[name], rebuilt)

    @cache  # noqa: B019
    def inner(self, name: str) -> dict[str, Any]:
        """Return them compiled by numba, for calls from compiled functions."""
        return self.link(sys.modules[name], for_others(self.fingerprint(name)))

    @cache  # noqa: B019
    def compiled(self, name: str) -> dict[str, Any]:
        """Return them compiled by numba, for calls from Python, cached if possible."""
        if self.entry is not None:
            self.account_of(name).is_compiled = True
        return Entries(self.inner(name))


def solved_by_newton(*modules: ModuleType) -> Family:
    """Return the family of modules of equations that are linked with these alone."""
    link = partial(linking.solved_by_newton, modules)
    return Family(link, modules + linking.NEWTON, iterate_scene)
