"""The rings of a sum with a disc, as a page has them, against the sum."""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Any

from minkref import _core

Point = tuple[float, float]
Piece = tuple[Point | None, Point, Point]  # an arc's centre, start and end


def true_rings(P: _core.PolygonSet, radius: float) -> list[list[Piece]]:
    """The rings of the sum with a disc of exactly this radius."""
    drawn = _core.offset(P, str(Fraction(radius) ** 2)).drawn_rings()
    return [
        [
            ((cx, cy) if kind == "arc" else None, (x, y), (u, v))
            for kind, x, y, u, v, cx, cy, _ in ring
        ]
        for component in drawn
        for ring in component
    ]


def ring_difference(got: Any, wanted: list[list[Piece]]) -> float:
    """The greatest distance of a piece's end or centre from its true place, divided by the sum's
    diagonal; infinite if rings or pieces differ. Pieces of one arc count as one piece."""
    found, left = [merged(ring) for ring in got], [merged(ring) for ring in wanted]
    if sorted(map(len, found)) != sorted(map(len, left)):
        return math.inf
    points = [start for ring in left for _, start, _ in ring]
    if not points:
        return 0.0
    sides = [max(p[i] for p in points) - min(p[i] for p in points) for i in (0, 1)]
    worst = 0.0
    for ring in found:
        distances = [
            (math.dist(ring[0][1], piece[1]), number, place)
            for number, other in enumerate(left)
            for place, piece in enumerate(other)
        ]
        _, number, place = min(distances)
        other = left.pop(number)
        if len(other) != len(ring):
            return math.inf
        for one, two in zip(ring, other[place:] + other[:place], strict=True):
            worst = max(worst, _apart(one, two))
    return worst / (math.hypot(*sides) or 1.0)


def _apart(one: Piece, other: Piece) -> float:
    ends = max(math.dist(one[1], other[1]), math.dist(one[2], other[2]))
    if one[0] is None or other[0] is None:
        return ends if one[0] is other[0] else math.inf
    centres = math.dist(one[0], other[0])
    if one[1] == one[2] and other[1] == other[2]:  # circles, which start anywhere
        radii = math.dist(one[0], one[1]), math.dist(other[0], other[1])
        return max(centres, abs(radii[0] - radii[1]))
    return max(centres, ends)


def merged(ring: Any) -> list[Piece]:
    """The ring with each arc's pieces joined; cuts a full circle at its start."""
    pieces = [(centre and tuple(centre), tuple(start), tuple(end)) for centre, start, end in ring]
    first = next((k for k, p in enumerate(pieces) if p[0] is None or p[0] != pieces[k - 1][0]), 0)
    result: list[Any] = []
    for centre, start, end in pieces[first:] + pieces[:first]:
        if result and centre is not None and result[-1][0] == centre:
            result[-1] = (centre, result[-1][1], end)
        else:
            result.append((centre, start, end))
    return result
