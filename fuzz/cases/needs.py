"""What an implementation must be able to take, to be asked about a case."""

from __future__ import annotations

import json
from fractions import Fraction
from itertools import pairwise
from typing import Any

LARGEST_DOUBLE = Fraction(2) ** 1023


def needs_of_plane(P_json: str, Q_json: str) -> frozenset[str]:
    """The capabilities (docs/adapter-protocol.md) that two operands ask for."""
    needs = {"plane"}
    for text in (P_json, Q_json):
        needs |= _of_polygons(json.loads(text)["polygons"])
    return frozenset(needs)


def _of_polygons(polygons: list[dict[str, Any]]) -> set[str]:
    if not polygons:
        return {"empty"}
    needs: set[str] = set()
    if len(polygons) > 1:
        needs.add("components")
    if any(polygon["holes"] for polygon in polygons):
        needs |= {"holes", "non-convex"}
    outers = [polygon["outer"] for polygon in polygons]
    if any(len(ring) == 1 for ring in outers):
        needs.add("point")
    if any(len(ring) == 2 for ring in outers):
        needs.add("segment")
    rings = [ring for p in polygons for ring in (p["outer"], *p["holes"])]
    if len(rings) > 1 and _touching(rings):
        needs.add("touching")
    if len(polygons) > 1 or not _convex(outers[0]):
        needs.add("non-convex")
    if not all(is_double(number) for ring in rings for point in ring for number in point):
        needs.add("rational")
    return needs


def is_double(number: str | Fraction) -> bool:
    value = Fraction(number)
    if abs(value) >= LARGEST_DOUBLE:
        return False
    return Fraction(float(value)) == value


def _convex(ring: list[list[str]]) -> bool:
    points = [(Fraction(x), Fraction(y)) for x, y in ring]
    if len(points) < 3:
        return True
    count = len(points)
    return all(
        (b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0]) >= 0
        for a, b, c in ((points[k - 2], points[k - 1], points[k]) for k in range(count))
    )


def _touching(rings: list[list[list[str]]]) -> bool:
    """A vertex of one ring lies on another: closed rings that do not cross touch in no other
    way."""
    plain = [[(Fraction(x), Fraction(y)) for x, y in ring] for ring in rings]
    boxes = [
        (min(x for x, _ in r), min(y for _, y in r), max(x for x, _ in r), max(y for _, y in r))
        for r in plain
    ]
    for first, ring in enumerate(plain):
        for second, other in enumerate(plain):
            if first == second:
                continue
            left, low, right, high = boxes[second]
            for x, y in ring:
                if left <= x <= right and low <= y <= high and _on_ring((x, y), other):
                    return True
    return False


def _on_ring(p: tuple[Fraction, Fraction], ring: list[tuple[Fraction, Fraction]]) -> bool:
    return any(
        (b[0] - a[0]) * (p[1] - a[1]) == (b[1] - a[1]) * (p[0] - a[0])
        and min(a[0], b[0]) <= p[0] <= max(a[0], b[0])
        and min(a[1], b[1]) <= p[1] <= max(a[1], b[1])
        for a, b in pairwise([*ring, ring[0]])
    )
