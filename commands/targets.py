"""`minkref targets`: what `verify` can test."""

from __future__ import annotations

import sys
from typing import Any

from minkref.commands.line.options import Json, Schema
from minkref.documents import Stopwatch, as_text, document
from minkref.fuzz.targets.catalogue import TargetEntry, list_targets
from minkref.terminal import console, escaped
from rich.table import Table

EXAMPLES = """Examples:

minkref targets

minkref targets --json"""


def command(json: Json = False, schema: Schema = False) -> None:
    """The implementations that `minkref verify` can test here, and how to get those that are
    missing."""
    watch = Stopwatch()
    value = document("targets", watch, targets=[_row(target) for target in list_targets()])
    if json:
        sys.stdout.write(as_text(value))
    else:
        _print(value)


def _row(target: TargetEntry) -> dict[str, Any]:
    return {name: value for name, value in vars(target).items() if name != "declaration"}


def _print(value: dict[str, Any]) -> None:
    table = Table(box=None, pad_edge=False)
    for heading in ("target", "version", "what it is", "state"):
        table.add_column(heading)
    absent: dict[str, list[str]] = {}
    for row in value["targets"]:
        table.add_row(
            row["name"],
            escaped(row["version"] or ""),
            row["about"],
            "ready" if row["available"] else "absent",
        )
        if not row["available"]:
            absent.setdefault(row["reason"], []).append(row["name"])
    out = console()
    out.print(table)
    for reason, names in absent.items():
        out.print(escaped(f"{', '.join(names)}: {reason}"), soft_wrap=True)
