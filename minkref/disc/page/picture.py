"""The page of `minkref view P disc` as the JSON document that its scripts read."""

from __future__ import annotations

import math
from collections.abc import Iterable
from fractions import Fraction
from typing import Any

from minkref import _core
from minkref.disc.page.passages import passages_with_disc
from minkref.errors import Refusal
from minkref.plane.page.boundary import NARROWEST, Window
from minkref.plane.page.linear import double, out_of_range

MOST_PARTS = 100_000  # of the diagram: a page of some 25 MB
AROUND = 2  # how far the window goes beyond the radii of events


def window_around(index: _core.DiscIndex, P: _core.PolygonSet) -> tuple[Fraction, Fraction]:
    """Short numbers, with the radii of all events well between them; without events with what is
    small and large beside P."""
    radii = index.radii()
    if radii:
        first, last = radii[0][0] / AROUND, radii[-1][1] * AROUND
    else:
        size = 0.0
        if not P.is_empty:
            low_x, low_y, high_x, high_y = P.bounding_box()
            size = max(high_x - low_x, high_y - low_y)
        first, last = (size or 1.0) / 100, size or 1.0
    if not (math.isfinite(last) and first > 0):
        raise out_of_range("the radius of an event")
    return Fraction(f"{first:.1g}"), Fraction(f"{last:.1g}")


def picture(index: _core.DiscIndex, P: _core.PolygonSet, window: Window) -> dict[str, Any]:
    """The fields of the page's data: docs/command-line.md, "minkref view with a disc". In doubles,
    but for numbers that count. Refuses what is too large for a page, or for doubles."""
    found = diagram(index, P, window)
    return {**found, "passages": passages_with_disc(index, P, found)}


def diagram(index: _core.DiscIndex, P: _core.PolygonSet, window: Window) -> dict[str, Any]:
    """The fields without passages: P, and the outer Voronoi diagram with its events."""
    if index.parts > MOST_PARTS:
        raise Refusal(
            f"the diagram has {index.parts:,} parts, and a page holds {MOST_PARTS:,}",
            "view",
            "take a smaller P, or one picture for each radius: minkref sweep P disc",
            "limit",
        )
    first, last = (double(Fraction(bound), "a radius") for bound in (window.first, window.last))
    if first == 0:
        raise Refusal("the radius is too small for a double", "--from", "begin later", "limit")
    if last <= first * (1 + NARROWEST):
        raise Refusal(
            "the window is too narrow for doubles", "--from, --to", "take a wider one", "limit"
        )
    begins, at_event = index.place(str(Fraction(window.first) ** 2))
    ends, _ = index.place(str(Fraction(window.last) ** 2))
    drawing = index.drawing()
    if not all(map(math.isfinite, _numbers(drawing))):
        raise out_of_range("a coordinate")
    return {
        "window": [[window.first, first], [window.last, last]],
        "inside": [begins - at_event, ends],
        "point": _point(P, drawing),
        **drawing,
    }


def _numbers(drawing: dict[str, Any]) -> Iterable[float]:
    """Those that may be beyond doubles."""
    for name in ("origin", "radii", "places", "motions"):
        yield from drawing[name]
    for feature in drawing["features"]:
        yield from feature[:2]


def _point(P: _core.PolygonSet, drawing: dict[str, Any]) -> list[float] | None:
    """P, if it is a point, which has no boundary to walk along; measured from the origin."""
    if P.is_empty or drawing["sides"]:
        return None
    return [axis - o for axis, o in zip(P.bounding_box()[:2], drawing["origin"], strict=True)]


def counts(data: dict[str, Any]) -> dict[str, Any]:
    """The counts of the page for the document of the command."""
    first, end = data["inside"]
    inside = range(first + 1, end + 1)
    numbers = data["numbers"]
    kinds = [kind for k, kind in enumerate(data["kinds"]) if numbers[k] in inside]
    names = {"c": "corner", "j": "joint", "s": "saddle", "r": "ridge", "m": "maximum"}
    return {
        "radii_of_events": len(inside),
        "events": {name: kinds.count(kind) for kind, name in names.items()},
        "parts_of_the_diagram": len(data["halves"]) // 2,
        "holes": sum(birth <= end and last > first for birth, last, *_ in data["holes"]),
        "polygons": data["polygons"],
    }
