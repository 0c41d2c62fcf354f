"""Checks the pages' minkref commands against the actual command line. Runs nothing."""

from __future__ import annotations

import re
import shlex
from collections.abc import Iterator
from functools import cache
from typing import Any

import typer
from minkref.cli.cli import app
from minkref.reports.documentation.blocks import Block

OPTION = re.compile(r"(?<![\w/.-])(--[a-z][a-z-]*|-[a-zA-Z])(?![\w-])")


def commands(block: Block) -> Iterator[str]:
    """The lines that call minkref; lines continued with a backslash count as one."""
    text = block.text.replace("\\\n", " ")
    for line in text.splitlines():
        line = line.removeprefix("$ ")
        if re.match(r"(\.venv/bin/)?minkref ", line):
            yield line


def unknown_words(block: Block) -> Iterator[str]:
    """Commands and options that do not exist."""
    if block.kind == "text" or block.kind not in ("console", "shell"):
        return
    for line in commands(block):
        words = _words(line)[1:]
        command, rest = _command(words)
        if command is None:
            yield f"{block.place}: there is no command {words[0]}"
            continue
        known = {option for parameter in command.params for option in _options(parameter)}
        for option in OPTION.findall(" ".join(rest)):
            if option not in known | {"--help", "--debug"}:
                yield f"{block.place}: minkref {words[0]} has no option {option}"


def _words(line: str) -> list[str]:
    try:
        return shlex.split(line, comments=True)
    except ValueError:  # an apostrophe of prose behind the command
        return line.split()


def _options(parameter: Any) -> list[str]:
    return [*parameter.opts, *parameter.secondary_opts]


@cache
def _root() -> Any:
    return typer.main.get_command(app)


def _command(words: list[str]) -> tuple[Any, list[str]]:
    command = _root()
    while words and hasattr(command, "get_command") and not words[0].startswith("-"):
        context = typer.Context(command, info_name="minkref")
        command = command.get_command(context, words[0])
        if command is None:
            return None, words
        words = words[1:]
    return command, words
