"""Sums with a disc as polygons for files: inside the true sum, or around it."""

from __future__ import annotations

import math
from fractions import Fraction

from minkref import _core
from minkref.disc.disc import Disc
from minkref.errors import Refusal
from minkref.exact import power_of_ten_below, set_json

MOST_CORNERS = 100_000
GAP = 64  # roundings' share: the tolerance, or a smaller radius, divided by this
ATTEMPTS = 8
Ring = list[tuple[Fraction, Fraction]]


def sum_near(P: _core.PolygonSet, disc: Disc, within: Fraction, outside: bool) -> _core.PolygonSet:
    """Make a polygon set inside the sum of P and a disc, at most `within` away from every point of
    the sum; or around the sum, with every point at most `within` away from it. All coordinates are
    finite decimals, so a file holds exactly this set. Proof: docs/disc.md, "What is written".
    Refuses more than MOST_CORNERS corners for the disc's polygon, and a sum whose gaps need longer
    decimals."""
    least = min(within, disc.bounds(80)[0])
    for attempt in range(ATTEMPTS):
        gap = least / (GAP + 9 * attempt)
        unit = power_of_ten_below(gap / 4)
        polygon = polygon_near(disc, within, outside, gap, unit)
        near = _core.minkowski_sum(P, polygon, "1").region
        found = _rounded(near, unit / 1000**attempt)
        try:
            found.validate("")
        except _core.BadInput:
            continue  # rings too close to each other: try other radii and finer decimals
        return found
    raise Refusal(
        "rings of the sum are nearer to each other than short decimals tell",
        "--tolerance",
        "give another radius or tolerance, or write .json, .svg or .dxf",
        "too-near",
    )


def inset_near(
    P: _core.PolygonSet, disc: Disc, within: Fraction, outside: bool
) -> _core.PolygonSet:
    """Make a polygon set inside P's erosion by a disc, around P's erosion by a disc larger by
    `within`; or around the erosion, inside P's erosion by a smaller disc. Turns sum_near inside
    out."""
    if not P.is_region:
        return _core.PolygonSet()
    around = sum_near(_core.Outside(P).set, disc, within, not outside)
    return _core.inside_out(around)[0]


def polygon_near(
    disc: Disc, within: Fraction, outside: bool, gap: Fraction, unit: Fraction
) -> _core.PolygonSet:
    """Make a convex polygon whose corners are multiples of a unit, at most a quarter of `gap`. The
    polygon lies inside the disc, half of `gap` away from the circle, and every point of the disc is
    at most `within` less half of `gap` away from the polygon. Or the same around the disc. Refuses
    more than MOST_CORNERS corners."""
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
    """Check that corners and sides are as far from the origin as polygon_near says. Exact."""
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
    """Move each vertex to a multiple of a unit. Drops rings with fewer than three vertices left."""
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


def _marks(count: int) -> Ring:
    """Return rational points on the unit circle, about evenly, counter-clockwise: a quarter from
    half angles' tangents, then turned."""
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
    """Return the crossing of two points' tangents to a circle."""
    turn = a[0] * b[1] - a[1] * b[0]
    return radius * (b[1] - a[1]) / turn, radius * (a[0] - b[0]) / turn
