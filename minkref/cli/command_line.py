"""The command line that makes a report again: the options of a command that were given."""

from __future__ import annotations

import shlex
from collections.abc import Callable, Mapping
from typing import Any

from minkref.cli.command_options import options_of


def command_line(name: str, command: Callable[..., Any], values: Mapping[str, Any]) -> str:
    """`minkref NAME ARGUMENT... --OPTION VALUE`, quoted for a shell. `values` may hold more than
    the parameters of the command; what equals its default is left out."""
    words: list[str] = []
    options: list[str] = []
    for option in options_of(command):
        value = values.get(option.parameter)
        if value == option.default or value is None:
            continue
        if not option.yes:
            words += [str(item) for item in value]
            continue
        if isinstance(value, bool):
            options.append(option.yes if value else option.no)
            continue
        for item in value if isinstance(value, list | tuple) else [value]:
            options += [option.yes, str(item)]
    return shlex.join(["minkref", name, *words, *options])
