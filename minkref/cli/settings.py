"""A library's own settings of a command, in minkref.toml or the table [tool.minkref] of
pyproject.toml. The keys are the options of the command."""

from __future__ import annotations

import functools
import json
import os
import tomllib
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import typer
from minkref.cli.command_options import CommandOption, options_of
from minkref.errors import Refusal, cut, nearest
from minkref.file_text import text_of_file

OWN, SHARED = "minkref.toml", "pyproject.toml"
LONGEST = 1 << 20  # bytes
KINDS: dict[type, tuple[str, tuple[type, ...]]] = {  # what TOML has for each
    bool: ("true or false", (bool,)),
    int: ("an integer", (int,)),
    float: ("a number", (int, float)),
    str: ("a text", (str,)),
    Path: ("a text", (str,)),
}
_META = "minkref.cli.settings"


@dataclass(frozen=True)
class Settings:
    """`values` by the names of the command's parameters; paths in them lead from the current
    folder."""

    path: Path
    values: dict[str, Any]
    keys: dict[str, str]  # parameter: its key


def begin_settings(context: typer.Context, given: Path | None) -> Path | None:
    """The callback of an eager option `--settings FILE`: what the file says becomes the default of
    the other options. Without FILE one is looked for in the current folder and those above, but not
    where `no_settings` or `case` is given. Returns the file that was read."""
    params = context.params
    if given is not None:
        table = _table(given)
        if table is None:
            raise Refusal("there is no table [tool.minkref]", str(given), "add it", "settings")
        found: tuple[Path, dict[str, Any]] | None = (given, table)
    elif params.get("no_settings") or params.get("case"):
        found = None
    else:
        found = next(_tables(), None)
    if found is None:
        return None
    settings = _read(*found, _function(context))
    context.default_map = settings.values
    context.meta[_META] = settings
    return settings.path


def _function(context: typer.Context) -> Callable[..., Any]:
    command = context.command.callback
    assert command is not None
    return command


def naming_settings(command: Callable[..., None]) -> Callable[..., None]:
    """The command, which has a parameter `context`; what it refuses of an option that the settings
    gave names their file and key."""

    @functools.wraps(command)
    def run(**values: Any) -> None:
        try:
            command(**values)
        except Refusal as refusal:
            context: typer.Context = values["context"]
            raise _named(refusal, context, context.meta.get(_META)) from refusal

    return run


def is_outdone(context: typer.Context, name: str, by: str) -> bool:
    """Whether the settings give `name`, and the command line an option that excludes it."""
    sources = [context.get_parameter_source(parameter) for parameter in (name, by)]
    return [source and source.name for source in sources] == ["DEFAULT_MAP", "COMMANDLINE"]


def _named(refusal: Refusal, context: typer.Context, settings: Settings | None) -> Refusal:
    for name, key in settings.keys.items() if settings else ():
        source = context.get_parameter_source(name)
        option, _, rest = refusal.where.partition(" ")
        if option == f"--{key}" and source is not None and source.name == "DEFAULT_MAP":
            where = f"{settings.path if settings else ''}, {key} {rest}".rstrip()
            return Refusal(refusal.what, where, refusal.mend, refusal.code)
    return refusal


def _tables() -> Iterator[tuple[Path, dict[str, Any]]]:
    """The files with settings, from the current folder upwards; in a folder minkref.toml first."""
    try:
        here = Path.cwd()
    except OSError:  # the folder is gone
        return
    for folder in (here, *here.parents):
        for name in (OWN, SHARED):
            path = folder / name
            if os.path.isfile(path):  # not where a folder above may not be looked into
                shown = Path(os.path.relpath(path))
                table = _table(shown)
                if table is not None:
                    yield shown, table


def _table(path: Path) -> dict[str, Any] | None:
    """The settings in a file; None where a pyproject.toml has none."""
    mend = "mend the file, or leave it out with --no-settings"
    text = text_of_file(path, str(path), mend, LONGEST)
    try:
        document = tomllib.loads(text)
    except (ValueError, RecursionError) as error:
        what = f"this is no TOML: {cut(str(error))}"
        raise Refusal(what, str(path), mend, "settings") from error
    if path.name != SHARED:
        return document
    tool = document.get("tool", {})
    table = tool.get("minkref") if isinstance(tool, dict) else None
    if table is not None and not isinstance(table, dict):
        raise Refusal("this is not a table", f"{path}, tool.minkref", "write [tool.minkref]")
    return table


def _read(path: Path, table: dict[str, Any], command: Callable[..., Any]) -> Settings:
    """Checks every key and the kind of its value."""
    known = {option.key: option for option in options_of(command) if not option.eager}
    values: dict[str, Any] = {}
    keys: dict[str, str] = {}
    for key, value in table.items():
        where = f"{path}, {key[:40]}"
        if key not in known:
            mend = f"{nearest(key, known)}the settings are {', '.join(sorted(known))}"
            raise Refusal("there is no such setting", where, mend, "settings")
        option = known[key]
        values[option.parameter] = _value(option, value, path.parent, where)
        keys[option.parameter] = key
    return Settings(path, values, keys)


def _value(option: CommandOption, value: Any, folder: Path, where: str) -> Any:
    if not option.several:
        return _single(option, value, folder, where)
    values = value if isinstance(value, list) else [value]
    return [_single(option, item, folder, where) for item in values]


def _single(option: CommandOption, value: Any, folder: Path, where: str) -> Any:
    wanted, types = KINDS[option.kind]
    if type(value) not in types or value != value:
        given = json.dumps(value, default=str)[:80]
        raise Refusal(f"{given} is not {wanted}", where, f"give {wanted}", "settings")
    if option.kind is Path:
        return str(folder / str(value))
    return target_from(folder, str(value)) if option.parameter == "targets" else value


def target_from(folder: Path, name: str) -> str:
    """A target that is named by a relative path, from the current folder."""
    kind, rest = ("so:", name[3:]) if name.startswith("so:") else ("", name)
    if "/" not in rest or name.startswith(("cmd:", "py:")):
        return name
    here = str(folder / rest)
    return kind + (here if here.startswith(("/", "..")) else f"./{here}")
