"""The options of a command, read off the function that it is."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from types import UnionType
from typing import Any, Union, get_args, get_origin, get_type_hints

from typer.models import ArgumentInfo, OptionInfo


@dataclass(frozen=True)
class CommandOption:
    """`yes` and `no`: what sets it, `--name` and perhaps `--no-name`; empty for an argument.
    `kind`: the type of a value, of which there may be `several`. One that is `eager` prints and
    ends, or says what is to be read."""

    parameter: str
    yes: str
    no: str
    kind: type
    several: bool
    eager: bool
    default: Any

    @property
    def key(self) -> str:
        """Its name without dashes."""
        return self.yes.removeprefix("--") or self.parameter


def options_of(command: Callable[..., Any]) -> Iterator[CommandOption]:
    """All arguments and options, in the order of the parameters."""
    hints = get_type_hints(command, include_extras=True)
    for parameter in inspect.signature(command).parameters.values():
        hint, *metadata = get_args(hints[parameter.name]) or (None,)
        info = next((m for m in metadata if isinstance(m, OptionInfo | ArgumentInfo)), None)
        if info is None:
            continue
        words = str(info.default) if isinstance(info, OptionInfo) else ""
        yes, _, no = words.partition("/")
        kind, several = _kind(hint)
        yield CommandOption(
            parameter.name, yes, no, kind, several, bool(info.is_eager), parameter.default
        )


def _kind(hint: Any) -> tuple[type, bool]:
    """The type of one value, and whether there is a list of them; `X | None` is X."""
    if get_origin(hint) in (Union, UnionType):
        (hint,) = (arm for arm in get_args(hint) if arm is not type(None))
    if get_origin(hint) is list:
        return get_args(hint)[0], True
    return hint, False
