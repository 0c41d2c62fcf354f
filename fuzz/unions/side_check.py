"""Whether a region is the union of sets, proved edge by edge in plain fractions.

All edges of the sets and of the region, cut at their common points, part the plane into faces, and
each face has a piece of an edge on its boundary. So the region is the union, up to boundaries, iff
on both sides of each piece it has the points that some set has. Uses no code from the reference.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import pairwise

from minkref.fuzz.geometry.plane import (
    Edge,
    Point,
    Shape,
    contains,
    crossing,
    edges,
    in_box,
    segments_meet,
    turn,
)

Sides = tuple[bool, bool]  # left and right


def wrong_side(sets: Sequence[Shape], region: Shape) -> Point | None:
    """Returns the middle of a piece of an edge, beside which the region differs from the union;
    None iff the region is the union. All rings have the interior on the left. O(n^2 log n) for the
    cuts, and O(n) per piece."""
    every = [edge for shape in (*sets, region) for edge in edges(shape)]
    for a, b in _pieces(every):
        middle = ((a[0] + b[0]) * Fraction(1, 2), (a[1] + b[1]) * Fraction(1, 2))
        sides = [_sides(shape, a, b, middle) for shape in sets]
        wanted = (any(left for left, _ in sides), any(right for _, right in sides))
        if _sides(region, a, b, middle) != wanted:
            return middle
    return None


def _pieces(every: list[Edge]) -> Iterator[Edge]:
    """Yields each piece once, from its lesser end."""
    seen: set[Edge] = set()
    for edge in every:
        a, b = sorted(edge)
        cuts = {a, b}
        for other in every:
            if edge is not other and segments_meet(a, b, *other):
                cuts.update(_common(a, b, *other))
        for piece in pairwise(sorted(cuts)):
            if piece not in seen:
                seen.add(piece)
                yield piece


def _common(a: Point, b: Point, c: Point, d: Point) -> list[Point]:
    """Returns the crossing; for parallel segments, the ends on the first segment."""
    if (b[0] - a[0]) * (d[1] - c[1]) == (b[1] - a[1]) * (d[0] - c[0]):
        return [p for p in (c, d) if turn(a, b, p) == 0 and in_box(a, b, p)]
    return [crossing(a, b, c, d)]


def _sides(shape: Shape, a: Point, b: Point, middle: Point) -> Sides:
    """Whether a set has the points just left and just right of the piece from a to b."""
    along = [(c < d) for c, d in edges(shape) if turn(c, d, middle) == 0 and in_box(c, d, middle)]
    if along:
        return any(along), not all(along)
    inside = contains(shape, middle)
    return inside, inside
