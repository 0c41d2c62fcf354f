"""Operands in the plane for checks, and a second version of the convolution's rule, in plain Python
and without `reference/`."""

from __future__ import annotations

import json
import math
import random
from collections.abc import Iterator, Sequence
from fractions import Fraction

from minkref import _core
from minkref.degeneracies.plane.convolutions import crossing_combs
from minkref.fuzz.geometry.plane import (
    Ring,
    Vector,
    box,
    cross,
    dot,
    doubled_area,
    fraction_rings,
    minus,
    plus,
)
from minkref.fuzz.plane.families.drawing import shape_text
from minkref.fuzz.plane.families.random_pairs import random_pair

__all__ = [
    "Ring",
    "bay",
    "box",
    "combs",
    "covered",
    "crossings",
    "operand",
    "random_operand",
    "reduced_by_rings",
    "reduced_by_rule",
    "star",
]

Place = Vector[Fraction]
Segment = tuple[Place, Place]
Rings = list[list[Place]]


def operand(polygon: Sequence[Ring]) -> _core.PolygonSet:
    """One polygon: an outer ring, counter-clockwise, and holes, turned as they should be."""
    outer, *holes = polygon
    return _core.PolygonSet.from_json(shape_text([[outer, *(_clockwise(h) for h in holes)]]))


def _clockwise(ring: Ring) -> Ring:
    return ring if doubled_area(ring) < 0 else ring[::-1]


def random_operand(dice: random.Random, holes: bool = True) -> _core.PolygonSet:
    """A random operand from a pair of small polygons on a grid, where parallel edges abound."""
    while True:
        pair = random_pair(dice.randrange(10**9), dice.randrange(240))
        found = _core.PolygonSet.from_json(dice.choice((pair.P, pair.Q)))
        polygons = json.loads(found.to_json())["polygons"]
        simple = found.is_region and len(polygons) == 1 and not polygons[0]["holes"]
        if found.is_region and (holes or simple):
            return found


def rings_of(value: _core.PolygonSet) -> Rings:
    return fraction_rings(value.to_json())


def _same(u: Place, v: Place) -> bool:
    return cross(u, v) == 0 and dot(u, v) > 0


def _in_turn(d: Place, start: Place, end: Place, ends: str) -> bool:
    """Whether d lies on the left turn, shorter than 180 degrees, from `start` to `end`; `ends`,
    such as `[)`, says which ends belong to the turn."""
    if _same(d, start):
        return ends[0] == "["
    if _same(d, end):
        return ends[1] == "]"
    return cross(start, d) > 0 and cross(d, end) > 0


def _contributions(
    edges_of: Rings, corners_of: Rings, ends: str, reflex: bool
) -> Iterator[tuple[Segment, int]]:
    """Edges of one operand at the other's vertices, with sign 1 at convex vertices and -1 at reflex
    vertices. Skips reflex vertices unless `reflex`."""
    for corner_ring in corners_of:
        for k, v in enumerate(corner_ring):
            come = minus(v, corner_ring[k - 1])
            go = minus(corner_ring[(k + 1) % len(corner_ring)], v)
            turn = cross(come, go)
            if turn == 0 or (turn < 0 and not reflex):
                continue
            for ring in edges_of:
                for i, a in enumerate(ring):
                    b = ring[(i + 1) % len(ring)]
                    d = minus(b, a)
                    if turn > 0 and _in_turn(d, come, go, ends):
                        yield (plus(a, v), plus(b, v)), 1
                    if turn < 0 and _in_turn(d, go, come, ends):
                        yield (plus(a, v), plus(b, v)), -1


def reduced_by_rule(
    P: _core.PolygonSet, Q: _core.PolygonSet, ends: str, reflex: bool = False, signed: bool = False
) -> list[Segment]:
    """Convolution edges under given ends of turns at vertices of Q, then of P: edges from convex
    vertices first; then, if `reflex`, edges from reflex vertices, backwards if `signed`."""
    return reduced_by_rings(rings_of(P), rings_of(Q), ends, reflex, signed)


