"""Counts convolution edges from the rule, in plain Python and without `reference/`."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from minkref import _core
from minkref.fuzz.geometry.plane import Vector, cross, dot, fraction_rings, minus
from minkref.fuzz.geometry.space import denominator_of

Ring = Sequence[Vector[int]]


@dataclass
class Turns:
    """Counts of edge-vertex pairs from different operands, with the edge's direction inside the
    vertex's turn (short of a half turn), at its beginning, or at its end."""

    inside: int = 0
    begin: int = 0
    end: int = 0


def turns_of(edges_of: Sequence[Ring], corners_of: Sequence[Ring]) -> tuple[Turns, Turns, int]:
    """Turns at convex vertices, turns at reflex vertices, taken backwards, and the number of edges
    along straight vertices."""
    directions = [way for ring in edges_of for way in _ways(ring)]
    convex, reflex, straight = Turns(), Turns(), 0
    for ring in corners_of:
        around = _ways(ring)
        for come, go in zip([around[-1], *around[:-1]], around, strict=True):
            sense = cross(come, go)
            count = convex if sense > 0 else reflex
            first, last = (come, go) if sense > 0 else (go, come)
            for d in directions:
                left, right = cross(first, d), cross(d, last)
                if sense == 0:
                    straight += left == 0 and dot(first, d) > 0
                elif left > 0 and right > 0:
                    count.inside += 1
                elif left == 0:
                    count.begin += dot(first, d) > 0
                elif right == 0:
                    count.end += dot(last, d) > 0
    return convex, reflex, straight


def whole_rings(value: _core.PolygonSet) -> list[list[Vector[int]]]:
    """All rings times a common denominator: the rule looks at directions only."""
    rings = fraction_rings(value.to_json())
    factor = denominator_of(place for ring in rings for place in ring)
    return [[(int(x * factor), int(y * factor)) for x, y in ring] for ring in rings]


def _ways(ring: Ring) -> list[Vector[int]]:
    """Directions of the edges."""
    return [minus(b, a) for a, b in zip(ring, [*ring[1:], ring[0]], strict=True)]
