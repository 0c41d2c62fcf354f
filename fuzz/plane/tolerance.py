"""What a result may be within a tolerance: the exact sandwich around the sum."""

from __future__ import annotations

import json
from fractions import Fraction

from minkref import _core
from minkref.fuzz.plane.region import minus


def _square(half: Fraction) -> _core.PolygonSet:
    a, b = str(-half), str(half)
    outer = [[a, a], [b, a], [b, b], [a, b]]
    return _core.PolygonSet.from_json(json.dumps({"polygons": [{"outer": outer, "holes": []}]}))


def grown(region: str, half: Fraction) -> str:
    """The sum of a set (canonical JSON) and the square of half side `half`: canonical JSON."""
    operand = _core.PolygonSet.from_json(region)
    if operand.is_empty or not half:
        return region
    text: str = _core.minkowski_sum(
        operand, _square(half), "1", "paper", "rational"
    ).region.canonical_json()
    return text


def shrunk(region: str, half: Fraction) -> str:
    """The closure of all points whose square of half side `half` lies in the set."""
    polygons = json.loads(region)["polygons"]
    if not polygons or not half:
        return region
    points = [(Fraction(x), Fraction(y)) for polygon in polygons for x, y in polygon["outer"]]
    pad = 2 * half + 1
    left, right = min(x for x, _ in points) - pad, max(x for x, _ in points) + pad
    low, high = min(y for _, y in points) - pad, max(y for _, y in points) + pad
    corners = [(left, low), (right, low), (right, high), (left, high)]
    frame = {"polygons": [{"outer": [[str(x), str(y)] for x, y in corners], "holes": []}]}
    outside = minus(json.dumps(frame), region).canonical_json()
    return minus(region, grown(outside, half)).canonical_json()
