"""Closed polygon sets in plain Python fractions: membership, and whether two of them meet."""

from __future__ import annotations

import json
from collections.abc import Iterable
from fractions import Fraction

Point = tuple[Fraction, Fraction]
Rings = list[list[list[Point]]]  # per polygon: outer ring, holes
Edge = tuple[Point, Point]


def rings_of(text: str, factor: Fraction, shift: Point) -> Rings:
    """A set of the canonical JSON's form, scaled about the origin and then moved."""
    return [
        [
            [(factor * Fraction(x) + shift[0], factor * Fraction(y) + shift[1]) for x, y in ring]
            for ring in (polygon["outer"], *polygon["holes"])
        ]
        for polygon in json.loads(text)["polygons"]
    ]


def contains(polygons: Rings, point: Point) -> bool:
    """The point lies in the closed set."""
    for polygon in polygons:
        inside = False
        for ring in polygon:
            for a, b in zip(ring, ring[1:] + ring[:1], strict=True):
                side = turn(a, b, point)
                if side == 0 and in_box(a, b, point):
                    return True
                if (a[1] > point[1]) != (b[1] > point[1]) and (side > 0) == (b[1] > a[1]):
                    inside = not inside
        if inside:
            return True
    return False


def meet(first: Rings, second: Rings) -> bool:
    """The two closed sets share a point: their boundaries meet, or one holds a vertex of the
    other."""
    others = sorted(edges(second), key=lambda edge: min(edge[0][0], edge[1][0]))
    for a, b in edges(first):
        right = max(a[0], b[0])
        for c, d in others:
            if min(c[0], d[0]) > right:
                break
            if segments_meet(a, b, c, d):
                return True
    return any(contains(second, polygon[0][0]) for polygon in first) or any(
        contains(first, polygon[0][0]) for polygon in second
    )


def edges(polygons: Rings) -> list[Edge]:
    return [
        (ring[k - 1], ring[k]) for polygon in polygons for ring in polygon for k in range(len(ring))
    ]


def turn(a: Point, b: Point, c: Point) -> int:
    value = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    return (value > 0) - (value < 0)


def hull(points: Iterable[Point]) -> list[Point]:
    """The convex hull, counter-clockwise, without collinear points (Andrew's monotone chain)."""
    ordered = sorted(set(points))
    if len(ordered) < 3:
        return ordered
    found: list[Point] = []
    for chain in (ordered, ordered[::-1]):
        start = len(found)
        for point in chain:
            while len(found) - start >= 2 and turn(found[-2], found[-1], point) <= 0:
                found.pop()
            found.append(point)
        found.pop()
    return found


def in_box(a: Point, b: Point, p: Point) -> bool:
    return min(a[0], b[0]) <= p[0] <= max(a[0], b[0]) and min(a[1], b[1]) <= p[1] <= max(a[1], b[1])


def segments_meet(a: Point, b: Point, c: Point, d: Point) -> bool:
    if max(a[0], b[0]) < min(c[0], d[0]) or max(c[0], d[0]) < min(a[0], b[0]):
        return False
    if max(a[1], b[1]) < min(c[1], d[1]) or max(c[1], d[1]) < min(a[1], b[1]):
        return False
    t1, t2, t3, t4 = turn(a, b, c), turn(a, b, d), turn(c, d, a), turn(c, d, b)
    if t1 * t2 < 0 and t3 * t4 < 0:
        return True
    return (
        (t1 == 0 and in_box(a, b, c))
        or (t2 == 0 and in_box(a, b, d))
        or (t3 == 0 and in_box(c, d, a))
        or (t4 == 0 and in_box(c, d, b))
    )
