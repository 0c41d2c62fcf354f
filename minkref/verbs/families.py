"""`minkref families`: the generators of cases."""

from __future__ import annotations

from typing import Any

from minkref.cli.options import Json, Schema
from minkref.cli.output import give, plain_table
from minkref.degeneracies.catalogue import GROUPS
from minkref.fuzz.settings import QUESTIONS, SETTINGS
from minkref.output.documents import Stopwatch, document
from minkref.output.terminal import console

EXAMPLES = """Examples:

minkref families

minkref verify cgal-reduced --family comb --case comb:1:42

minkref generate fits-hole --count 5 -o cases"""


def command(json: Json = False, schema: Schema = False) -> None:
    """The families of generated cases: those that `minkref verify` draws from (a case is named
    FAMILY:SEED:INDEX), and those that `minkref generate` makes, degenerate or invalid."""
    watch = Stopwatch()
    rows = [
        {"name": name, "dimension": setting.dimension, "title": title, "command": "verify"}
        for setting in SETTINGS
        for name, title in setting.families.items()
    ]
    rows += [
        {"name": name, "dimension": 2, "title": title, "command": "verify"}
        for question in QUESTIONS
        for name, title in question.families.items()
    ]
    rows += [
        {"name": name, "dimension": group.dimension, "title": family.title, "command": "generate"}
        for group in sorted(GROUPS, key=lambda group: group.dimension)
        for name, family in group.families.items()
    ]
    value = document("families", watch, families=rows)
    give(value, json, _print)


def _print(value: dict[str, Any]) -> None:
    table = plain_table("family", "dimension", "command", "what it makes")
    for row in value["families"]:
        table.add_row(row["name"], str(row["dimension"]), row["command"], row["title"])
    console().print(table)
