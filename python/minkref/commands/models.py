"""`minkref models`: what P and Q can be named."""

from __future__ import annotations

import os
import sys
from typing import Any

from rich.table import Table

from minkref import _core
from minkref.documents import Stopwatch, as_text, document
from minkref.errors import refusing
from minkref.model_catalogue import PAPER_MODELS, VARIABLE, Model, all_models
from minkref.options import Json, Schema
from minkref.terminal import console

EXAMPLES = """Examples:

minkref models

MINKREF_MODELS=folder minkref models --json"""


def command(json: Json = False, schema: Schema = False) -> None:
    """The models that can be named instead of a file, with their sizes."""
    watch = Stopwatch()
    models = all_models()
    rows = [_row(model) for model in sorted(models.values(), key=lambda m: (m.origin, m.name))]
    absent = [
        {"name": name, "look_alike": alike}
        for name, _, alike, _ in PAPER_MODELS
        if name not in models
    ]
    folder = os.environ.get(VARIABLE) or None
    value = document("models", watch, folder=folder, models=rows, absent=absent)
    if json:
        sys.stdout.write(as_text(value))
    else:
        _print(value)


def _row(model: Model) -> dict[str, Any]:
    read = refusing(str(model.path), lambda: _core.read_file(str(model.path)))
    polygons = len(read.rings())
    return {
        "name": model.name,
        "vertices": read.vertices,
        "holes": read.ring_count - polygons,
        "origin": model.origin,
        "file": str(model.path),
        "about": model.about,
    }


def _print(value: dict[str, Any]) -> None:
    table = Table(box=None, pad_edge=False)
    for heading in ("model", "vertices", "holes", "from", "what it is"):
        table.add_column(heading, justify="right" if heading in ("vertices", "holes") else "left")
    for row in value["models"]:
        table.add_row(
            row["name"], f"{row['vertices']:,}", str(row["holes"]), row["origin"], row["about"]
        )
    out = console()
    out.print(table)
    for row in value["absent"]:
        out.print(
            f"{row['name']} is absent ({VARIABLE} does not hold it); "
            f"our look-alike is {row['look_alike']}",
            soft_wrap=True,
        )
