"""Places a point inside or outside rings, by the parity of the edges below. Exact."""

from __future__ import annotations

from collections.abc import Sequence

from .exact import Point


def inside(rings: Sequence[Sequence[Point]], point: Point) -> bool:
    """Tell whether the point's upward ray crosses the rings an odd number of times. The point must
    lie on no ring; `on_boundary` tells. Cost: linear."""
    x, y = point
    odd = False
    for ring in rings:
        x0, y0 = ring[-1]
        for x1, y1 in ring:
            # Half-open in x: a vertex exactly above the point counts for only one edge.
            if (x0 <= x) != (x1 <= x):
                side = (x1 - x0) * (y - y0) - (y1 - y0) * (x - x0)
                if (side < 0) == (x1 > x0) and side != 0:
                    odd = not odd
            x0, y0 = x1, y1
    return odd


def on_boundary(rings: Sequence[Sequence[Point]], point: Point) -> bool:
    """Tell whether some ring's edge contains the point."""
    x, y = point
    for ring in rings:
        x0, y0 = ring[-1]
        for x1, y1 in ring:
            if (
                min(x0, x1) <= x <= max(x0, x1)
                and min(y0, y1) <= y <= max(y0, y1)
                and (x1 - x0) * (y - y0) == (y1 - y0) * (x - x0)
            ):
                return True
            x0, y0 = x1, y1
    return False
