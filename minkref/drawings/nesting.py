"""Rings without roles as polygons: an odd number of surrounding rings makes a hole."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from minkref.drawings.curves import Point

Ring = list[Point]
Box = tuple[Fraction, Fraction, Fraction, Fraction]


def nested(rings: Sequence[Ring]) -> list[list[Ring]]:
    """Give each hole to the smallest outer ring around. Exact for rings touching at points; one
    point decides for crossing rings, and validation refuses them. O(rings times vertices)."""
    boxes = [_box(ring) for ring in rings]
    around = [
        [
            j
            for j in range(len(rings))
            if j != k and _holds(boxes[j], boxes[k]) and _is_in(r, rings[j])
        ]
        for k, r in enumerate(rings)
    ]
    polygons = {k: [ring] for k, ring in enumerate(rings) if len(around[k]) % 2 == 0}
    for k, ring in enumerate(rings):
        if len(around[k]) % 2:
            owner = max(around[k], key=lambda j: (len(around[j]), -j))
            while owner not in polygons:  # rings that cross
                owner = next(iter(polygons), k)
                polygons.setdefault(owner, [])
            polygons[owner].append(ring)
    return [each for each in polygons.values() if each]


def _box(ring: Ring) -> Box:
    xs, ys = zip(*ring, strict=True)
    return min(xs), min(ys), max(xs), max(ys)


def _holds(outer: Box, inner: Box) -> bool:
    return (
        outer[0] <= inner[0]
        and outer[1] <= inner[1]
        and outer[2] >= inner[2]
        and outer[3] >= inner[3]
    )


def _is_in(inner: Ring, outer: Ring) -> bool:
    """Decide by the first vertex, or midpoint of an edge, off the other ring."""
    following = [*inner[1:], inner[0]]
    middles = [
        ((a[0] + b[0]) / 2, (a[1] + b[1]) / 2) for a, b in zip(inner, following, strict=True)
    ]
    for point in [*inner, *middles]:
        if (side := _side(point, outer)) is not None:
            return side
    return False


def _side(point: Point, ring: Ring) -> bool | None:
    """Tell whether a point lies in a ring, by the even-odd rule; None on it."""
    x, y = point
    inside = False
    for (ax, ay), (bx, by) in zip(ring, [*ring[1:], ring[0]], strict=True):
        turn = (bx - ax) * (y - ay) - (by - ay) * (x - ax)
        if turn == 0 and min(ax, bx) <= x <= max(ax, bx) and min(ay, by) <= y <= max(ay, by):
            return None
        if (ay > y) != (by > y) and (turn > 0) == (by > ay):
            inside = not inside
    return inside
