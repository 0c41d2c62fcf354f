"""`minkref models`: what P and Q can be named, and polyhedra."""

from __future__ import annotations

import os
from typing import Any

from minkref.cli.options import Json, Schema
from minkref.cli.output import give, plain_table
from minkref.errors import Refusal
from minkref.model_catalogue import (
    PAPER_MODELS,
    VARIABLE,
    Model,
    SpaceModel,
    all_models,
    shipped_polyhedra,
)
from minkref.output.documents import Stopwatch, document
from minkref.output.terminal import console, escaped
from minkref.plane.operand import read_set
from rich.table import Table

EXAMPLES = """Examples:

minkref models

MINKREF_MODELS=folder minkref models --json"""


def command(json: Json = False, schema: Schema = False) -> None:
    """The models, polygons and polyhedra, that can be named instead of a file, with their sizes."""
    watch = Stopwatch()
    models = all_models()
    rows: list[dict[str, Any]] = []
    unreadable: list[dict[str, str]] = []
    for model in sorted(models.values(), key=lambda m: (m.origin, m.name)):
        try:
            rows.append(_row(model))
        except Refusal as refusal:
            unreadable.append({"name": model.name, "file": str(model.path), "why": refusal.what})
    absent = [
        {"name": name, "look_alike": alike}
        for name, _, alike, _ in PAPER_MODELS
        if name not in models
    ]
    folder = os.environ.get(VARIABLE) or None
    value = document(
        "models",
        watch,
        folder=folder,
        models=rows,
        polyhedra=[
            _space_row(model) for model in sorted(shipped_polyhedra(), key=lambda m: m.name)
        ],
        unreadable=unreadable,
        absent=absent,
    )
    give(value, json, _print)


def _row(model: Model) -> dict[str, Any]:
    read = read_set(model.path)
    polygons = len(read.rings())
    return {
        "name": model.name,
        "vertices": read.vertices,
        "holes": read.ring_count - polygons,
        "origin": model.origin,
        "file": str(model.path),
        "about": model.about,
    }


def _space_row(model: SpaceModel) -> dict[str, Any]:
    return {
        "name": model.name,
        "vertices": model.vertices,
        "facets": model.facets,
        "origin": "shipped",
        "file": str(model.path),
        "about": model.about,
    }


def _print(value: dict[str, Any]) -> None:
    out = console()
    out.print(_table("model", "holes", value["models"]))
    for row in value["unreadable"]:
        out.print(f"{escaped(row['file'])} cannot be read: {escaped(row['why'])}", soft_wrap=True)
    for row in value["absent"]:
        out.print(
            f"{row['name']} is absent ({VARIABLE} does not hold it); "
            f"our look-alike is {row['look_alike']}",
            soft_wrap=True,
        )
    if value["polyhedra"]:
        out.print()
        out.print(_table("polyhedron", "facets", value["polyhedra"]))


def _table(kind: str, parts: str, rows: list[dict[str, Any]]) -> Table:
    table = plain_table(kind, "vertices", parts, "from", "what it is", right=("vertices", parts))
    for row in rows:
        table.add_row(
            escaped(row["name"]),
            f"{row['vertices']:,}",
            str(row[parts]),
            row["origin"],
            row["about"],
        )
    return table
