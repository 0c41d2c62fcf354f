"""The capabilities that an implementation needs to be asked about a case."""

from __future__ import annotations

import json
from fractions import Fraction
from math import lcm
from typing import Any

LARGEST_DOUBLE = Fraction(2) ** 1023
EVERY_INTEGER = 2**53  # up to here, every integer is a double
Node = tuple[int, int]
Ring = list[Node]


def needs_of_plane(*texts: str) -> frozenset[str]:
    """The capabilities (docs/adapter-protocol.md) that sets ask for."""
    needs = {"plane"}
    for text in texts:
        needs |= _of_polygons(json.loads(text)["polygons"])
    return frozenset(needs)


def is_double(number: str | Fraction) -> bool:
    value = Fraction(number)
    if abs(value) >= LARGEST_DOUBLE:
        return False
    return Fraction(float(value)) == value


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
    texts = [ring for p in polygons for ring in (p["outer"], *p["holes"])]
    rings, rational = _integers(texts)
    if rational:
        needs.add("rational")
    if len(rings) > 1 and _touching(rings):
        needs.add("touching")
    if len(polygons) > 1 or not _convex(rings[0]):
        needs.add("non-convex")
    return needs


def _integers(rings: list[list[list[str]]]) -> tuple[list[Ring], bool]:
    """Returns the rings in integers, all multiplied by one number, and whether some coordinate is
    no double."""
    numbers = [number for ring in rings for point in ring for number in point]
    try:
        plain = [int(number) for number in numbers]
        rational = not all(-EVERY_INTEGER <= n <= EVERY_INTEGER or is_double(str(n)) for n in plain)
    except ValueError:
        exact = [Fraction(number) for number in numbers]
        rational = not all(is_double(number) for number in exact)
        unit = lcm(*(number.denominator for number in exact))
        plain = [number.numerator * (unit // number.denominator) for number in exact]
    made, k = [], 0
    for ring in rings:
        made.append([(plain[k + 2 * i], plain[k + 2 * i + 1]) for i in range(len(ring))])
        k += 2 * len(ring)
    return made, rational


def _convex(ring: Ring) -> bool:
    if len(ring) < 3:
        return True
    (ax, ay), (bx, by) = ring[-2], ring[-1]
    for cx, cy in ring:
        if (bx - ax) * (cy - by) - (by - ay) * (cx - bx) < 0:
            return False
        ax, ay, bx, by = bx, by, cx, cy
    return True


def _touching(rings: list[Ring]) -> bool:
    """Whether a vertex of one ring lies on another: simple rings without crossings touch in no
    other way."""
    for first, ring in enumerate(rings):
        for second, other in enumerate(rings):
            if first != second and any(_on_ring(x, y, other) for x, y in ring):
                return True
    return False


def _on_ring(x: int, y: int, ring: Ring) -> bool:
    ax, ay = ring[-1]
    for bx, by in ring:
        if (
            min(ax, bx) <= x <= max(ax, bx)
            and min(ay, by) <= y <= max(ay, by)
            and (bx - ax) * (y - ay) == (by - ay) * (x - ax)
        ):
            return True
        ax, ay = bx, by
    return False
