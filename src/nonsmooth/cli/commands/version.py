"""``nonsmooth --version``: versions and the machine."""

import os
import platform

import click
from click.core import Context, Parameter

from ..named import DEFAULT


def show_version(context: Context, _: Parameter, wanted: bool) -> None:
    """Print the version, the mathematics, the machine and the libraries, and leave."""
    if not wanted or context.resilient_parsing:
        return
    from importlib.metadata import version

    from nonsmooth.solver.kernels import registry

    scene = registry.load(DEFAULT)
    mathematics = registry.mathematics(scene, registry.methods(scene))
    click.echo(f"nonsmooth {version('nonsmooth')}, mathematics of {DEFAULT} {mathematics}")
    click.echo(
        f"Python {platform.python_version()}, {platform.system()} {platform.machine()}, "
        f"{os.cpu_count()} cores"
    )
    for name in _libraries():
        click.echo(f"  {name} {_version(name)}")
    context.exit()


def _libraries() -> list[str]:
    """Return the libraries that compute, draw or write: all but those of the developers."""
    from importlib.metadata import requires

    requirements = [line.partition(";") for line in requires("nonsmooth") or []]
    names = [
        line.partition(">=")[0].strip()
        for line, _, marker in requirements
        if not marker or any(extra in marker for extra in ("plot", "precise", "netcdf"))
    ]
    return sorted(names, key=str.lower)


def _version(name: str) -> str:
    from importlib.metadata import PackageNotFoundError, version

    try:
        return version(name)
    except PackageNotFoundError:
        return "(not installed)"
