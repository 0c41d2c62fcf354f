"""The commands of `minkref`: each is imported when it is called, none to list them all."""

from __future__ import annotations

from collections.abc import Iterator, MutableMapping
from importlib import import_module
from typing import Any

import typer
from minkref.cli.given_once import give_once
from typer.core import TyperCommand, TyperGroup

#: As in the help, headings and order: the module in `minkref.verbs` has the name of the command.
HEADINGS = {
    "Sums": {
        "sum": "The exact sum of sP and Q, in canonical form.",
        "view": "A page showing the sum, its events and its holes over a window of scales.",
        "events": "The scales at which something changes, exact and sorted.",
        "sweep": "The exact sums at many scales.",
        "index": "The sums at all scales of a window, found once and written to a file.",
        "scene": "The places at which a robot meets many placed, scaled copies of shapes.",
        "point": "Whether points are in a sum, exact; also by a program that is proved right.",
        "convolution": "The edges of P and Q at each other's vertices, with their parents.",
    },
    "Fits": {
        "erode": "The places at which Q lies within sP: erosion, inset, Minkowski difference.",
        "opening": "All copies of Q within sP together: the erosion plus Q.",
        "closing": "The sum of sP and Q, eroded by Q.",
        "nofit": "The places at which B meets A: the no-fit polygon, with exact fits.",
        "innerfit": "The places at which a part lies within a container.",
        "features": "Bays, corridors and holes by size: a merge tree, bars and bridges.",
        "decompose": "A shape in pieces, cut at its notches.",
    },
    "Motion": {
        "path": "The scales at which a part passes along a path.",
        "fit": "The scales at which a part fits into a container.",
        "trap": "The scales at which no translation takes a part out of obstacles.",
        "hold": "The scales at which a part fits and a given way out is blocked.",
    },
    "Judging": {
        "verify": "Test implementations against the exact reference.",
        "campaign": "Verification beyond one machine: run, resume, merge, ask, publish.",
        "adapter": "Write, check and install adapters: programs that connect an implementation to "
        "the tests.",
        "targets": "List what `minkref verify` can test here.",
        "shrink": "The smallest case that still shows a fault.",
        "certify": "A proof of a sum, an event or an interval without events.",
        "check": "Check whether proofs hold.",
    },
    "Inputs": {
        "repair": "An operand of a file with faults; lists every change with its exact size.",
        "union": "The exact union of sets; also the repair of polygons that overlap.",
        "intersection": "The exact intersection of sets.",
        "difference": "The first set without the others, exact.",
        "generate": "Degenerate cases, each with a proof.",
        "families": "List the families of generated cases.",
        "models": "List the models that other commands accept.",
    },
    "Reports": {
        "report": "Pages: an audit of the paper, its tables and figures beside ours, the corpus.",
        "bench": "The paper's tables: dynamic updates and the index against computing from "
        "scratch.",
    },
}
HEADING_OF = {name: heading for heading, lines in HEADINGS.items() for name in lines}
COMMANDS = {name: line for lines in HEADINGS.values() for name, line in lines.items()}


def load(name: str) -> Any:
    """The command of this name. Imports its module."""
    module = import_module(f"minkref.verbs.{name}")
    app = getattr(module, "app", None)
    if app is None:
        app = typer.Typer(add_completion=False, rich_markup_mode="rich")
        app.command(name, epilog=module.EXAMPLES)(module.command)
    command = typer.main.get_command(app)
    command.name = name
    give_once(command)
    return command


class _Commands(MutableMapping[str, Any]):
    """Maps names to commands; loads each when taken."""

    def __init__(self) -> None:
        self._loaded: dict[str, Any] = {}

    def __getitem__(self, name: str) -> Any:
        if name not in self._loaded:
            if name not in COMMANDS:
                raise KeyError(name)
            self._loaded[name] = load(name)
        return self._loaded[name]

    def __contains__(self, name: object) -> bool:
        return name in COMMANDS

    def __setitem__(self, name: str, command: Any) -> None:
        self._loaded[name] = command

    def __delitem__(self, name: str) -> None:
        del self._loaded[name]

    def __iter__(self) -> Iterator[str]:
        return iter(COMMANDS)

    def __len__(self) -> int:
        return len(COMMANDS)


class CommandGroup(TyperGroup):
    """For lists of commands, in the help and in a shell's completion, their lines are enough."""

    def __init__(self, **options: Any) -> None:
        super().__init__(**options)
        self.commands = _Commands()
        self._listing = False

    def list_commands(self, ctx: Any) -> list[str]:
        return list(COMMANDS)

    def get_command(self, ctx: Any, cmd_name: str) -> Any:
        if self._listing and cmd_name in COMMANDS:
            heading = HEADING_OF[cmd_name]
            return TyperCommand(cmd_name, help=COMMANDS[cmd_name], rich_help_panel=heading)
        return super().get_command(ctx, cmd_name)

    def format_help(self, ctx: Any, formatter: Any) -> None:
        self._listing = True
        try:
            super().format_help(ctx, formatter)
        finally:
            self._listing = False

    def shell_complete(self, ctx: Any, incomplete: str) -> Any:
        self._listing = True
        try:
            return super().shell_complete(ctx, incomplete)
        finally:
            self._listing = False
