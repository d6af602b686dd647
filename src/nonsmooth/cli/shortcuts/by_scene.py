"""The paper's oscillator by the kernels of every scene, beside the paper's own methods.

``hb``, ``hb-c1`` and ``c1`` of the default scene are solved as the paper has them; any other
method of it, and with ``--no-shortcuts`` these as well, as those of any scene are.
"""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import click

from nonsmooth.solver.shortcuts.names import METHODS

from ..aliases import split_methods
from ..output import PICTURES, check_target
from ..problems import Problem
from ..scenes.default import DEFAULT
from ..scenes.named import scene_named
from ..scenes.options import PREFIX, case_from
from ..scenes.wanted import Wanted

#: Methods as they are named in every scene, and the paper's that are meant.
AS_IN_PAPER = {name: own for name, own in METHODS.items() if name != own}

#: The method that the default scene has beside the paper's, by its two names.
MORE = {"c1-tau": "c1-tau", "ck-tau": "c1-tau"}

FUNCTIONS = "Generic hb-c1: functions at each switch."
NO_SHORTCUTS = "By the generic kernels of every scene alone."


class MethodOfPaper(click.Choice[str]):
    """The paper's methods, one or more by commas, or another of the scene's."""

    def __init__(self, methods: tuple[str, ...]) -> None:
        super().__init__((*methods, "c1-tau"))

    def convert(
        self, value: Any, param: click.Parameter | None, ctx: click.Context | None
    ) -> str:
        """Return the methods, by the paper's names where they have them."""
        known = AS_IN_PAPER | MORE
        if not isinstance(value, str):
            return super().convert(value, param, ctx)
        names = [known.get(name, name) for name in split_methods(value)]
        return ",".join(super(MethodOfPaper, self).convert(q, param, ctx) for q in names)


def are_generic(
    methods: str | None, functions: int | None, no_shortcuts: bool, option: str
) -> bool:
    """Whether the kernels of every scene are meant by a list of methods.

    Raises
    ------
    Problem
        If some are, and others are the paper's.
    """
    names = split_methods(methods)
    if no_shortcuts or functions is not None:
        return True
    more = [name for name in names if name in MORE]
    if more and len(more) < len(names):
        raise Problem(
            f"{option}: got {methods!r}, the paper's methods beside {more[0]}; expected "
            "--no-shortcuts, by which all are solved by the kernels of every scene"
        )
    return bool(more)


def parse_methods(text: str) -> list[str]:
    """Return the paper's methods that `text` names, in its order, each once.

    Raises
    ------
    Problem
        If one of them is unknown.
    """
    names = list(dict.fromkeys(AS_IN_PAPER.get(name, name) for name in split_methods(text)))
    for name in names:
        if name not in METHODS.values():
            known = ", ".join(METHODS.values())
            raise Problem(f"--methods: got {name!r}, expected some of {known}")
    return names


def refuse_beside_generic(options: Mapping[str, object]) -> None:
    """Check that no option is given that only the paper's methods have.

    Raises
    ------
    Problem
        Naming the first.
    """
    for option, value in options.items():
        if value is not None:
            raise Problem(f"{option}: expected beside the paper's methods alone")


def solve_generic(case: Path | None, flags: Mapping[str, Any], wanted: Wanted) -> int:
    """Solve the default scene as any other; the exit status."""
    from ..scenes.solve import SUFFIXES, run  # noqa: PLC0415

    check_target(wanted.output, SUFFIXES)
    return run(_case(case, flags), wanted)


def sweep_generic(
    case: Path | None, flags: Mapping[str, Any], methods: str | None, orders: str | None,
    functions: int | None, json_: bool, output: Path | None,
) -> int:  # fmt: skip
    """Sweep over the default scene as over any other; the exit status."""
    check_target(output, (".json", ".csv", *PICTURES))
    from ..scenes.sweep import run  # noqa: PLC0415

    return run(_case(case, flags), methods, orders, functions, json_, output)


def digits_generic(quick: bool, json_: bool, output: Path | None) -> int:
    """Measure the digits of the default scene as of any other; the exit status."""
    from ..scenes.digits import run  # noqa: PLC0415

    return run(_case(None, {}), None, None, quick, json_, output)


def _case(case: Path | None, flags: Mapping[str, Any]) -> Any:
    given = {PREFIX + name: value for name, value in flags.items()}
    return case_from(scene_named(DEFAULT), case, given)
