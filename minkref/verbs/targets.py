"""`minkref targets`: what `verify` can test."""

from __future__ import annotations

from typing import Any

from minkref.cli.options import Json, Schema
from minkref.cli.output import give, plain_table
from minkref.fuzz.all_targets import ALL_TARGETS
from minkref.fuzz.run.catalogue import TargetEntry
from minkref.output.documents import Stopwatch, document
from minkref.output.terminal import console, escaped

EXAMPLES = """Examples:

minkref targets

minkref targets --json"""


def command(json: Json = False, schema: Schema = False) -> None:
    """The implementations that `minkref verify` can test here, and how to get those that are
    missing."""
    watch = Stopwatch()
    value = document("targets", watch, targets=[_row(target) for target in ALL_TARGETS.entries()])
    give(value, json, _print)


def _row(target: TargetEntry) -> dict[str, Any]:
    return {name: value for name, value in vars(target).items() if name != "declaration"}


def _print(value: dict[str, Any]) -> None:
    table = plain_table("target", "version", "what it is", "state")
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
