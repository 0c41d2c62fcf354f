"""The picture that `minkref fit` and `minkref trap` write: the part at a bound of its scales."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from minkref import _core
from minkref.motion.commands.path_rows import number_text, point_text, ranges_text
from minkref.reports.layered_picture import Exact, layered_picture


def fit_picture(
    part: _core.PolygonSet, around: _core.PolygonSet, value: dict[str, Any], word: str
) -> str:
    """Draw the part at the answer's greatest scale (without a greatest at the least scale), at this
    bound's place, with the point of contact. `word`: what the part does at these scales."""
    scale = _scale(value)
    scales = f"{word}: {ranges_text(value['scales'])}"
    if scale is None:
        return layered_picture([("second", around)], [scales])
    bound = next((b for b in value["bounds"] if b["scale"] == scale), None)
    grown = part.scaled(scale)
    asked = [_point(place) for place in value.get("places", [value.get("at")])]
    if bound is not None and bound["event"] != "contact":
        place = _point(bound["at"])  # of the origin; of a contact the point that touches
        touching = _touching(grown, around, place, bound["contact"])
    else:
        touching = [] if bound is None else [_point(bound["at"])]
        place = _place(grown, asked, touching, bound)
    at = point_text([str(c) for c in place])
    caption = [f"at the scale {number_text(scale)}, origin at {at}", scales]
    placed = grown.translated(*map(str, place))
    return layered_picture([("second", around), ("first", placed)], caption, touching)


def _point(texts: Any) -> Exact:
    x, y = map(Fraction, texts)
    return x, y


def _place(
    part: _core.PolygonSet, asked: list[Exact], touching: list[Exact], bound: dict[str, Any] | None
) -> Exact:
    """Choose the given place at which the part touches."""
    if bound is None or not touching or "vertex" not in bound["contact"]["part"]:
        return asked[0]
    x, y = _vertex(part, bound["contact"]["part"]["vertex"])
    at = touching[0][0] - x, touching[0][1] - y
    return at if at in asked else asked[0]


def _scale(value: dict[str, Any]) -> str | None:
    ends = (value[name] for name in ("largest", "smallest") if value[name] is not None)
    return next((end["scale"] for end in ends if end["scale"] not in (None, "0")), None)


def _touching(
    part: _core.PolygonSet, around: _core.PolygonSet, at: Exact, contact: dict[str, Any] | None
) -> list[Exact]:
    """Return the touching vertex; nothing for two edges."""
    if contact is None:
        return []
    if "vertex" in contact["part"]:
        x, y = _vertex(part, contact["part"]["vertex"])
        return [(x + at[0], y + at[1])]
    if "vertex" in contact["obstacle"]:
        return [_vertex(around, contact["obstacle"]["vertex"])]
    return []


def _vertex(of: _core.PolygonSet, named: list[int]) -> Exact:
    ring, index = named
    rings = [ring for polygon in of.rings() for ring in polygon]
    return rings[ring][index]
