"""The picture of a part that keeps a distance: the part with its clearance around it."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from minkref import _core
from minkref.disc.disc import Disc
from minkref.disc.polygons import sum_near
from minkref.motion.commands.path_rows import number_text, point_text
from minkref.reports.layered_picture import layered_picture

FINE = 64  # the clearance over the width by which its drawing may be off


def clear_picture(
    part: _core.PolygonSet,
    around: _core.PolygonSet,
    value: dict[str, Any],
    shown: dict[str, Any] | None,
    word: str,
) -> str:
    """Draw the part at a scale and place, and the line at the clearance about it. `word`: what the
    part does there."""
    clearance = Fraction(value["clearance"])
    kept = f"clearance {number_text(value['clearance'])}"
    if shown is None or shown["scale"] == "0":
        return layered_picture([("second", around)], [f"{kept}: no part is shown"])
    scale, place = shown["scale"], shown["place"]
    placed = part.scaled(scale).translated(*place)
    near = sum_near(placed, Disc("", clearance**2), clearance / FINE, False)
    lines = [
        [(str(x), str(y)) for x, y in (*ring, ring[0])] for rings in near.rings() for ring in rings
    ]
    caption = [
        f"at the scale {number_text(scale)}, origin at {point_text(place)}",
        f"{word}, {kept}",
    ]
    return layered_picture([("second", around), ("first", placed)], caption, (), lines)
