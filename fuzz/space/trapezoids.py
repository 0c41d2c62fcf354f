"""Polygon sets in the plane cut into trapezoids, exactly."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from itertools import pairwise

Flat = tuple[Fraction, Fraction]
Ring = list[Flat]
Side = tuple[Flat, Flat]  # from left to right


def trapezoids(rings: Iterable[Ring]) -> list[Ring]:
    """Returns counter-clockwise convex polygons with three or four corners that cover the inside of
    the rings once: the points that an odd number of rings surround. Rings may touch at points but
    do not cross. Each trapezoid extends between two sides until something lies between. O(n^2 log
    n)."""
    sides = [
        (min(a, b), max(a, b))
        for ring in rings
        for a, b in zip(ring, ring[1:] + ring[:1], strict=True)
        if a[0] != b[0]
    ]
    stops = sorted({end[0] for side in sides for end in side})
    found: list[Ring] = []
    open_from: dict[tuple[Side, Side], Fraction] = {}
    for left, right in pairwise(stops):
        middle = (left + right) / 2
        across = [side for side in sides if side[0][0] <= left and side[1][0] >= right]
        across.sort(key=lambda side: height(side, middle))
        between = set(zip(across[::2], across[1::2], strict=True))
        for pair in open_from.keys() - between:
            found.append(_trapezoid(*pair, open_from.pop(pair), left))
        for pair in between:
            open_from.setdefault(pair, left)
    found += [_trapezoid(*pair, start, stops[-1]) for pair, start in open_from.items()]
    return sorted(found)


def height(side: Side, x: Fraction) -> Fraction:
    (x0, y0), (x1, y1) = side
    return y0 + (y1 - y0) * (x - x0) / (x1 - x0)


def _trapezoid(low: Side, high: Side, left: Fraction, right: Fraction) -> Ring:
    corners = [(x, height(low, x)) for x in (left, right)]
    corners += [(x, height(high, x)) for x in (right, left)]
    return [corner for k, corner in enumerate(corners) if corner != corners[k - 1]]
