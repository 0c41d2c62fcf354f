"""Cases of a polygon set and a disc in the table of their family, and drawn: the sum below, at and
above its radius, with true arcs."""

from __future__ import annotations

import json
import math
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path
from typing import Any

from minkref import _core
from minkref.errors import message_of
from minkref.offset_picture import offset_picture
from minkref.reports.degeneracies.cases import unfit
from minkref.reports.degeneracies.pictures import Drawn


@dataclass(frozen=True)
class DiscRow:
    """A case's row in the family's table. `events`: the kinds of events at the case's radius, with
    counts; `counts`: components and holes below, at and above the radius."""

    id: str
    file: str
    title: str
    vertices: int
    disc: str
    nearest: int  # number of nearest points, at the first place
    events: str
    counts: str
    why: str


def disc_row(path: Path, value: dict[str, Any]) -> DiscRow:
    told = value["degeneracy"]
    kinds = [row["kind"] for row in told["events"]]
    return DiscRow(
        value["id"],
        str(path),
        value["title"],
        sum(
            len(ring) for p in value["P"]["polygons"] for ring in (p["outer"], *p.get("holes", []))
        ),
        value["Q"],
        len(told["nearest"][0]["points"]),
        ", ".join(f"{kinds.count(kind)} {kind}" for kind in dict.fromkeys(kinds)) or "none",
        ", ".join(f"{c}/{h}" for c, h in told["below_at_above"]),
        told["why"],
    )


def disc_case_pictures(path: Path, value: dict[str, Any]) -> list[Drawn]:
    """The sums at the sibling below, at the radius, and at the sibling above."""
    squares = value["squared_radii"]
    beside = (len(squares) - 1) // 2
    wanted = ((squares[1], "just below"), (squares[0], "at"), (squares[1 + beside], "just above"))
    try:
        P = _core.PolygonSet.from_json(json.dumps(value["P"]))
        P.validate("P")
        drawn = []
        for square, where in wanted:
            radius = math.sqrt(Fraction(square))
            caption = f"the sum {where} the radius {radius:.6g}"
            found = _core.offset(P, square)
            drawn.append(Drawn(caption, offset_picture(found, P, caption)))
        return drawn
    except (_core.BadInput, ArithmeticError) as error:
        raise unfit(path, f"it cannot be drawn: {message_of(error)}", "not-drawable") from error
