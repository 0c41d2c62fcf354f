"""The command line that makes a report again: the options of a command that were given."""

from __future__ import annotations

import inspect
import shlex
from collections.abc import Callable, Mapping
from typing import Any, get_args, get_type_hints

from typer.models import OptionInfo


def command_line(name: str, command: Callable[..., Any], values: Mapping[str, Any]) -> str:
    """`minkref NAME ARGUMENT... --OPTION VALUE`, quoted for a shell. `values` may hold more than
    the parameters of the command; what equals its default is left out."""
    words: list[str] = []
    options: list[str] = []
    hints = get_type_hints(command, include_extras=True)
    for parameter in inspect.signature(command).parameters.values():
        value = values.get(parameter.name)
        if value == parameter.default or value is None:
            continue
        declared = _declared(hints[parameter.name])
        if not declared:
            words += [str(item) for item in value]
            continue
        yes, _, no = declared.partition("/")
        if isinstance(value, bool):
            options.append(yes if value else no)
            continue
        for item in value if isinstance(value, list | tuple) else [value]:
            options += [yes, str(item)]
    return shlex.join(["minkref", name, *words, *options])


def _declared(hint: Any) -> str:
    """`--name` or `--name/--no-name` of an option; empty for an argument."""
    for item in get_args(hint):
        if isinstance(item, OptionInfo):
            return str(item.default)
    return ""
