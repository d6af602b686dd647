"""Case files: the parameters of an oscillator in a table of TOML."""

import tomllib
from collections.abc import Callable, Collection, Sequence
from pathlib import Path

from .problems import Problem


def tables_of(name: str) -> tuple[str, str]:
    """Return what the table of a scene or a structure may be called."""
    return name.replace("-", "_"), name


def said_first(
    arguments: list[str], known: Callable[[], Collection[str]]
) -> tuple[str | None, list[str]]:
    """Return what arguments name first, and the rest; else the one table of their case file.

    A table counts if it is known; what is wrong with a file is said later.
    """
    if arguments and not arguments[0].startswith("-"):
        return arguments[0], arguments[1:]
    path = ""
    for argument, value in zip(arguments, [*arguments[1:], ""], strict=False):
        if argument == "--case":
            path = value
        elif argument.startswith("--case="):
            path = argument.removeprefix("--case=")
    try:
        tables = [*read_toml(Path(path))] if path else []
    except Problem:
        return None, arguments
    names = [table.replace("_", "-") for table in tables]
    return (names[0] if len(names) == 1 and names[0] in known() else None), arguments


def read_case(path: Path, tables: Sequence[str]) -> dict[str, object]:
    """Return the one table of a case file, under one of its names.

    A `Problem` is raised if the file cannot be read, is not TOML, or has no such table.
    """
    content = read_toml(path)
    name = next((each for each in tables if each in content), tables[0])
    table = content.get(name)
    if not isinstance(table, dict):
        others = ", ".join(f"[{q}]" for q in content if isinstance(content[q], dict))
        but = f", but {others}" if others else ""
        raise Problem(f"--case: {path} has no table [{name}]{but}")
    unknown = sorted(content.keys() - {name})
    if unknown:
        raise Problem(f"--case: {path}: unknown {unknown[0]!r}, expected only [{name}]")
    return table


def read_toml(path: Path) -> dict[str, object]:
    """Return the content of a case file; a `Problem` if it cannot be read, or is not TOML."""
    try:
        text = path.read_bytes().decode("utf-8-sig")  # editors on Windows write a mark first
        return tomllib.loads(text)
    except OSError as error:
        raise Problem(f"--case: cannot read {path}: {error.strerror}") from error
    except UnicodeDecodeError as error:
        raise Problem(f"--case: {path} is not a text file; expected TOML") from error
    except (ValueError, RecursionError) as error:
        raise Problem(f"--case: {path} is not TOML: {error}") from error