def reduced_by_rings(
    P: Rings, Q: Rings, ends: str, reflex: bool = False, signed: bool = False
) -> list[Segment]:
    """Like `reduced_by_rule`, for rings that need not have the right orientation."""
    found = [*_contributions(P, Q, ends[:2], reflex), *_contributions(Q, P, ends[2:], reflex)]
    convex = [segment for segment, sign in found if sign > 0]
    other = [segment[::-1] if signed else segment for segment, sign in found if sign < 0]
    return [*convex, *((b[0], b[1]) for b in other)]


def covered(edge: Segment, segments: list[Segment]) -> bool:
    """Whether a segment, or a point, is covered by the union of segments."""
    a, b = edge
    d = minus(b, a)
    spans = []
    for u, v in segments:
        if a == b:
            w = minus(v, u)
            along = dot(minus(a, u), w)
            if cross(minus(a, u), w) == 0 and 0 <= along <= dot(w, w):
                return True
        elif cross(minus(u, a), d) == 0 == cross(minus(v, a), d):
            spans.append(sorted((dot(minus(u, a), d), dot(minus(v, a), d))))
    if a == b:
        return False
    reach, end = Fraction(0), dot(d, d)
    for low, high in sorted(spans):
        if low > reach:
            break
        reach = max(reach, high)
    return reach >= end


def winding(P: _core.PolygonSet, Q: _core.PolygonSet, x: Place) -> int:
    """Winding number of the full convolution around a point on none of its segments."""
    return crossings(reduced_by_rule(P, Q, "[)(]", reflex=True, signed=True), x)


def crossings(segments: Sequence[Segment], x: Place) -> int:
    """Counts segments that cross the upward ray from x to the left, minus segments that cross to
    the right; for a closed cycle this equals its winding number. No segment may contain x."""
    number = 0
    for a, b in segments:
        if (a[0] <= x[0]) != (b[0] <= x[0]):
            y = a[1] + (b[1] - a[1]) * (x[0] - a[0]) / (b[0] - a[0])
            if y > x[1]:
                number += 1 if b[0] < a[0] else -1
    return number


def bay(dice: random.Random) -> _core.PolygonSet:
    """A box with a bay whose mouth is narrower than the bay, so that sums often have a hole."""
    w, h = dice.randint(7, 10), dice.randint(5, 9)
    a, b, t = dice.randint(1, 2), w - dice.randint(1, 2), h - dice.randint(1, 2)
    left = dice.randint(a + 1, b - 2)
    right = left + 1
    ring: Ring = [(0, 0), (w, 0), (w, h), (right, h), (right, t), (b, t), (b, 1), (a, 1), (a, t),
            (left, t), (left, h), (0, h)]  # fmt: skip
    return operand([ring])


def star(n: int, phase: int) -> _core.PolygonSet:
    """A star of 2 n vertices, every other vertex far out."""
    ring: Ring = []
    for k in range(2 * n):
        angle = math.pi * (k + 0.1 * phase) / n
        radius = 1000 if k % 2 else 300
        ring.append((round(radius * math.cos(angle)), round(radius * math.sin(angle))))
    return operand([ring])


def combs(m: int, n: int) -> tuple[_core.PolygonSet, _core.PolygonSet]:
    """Operands with 8 (m + n) vertices whose sum has on the order of m^2 n^2 holes."""
    P, Q = (shape_text(shape) for shape in crossing_combs(m, n, Fraction(1, 3), 0))
    return _core.PolygonSet.from_json(P), _core.PolygonSet.from_json(Q)


def regular(n: int, phase: float) -> _core.PolygonSet:
    """A regular polygon, its vertices rounded to 12 decimals."""
    angles = [phase + 2 * math.pi * k / n for k in range(n)]
    ring: Ring = [
        (Fraction(f"{math.cos(a):.12f}"), Fraction(f"{math.sin(a):.12f}")) for a in angles
    ]
    return operand([ring])


def turned_by(value: _core.PolygonSet, cosine: Fraction, sine: Fraction) -> _core.PolygonSet:
    """A rotation with rational cosine and sine."""

    def turned(ring: list[Place]) -> Ring:
        return [(cosine * x - sine * y, sine * x + cosine * y) for x, y in ring]

    return operand([turned(ring) for ring in rings_of(value)])
