"""Decides whether a chamber has room for a hole, in doubles, by cutting squares into four."""

from __future__ import annotations

from collections.abc import Sequence
from math import hypot

from .boundary import Edge, Point

FINE = 2e-3  # resolution, relative to the chamber's size


def holds_more(ring: Sequence[Point], walls: Sequence[tuple[Point, Point]], reach: float) -> bool:
    """Tell whether some place inside a chamber lies clearly farther than `reach` from its walls and
    corners. A wall or corner is always nearest to the place: a nearest point behind a bridge would
    lie inside the bridge's disc."""
    own = [Edge(0, k, 0, p, q) for k, (p, q) in enumerate(walls)]
    sides = [Edge(0, k, 0, p, q) for k, (p, q) in enumerate(zip(ring, [*ring[1:], ring[0]],
                                                                strict=True))]  # fmt: skip
    xs, ys = ([float(p[k]) for p in ring] for k in (0, 1))
    corners = list(zip(xs, ys, strict=True))
    half = max(max(xs) - min(xs), max(ys) - min(ys)) / 2
    if half == 0:
        return False
    slack = FINE * half
    cells = [((max(xs) + min(xs)) / 2, (max(ys) + min(ys)) / 2, half)]
    while cells:
        x, y, half = cells.pop()
        across = hypot(half, half)
        far = min(
            *(hypot(x - a, y - b) for a, b in corners),
            *(edge.rounded_distance(x, y) for edge in own),
        )
        if far + across <= reach + slack or half < slack / 2:
            continue
        if _is_inside(xs, ys, x, y):
            if far > reach + slack:
                return True
        elif min(side.rounded_distance(x, y) for side in sides) > across:
            continue
        half /= 2
        cells += [(x + i * half, y + j * half, half) for i in (-1, 1) for j in (-1, 1)]
    return False


def _is_inside(xs: Sequence[float], ys: Sequence[float], x: float, y: float) -> bool:
    inside = False
    for k in range(len(xs)):
        ax, ay, bx, by = xs[k - 1], ys[k - 1], xs[k], ys[k]
        if (ay > y) != (by > y) and ax + (y - ay) / (by - ay) * (bx - ax) > x:
            inside = not inside
    return inside
