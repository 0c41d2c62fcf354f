"""Sums with a disc as polygons that a file can hold: inside of the true sum, or around it."""

from __future__ import annotations

import math
from fractions import Fraction

from minkref import _core
from minkref.disc.disc import Disc
from minkref.errors import Refusal
from minkref.exact import set_json

MOST_CORNERS = 100_000
GAP = 64  # of the tolerance, or the radius if that is less: what roundings may use
ATTEMPTS = 8
Ring = list[tuple[Fraction, Fraction]]


def sum_near(P: _core.PolygonSet, disc: Disc, within: Fraction, outside: bool) -> _core.PolygonSet:
    """A polygon set inside of the sum of P and a disc, from which no point of that is farther than
    `within`; or around it, with no point farther from it. All coordinates are finite decimals, so
    that a file holds this very set. Proof: docs/disc.md, "What is written". Refuses more than
    MOST_CORNERS corners of the disc's polygon, and a sum whose gaps no short decimals tell."""
    least = min(within, disc.bounds(80)[0])
    for attempt in range(ATTEMPTS):
        gap = least / (GAP + 9 * attempt)
        unit = _power_of_ten_below(gap / 4)
        polygon = polygon_near(disc, within, outside, gap, unit)
        near = _core.minkowski_sum(P, polygon, "1").region
        found = _rounded(near, unit / 1000**attempt)
        try:
            found.validate("")
        except _core.BadInput:
            continue  # rings that are too near to each other: other radii and finer decimals
        return found
    raise Refusal(
        "rings of the sum are nearer to each other than short decimals tell",
        "--tolerance",
        "give another radius or tolerance, or write .json, .svg or .dxf",
        "too-near",
    )


def polygon_near(
    disc: Disc, within: Fraction, outside: bool, gap: Fraction, unit: Fraction
) -> _core.PolygonSet:
    """A convex polygon whose corners are multiples of a unit, at most a quarter of `gap`. It is
    inside of the disc, and half of `gap` away from its circle, and no point of the disc is farther
    from it than `within` less half of `gap`. Or so around the disc. Refuses more than MOST_CORNERS
    corners."""
    low, high = disc.bounds(80)
    ratio = float((within - gap) / high) if within < high else 1.0
    corners = 4 * max(1, math.ceil(math.pi / (2 * math.acos(max(1 - ratio, -1.0)) or 1.0) / 2))
    while corners <= MOST_CORNERS:
        marks = _marks(corners)
        if outside:
            radius = high + gap * 3 / 4
            ring = [_crossing(radius, a, b) for a, b in _neighbours(marks)]
        else:
            ring = [((low - gap * 3 / 4) * x, (low - gap * 3 / 4) * y) for x, y in marks]
        ring = [(unit * round(x / unit), unit * round(y / unit)) for x, y in ring]
        if _is_near(ring, low, high, within, outside, gap / 2):
            return _set_of([[ring]])
        corners *= 2
    raise Refusal(
        f"a polygon as near to the disc as {float(within):g} has more than {MOST_CORNERS:,} "
        "corners",
        "--tolerance",
        "give a larger one",
        "too-many-corners",
    )


def _is_near(
    ring: Ring, low: Fraction, high: Fraction, within: Fraction, outside: bool, gap: Fraction
) -> bool:
    """Whether corners and sides are as far from the origin as polygon_near says. Exact."""
    nearest, farthest = (high + gap, low + within - gap) if outside else (
        high - within + gap, low - gap,
    )  # fmt: skip
    nearest = max(nearest, Fraction(0))
    return all(x * x + y * y <= farthest**2 for x, y in ring) and all(
        (turn := ax * by - ay * bx) > 0
        and turn**2 >= nearest**2 * ((bx - ax) ** 2 + (by - ay) ** 2)
        for (ax, ay), (bx, by) in _neighbours(ring)
    )


def _rounded(region: _core.PolygonSet, unit: Fraction) -> _core.PolygonSet:
    """Each vertex moved to a multiple of a unit. Rings of which nothing is left are left out."""
    polygons = []
    for rings in region.rings():
        moved = [
            _without_repeats([(round(x / unit), round(y / unit)) for x, y in r]) for r in rings
        ]
        kept = [[(unit * x, unit * y) for x, y in ring] for ring in moved if len(ring) > 2]
        if kept:
            polygons.append(kept)
    return _set_of(polygons)


def _without_repeats(ring: list[tuple[int, int]]) -> list[tuple[int, int]]:
    return [point for k, point in enumerate(ring) if point != ring[k - 1]]


def _set_of(polygons: list[list[Ring]]) -> _core.PolygonSet:
    return _core.PolygonSet.from_json(set_json((rings[0], rings[1:]) for rings in polygons))


def _power_of_ten_below(value: Fraction) -> Fraction:
    """The greatest power of ten that is not above a positive number."""
    power = Fraction(10) ** (len(str(value.numerator)) - len(str(value.denominator)))
    return power if power <= value else power / 10


def _marks(count: int) -> Ring:
    """Rational points of the unit circle, about evenly, counter-clockwise: a quarter by tangents of
    half angles, and turned."""
    quarter = count // 4
    found: Ring = []
    for k in range(quarter):
        t = Fraction(round(math.tan(math.pi / 4 * k / quarter) * (1 << 40)), 1 << 40)
        found.append(((1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)))
    for _ in range(3):
        found += [(-y, x) for x, y in found[-quarter:]]
    return found


def _neighbours(ring: Ring) -> list[tuple[tuple[Fraction, Fraction], tuple[Fraction, Fraction]]]:
    return list(zip(ring, [*ring[1:], ring[0]], strict=True))


def _crossing(
    radius: Fraction, a: tuple[Fraction, Fraction], b: tuple[Fraction, Fraction]
) -> tuple[Fraction, Fraction]:
    """The crossing of the tangents at two points of a circle."""
    turn = a[0] * b[1] - a[1] * b[0]
    return radius * (b[1] - a[1]) / turn, radius * (a[0] - b[0]) / turn
