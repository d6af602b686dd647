"""Flags: what a mistyped one may have been meant for, and names that no parameter can have."""

import click
import pytest
from one_mass import NAMES

import nonsmooth as ns
from nonsmooth.cli import cli
from nonsmooth.cli.about import PREFIX, CommandAbout
from nonsmooth.codegen.scene.checks.names import TAKEN
from nonsmooth.nearest import nearest

#: Commands of bodies, too.
OF_BODIES = ("solve", "sweep", "tradeoff")

#: Every command of every scene; of the default scene by themselves.
COMMANDS = {
    f"{name} {scene}".strip(): cli.resolve_command(
        click.Context(cli), [name, scene] if scene else [name]
    )[1]
    for name in ("solve", "sweep", "simulate", "digits", "tradeoff", "report")
    for scene in ("", *(ns.scenes() if name in OF_BODIES else NAMES))
}


def flags_of(command: click.Command | None) -> list[str]:
    """Return the long flags of a command."""
    assert command is not None
    return [name for q in command.params for name in q.opts if name.startswith("--")]


@pytest.mark.parametrize("what", COMMANDS)
def test_what_a_flag_begins_with_is_what_it_was_meant_for(what: str) -> None:
    flags = flags_of(COMMANDS[what])
    assert flags
    for flag in flags:
        for end in range(len("--f"), len(flag)):
            meant = nearest(flag[:end], flags)
            assert flag in meant or flag[:end] in flags, flag[:end]
            assert all(q.startswith(flag[:end]) for q in meant)


def test_no_parameter_has_the_name_of_an_option() -> None:
    for what, command in COMMANDS.items():
        if " " not in what or what.endswith("stick-slip"):  # its parameters are among them
            continue
        assert isinstance(command, CommandAbout)
        given = {PREFIX + q.name for q in command.about.parameters}
        own = [q for q in command.params if q.name not in given]
        names = {name.strip("-") for q in own for name in q.opts if name.startswith("--")}
        named_so = {name.replace("-", "_") for name in names}
        assert named_so <= TAKEN, what
