"""Rows for cases with arbitrary polyhedra, in a family's table."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from minkref.errors import cut
from minkref.output.terminal import escaped
from minkref.space.scaling import read_scaling, text_of


@dataclass(frozen=True)
class SolidRow:
    """The row of a case with arbitrary polyhedra. `ties`: their kinds; `contacts`: how sP and x - Q
    meet at the scales, at the first point."""

    id: str
    file: str
    title: str
    vertices: int
    scale: str
    ties: str
    contacts: str
    volume: str
    why: str


def solid_row(path: Path, value: dict[str, Any]) -> SolidRow:
    told = value["degeneracy"]
    points = told["points"][:1]
    volumes = [row.get("volume", "") for row in value.get("expected", ())[:1]]
    return SolidRow(
        value["id"],
        str(path),
        value.get("title", ""),
        sum(len(value[name]["vertices"]) for name in "PQ"),
        escaped(text_of(read_scaling(value["scales"][0]))),
        ", ".join(sorted({tie["what"] for tie in told["ties"]})),
        ", ".join(contact for row in points for contact in row["contact"]),
        cut(str(next(iter(volumes), ""))),
        told["why"],
    )
