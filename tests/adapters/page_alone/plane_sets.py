"""Sets in the plane as lists of polygons with exact points, and their sums by the reference."""

from __future__ import annotations

import json
from fractions import Fraction
from itertools import pairwise
from typing import Any

from conversation import number_of
from minkref import _core

Point = tuple[Fraction, Fraction]
Ring = list[Point]
Polygon = tuple[Ring, list[Ring]]


def plain(ring: Any) -> list[list[str]]:
    return [[str(number_of(x)), str(number_of(y))] for x, y in ring]


def set_of(value: Any) -> _core.PolygonSet:
    """The set of a request, from numbers in any form."""
    polygons = [
        {"outer": plain(one["outer"]), "holes": [plain(hole) for hole in one["holes"]]}
        for one in value["polygons"]
    ]
    return _core.PolygonSet.from_json(json.dumps({"polygons": polygons}))


def ring_of(ring: Any) -> Ring:
    return [(number_of(x), number_of(y)) for x, y in ring]


def polygons_of(region: _core.PolygonSet) -> list[Polygon]:
    return [
        (ring_of(one["outer"]), [ring_of(hole) for hole in one["holes"]])
        for one in json.loads(region.to_json())["polygons"]
    ]


def rings_of(polygons: list[Polygon]) -> list[Ring]:
    return [ring for outer, holes in polygons for ring in (outer, *holes)]


def set_of_rings(rings: list[Ring]) -> _core.PolygonSet:
    """The points with a winding number greater than zero."""
    polygons = [{"outer": plain(ring), "holes": []} for ring in rings]
    return _core.canonicalize(_core.PolygonSet.from_json(json.dumps({"polygons": polygons})))[0]


def twice_area(ring: Ring) -> Fraction:
    return sum(
        (a[0] * b[1] - a[1] * b[0] for a, b in zip(ring, ring[1:] + ring[:1], strict=True)),
        Fraction(0),
    )


def cross(a: Point, b: Point, c: Point) -> Fraction:
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def hull(points: list[Point]) -> Ring:
    """The hull, counter-clockwise, without collinear vertices; fewer than three points for flat
    sets."""
    ordered = sorted(set(points))
    if len(ordered) < 3:
        return ordered
    chains: list[Ring] = []
    for way in (ordered, ordered[::-1]):
        chain: Ring = []
        for point in way:
            while len(chain) > 1 and cross(chain[-2], chain[-1], point) <= 0:
                chain.pop()
            chain.append(point)
        chains.append(chain[:-1])
    return chains[0] + chains[1]


def sum_of(sP: _core.PolygonSet, Q: _core.PolygonSet) -> list[Polygon]:
    """sP + Q without parts that have no area."""
    if sP.is_empty or Q.is_empty:
        return []
    if sP.is_region or Q.is_region:
        return polygons_of(_core.minkowski_sum(sP, Q, "1").region)
    ends = [rings_of(polygons_of(operand))[0] for operand in (sP, Q)]
    ring = hull([(a[0] + b[0], a[1] + b[1]) for a in ends[0] for b in ends[1]])
    return [(ring, [])] if len(ring) > 2 else []


def edges_of(rings: list[Ring]) -> list[tuple[Point, Point]]:
    return [side for ring in rings for side in zip(ring, ring[1:] + ring[:1], strict=True)]


def trapezoids(rings: list[Ring]) -> list[Ring]:
    """The set cut at the x of each vertex: trapezoids and triangles, counter-clockwise."""
    columns = sorted({x for ring in rings for x, _ in ring})
    sides = [(min(side), max(side)) for side in edges_of(rings)]
    found: list[Ring] = []
    for left, right in pairwise(columns):
        across = [(height(s, left), height(s, right)) for s in sides if spans(s, left, right)]
        across.sort(key=lambda heights: (heights[0] + heights[1], heights))
        for low, high in zip(across[::2], across[1::2], strict=True):
            ring = [(left, low[0]), (right, low[1]), (right, high[1]), (left, high[0])]
            ring = [p for k, p in enumerate(ring) if p != ring[k - 1]]
            if len(ring) > 2:
                found.append(ring)
    return found


def spans(side: tuple[Point, Point], left: Fraction, right: Fraction) -> bool:
    return side[0][0] <= left and side[1][0] >= right


def height(side: tuple[Point, Point], x: Fraction) -> Fraction:
    (x0, y0), (x1, y1) = side
    return y0 + (y1 - y0) * (x - x0) / (x1 - x0)


def boundary_sum(first: list[Ring], second: list[Ring]) -> list[Ring]:
    """The sums of all pairs of sides, as overlapping parallelograms."""
    return [
        ring
        for a, b in edges_of(first)
        for c, d in edges_of(second)
        if len(ring := hull([(p[0] + q[0], p[1] + q[1]) for p in (a, b) for q in (c, d)])) > 2
    ]


def square(half: Fraction) -> _core.PolygonSet:
    ring = [(-half, -half), (half, -half), (half, half), (-half, half)]
    return set_of_rings([ring])


def grown(polygons: list[Polygon], by: Fraction) -> list[Polygon]:
    if not polygons:
        return []
    return sum_of(set_of_rings(rings_of(polygons)), square(by))


def shrunk(polygons: list[Polygon], by: Fraction) -> list[Polygon]:
    """The polygons that the grown complement leaves."""
    if not polygons:
        return []
    rings = rings_of(polygons)
    far = 8 * by + max(abs(number) for ring in rings for point in ring for number in point)
    frame = [(-far, -far), (far, -far), (far, far), (-far, far)]
    outside = set_of_rings([frame, *(ring[::-1] for ring in rings)])
    wide = rings_of(grown(polygons_of(outside), by))
    edge = far + by
    whole = [(-edge, -edge), (edge, -edge), (edge, edge), (-edge, edge)]
    return polygons_of(set_of_rings([whole, *(ring[::-1] for ring in wide)]))
