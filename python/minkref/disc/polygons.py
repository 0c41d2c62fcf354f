"""Polygons with rational corners inside and outside of a disc."""

from __future__ import annotations

import math
from fractions import Fraction

from minkref import _core
from minkref.disc.disc import Disc
from minkref.errors import Refusal
from minkref.exact import set_json

MOST_CORNERS = 100_000


def polygon_near(disc: Disc, tolerance: Fraction, outside: bool) -> _core.PolygonSet:
    """A convex polygon inside of the disc with all points of the disc within the tolerance, or
    around the disc and within the tolerance of it. So its sum with a set is inside of, or around,
    that of the disc, and within the tolerance too. Refuses more than MOST_CORNERS corners."""
    low, high = disc.bounds(80)
    ratio = float(tolerance / high) if tolerance < high else 1.0
    corners = 4 * max(1, math.ceil(math.pi / (2 * math.acos(max(1 - ratio, -1.0)) or 1.0) / 2))
    while corners <= MOST_CORNERS:
        marks = _marks(corners)
        radius = high if outside else low
        if outside:
            ring = [_crossing(radius, a, b) for a, b in _neighbours(marks)]
            near = all(x * x + y * y <= (low + tolerance) ** 2 for x, y in ring)
        else:
            ring = [(radius * x, radius * y) for x, y in marks]
            # The farthest point of the disc from a side is beyond its middle.
            near = all(
                ((a[0] + b[0]) ** 2 + (a[1] + b[1]) ** 2) / 4 * radius**2
                >= max(high - tolerance, Fraction(0)) ** 2
                for a, b in _neighbours(marks)
            )
        if near:
            text = set_json([([(str(x), str(y)) for x, y in ring], [])])
            return _core.PolygonSet.from_json(text)
        corners *= 2
    raise Refusal(
        f"a polygon as near to the disc as {float(tolerance):g} has more than {MOST_CORNERS:,} "
        "corners",
        "--tolerance",
        "give a larger one",
        "too-many-corners",
    )


Mark = tuple[Fraction, Fraction]


def _marks(count: int) -> list[Mark]:
    """Rational points of the unit circle, about evenly, counter-clockwise: a quarter by tangents of
    half angles, and turned."""
    quarter = count // 4
    found: list[Mark] = []
    for k in range(quarter):
        t = Fraction(round(math.tan(math.pi / 4 * k / quarter) * (1 << 40)), 1 << 40)
        found.append(((1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)))
    for _ in range(3):
        found += [(-y, x) for x, y in found[-quarter:]]
    return found


def _neighbours(marks: list[Mark]) -> list[tuple[Mark, Mark]]:
    return list(zip(marks, [*marks[1:], marks[0]], strict=True))


def _crossing(radius: Fraction, a: Mark, b: Mark) -> Mark:
    """Of the tangents of a circle at two points of it."""
    turn = a[0] * b[1] - a[1] * b[0]
    return radius * (b[1] - a[1]) / turn, radius * (a[0] - b[0]) / turn
