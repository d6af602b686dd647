"""``nonsmooth stability``: the old name of ``nonsmooth digits``, which says so."""

from typing import TYPE_CHECKING, Any

import click

from . import digits

if TYPE_CHECKING:
    from nonsmooth.solver.scenes.loaded import LoadedScene

WORDS = "it is now `nonsmooth digits`; whether an orbit is stable is said by `solve`"


def command(scene: "LoadedScene", said: str) -> click.Command:
    """Return ``nonsmooth digits`` of a scene, with a word on its name."""
    found = digits.command(scene, said)
    measure: Any = found.callback

    def callback(**options: Any) -> int:
        click.echo(f"nonsmooth: stability: {WORDS}", err=True)
        status: int = measure(**options)
        return status

    found.callback = callback
    return found
