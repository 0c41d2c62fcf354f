"""The tight passages that the page of a disc shows: segments at the radii of ridges, where two
parallel sides are as far from what lies between them. At a maximum the passage is its place."""

from __future__ import annotations

from typing import Any

from minkref import _core
from minkref.plane.commands.scale_index import cores
from minkref.plane.page.passages import Passages

MOST_WORK = 200_000  # vertices at radii; some seconds


def passages_with_disc(
    index: _core.DiscIndex, P: _core.PolygonSet, drawing: dict[str, Any]
) -> Passages | None:
    """By the number of the radius, measured from the origin of the drawing; None where there are
    too many for a page that is not waited for. Their squared radii are rational."""
    kinds, numbers = drawing["kinds"], drawing["numbers"]
    ridges = {numbers[event] - 1: event for event, kind in enumerate(kinds) if kind == "r"}
    if len(ridges) * P.vertices > MOST_WORK:
        return None
    x0, y0 = drawing["origin"]
    found: Passages = {}
    for number, event in sorted(ridges.items()):
        square = index.rows(event, 1)[0][1]
        if square is None:
            continue
        rows = _core.offset(P, square, cores()).tight_passages(cores())
        found[str(number)] = [
            [axis for x, y in near for axis in (x - x0, y - y0)] for _, near, _ in rows
        ]
    return found
