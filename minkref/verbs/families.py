"""`minkref families`: the generators of cases."""

from __future__ import annotations

from typing import Any

from minkref.cli.options import Json, Schema
from minkref.cli.output import give, plain_table
from minkref.degeneracies.catalogue import DISC_FAMILIES, PATH_FAMILIES, SOLID_FAMILIES
from minkref.degeneracies.catalogue import FAMILIES as DEGENERATE
from minkref.degeneracies.catalogue import SPACE_FAMILIES as DEGENERATE_IN_SPACE
from minkref.degeneracies.invalid.catalogue import INVALID_FAMILIES, INVALID_MESH_FAMILIES
from minkref.fuzz.plane.families.catalogue import FAMILIES
from minkref.fuzz.space.families import SPACE_FAMILIES
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
        {"name": name, "dimension": 2, "title": family.title, "command": "verify"}
        for name, family in FAMILIES.items()
    ]
    rows += [
        {"name": name, "dimension": 3, "title": title, "command": "verify"}
        for name, title in SPACE_FAMILIES.items()
    ]
    for dimension, groups in (
        (2, (DEGENERATE, DISC_FAMILIES, PATH_FAMILIES, INVALID_FAMILIES)),
        (3, (DEGENERATE_IN_SPACE, SOLID_FAMILIES, INVALID_MESH_FAMILIES)),
    ):
        titles = {name: family.title for group in groups for name, family in group.items()}
        rows += [
            {"name": name, "dimension": dimension, "title": title, "command": "generate"}
            for name, title in titles.items()
        ]
    value = document("families", watch, families=rows)
    give(value, json, _print)


def _print(value: dict[str, Any]) -> None:
    table = plain_table("family", "dimension", "command", "what it makes")
    for row in value["families"]:
        table.add_row(row["name"], str(row["dimension"]), row["command"], row["title"])
    console().print(table)
