"""Judges the remnants of an erosion by a disc: each one told has to be a ridge of the distance from
P's boundary, and the diagram's maxima and P's facing edges have to be told."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import combinations, pairwise

from minkref import _core

Place = tuple[Fraction, Fraction]
Side = tuple[Place, Place]
Spot = tuple[float, float]
WAYS = 32  # around a place
STEP, SLACK = 1e-5, 1e-12  # of the radius, and of the size
NEAR = 1e-10  # of the size
BEYOND = Fraction(1, 10**6)  # of an edge
SHARES = tuple(Fraction(k, 8) for k in range(1, 8))


def remnant_faults(
    P: _core.PolygonSet,
    square: Fraction,
    around: _core.DiscIndex,
    remnants: Sequence[Sequence[Spot]],
) -> Iterator[str]:
    """List faults of remnants, each given by one point or the two ends of a segment. Lost ones: a
    maximum of the diagram, by doubles; a point between facing edges, exactly. Invented or changed
    ones: a point at another distance, or with a larger one beside it, by doubles."""
    sides = sides_of(P)
    size = max(abs(float(c)) for side in sides for point in side for c in point) + 1
    at = str(square)
    maxima = [row[4] for row in _rows(around) if row[0] == "maximum" and row[1] == at]
    points = [one[0] for one in remnants if len(one) == 1]
    if len(points) != len(maxima):
        yield f"{len(points)} points remain, and the diagram has {len(maxima)} maxima"
    for place in maxima:
        if min((math.dist(place, x) for x in points), default=size) > NEAR * size:
            yield f"the maximum {place} is lost"
    for x in ridge_points(sides, square, [end for one in remnants for end in one]):
        spot = (float(x[0]), float(x[1]))
        if not any(to_segment(spot, one[0], one[-1]) <= NEAR * size for one in remnants):
            yield f"the point {spot} between two edges is lost"
    yield from _invented(P, math.sqrt(square), size, remnants)


def _rows(around: _core.DiscIndex) -> list[tuple[str, str | None, object, object, Spot, object]]:
    return list(around.rows(0, len(around.kinds())))


def _invented(
    P: _core.PolygonSet, radius: float, size: float, remnants: Sequence[Sequence[Spot]]
) -> Iterator[str]:
    edges = [[(float(x), float(y)) for x, y in side] for side in sides_of(P)]

    def room(x: Spot) -> float:
        return min(to_segment(x, *edge) for edge in edges)

    for one in remnants:
        (ax, ay), (bx, by) = one[0], one[-1]
        middle = ((ax + bx) / 2, (ay + by) / 2)
        within = ((ax + t * (bx - ax), ay + t * (by - ay)) for t in map(float, SHARES))
        for x in (*one, *within):
            if abs(room(x) - radius) > NEAR * size or (Fraction(x[0]), Fraction(x[1])) not in P:
                yield f"the remnant {one} has another distance at {x}"
        turns = (2 * math.pi * k / WAYS for k in range(WAYS))
        step = STEP * radius
        beside = [(middle[0] + step * math.cos(t), middle[1] + step * math.sin(t)) for t in turns]
        if max(map(room, beside)) > room(middle) + SLACK * size:
            yield f"the remnant {one} has more room beside it"


def ridge_points(sides: list[Side], square: Fraction, ends: Sequence[Spot] = ()) -> Iterator[Place]:
    """List points within P halfway between two facing edges, as far from each as the radius and
    from no edge less: no point near such a point has more room. Some of each stretch, and those
    just before and behind ends. Exact."""
    for (a, b), (c, d) in combinations(sides, 2):
        u = (b[0] - a[0], b[1] - a[1])
        v = (d[0] - c[0], d[1] - c[1])
        across = u[0] * (c[1] - a[1]) - u[1] * (c[0] - a[0])
        length = u[0] * u[0] + u[1] * u[1]
        if u[0] * v[1] != u[1] * v[0] or u[0] * v[0] + u[1] * v[1] > 0:
            continue
        if across <= 0 or across * across != 4 * square * length:
            continue
        first, last, *stops = (
            ((p[0] - a[0]) * u[0] + (p[1] - a[1]) * u[1]) / length
            for p in (d, c, *((Fraction(x), Fraction(y)) for x, y in ends))
        )
        low, high = max(first, Fraction(0)), min(last, Fraction(1))
        shares = [low + share * (high - low) for share in SHARES]
        shares += [stop + way * BEYOND for stop in stops for way in (-1, 1)]
        for t in shares:
            if not low < t < high:
                continue
            half = across / length / 2
            x = (a[0] + t * u[0] - half * u[1], a[1] + t * u[1] + half * u[0])
            if all(squared_distance(x, *side) >= square for side in sides):
                yield x


def sides_of(P: _core.PolygonSet) -> list[Side]:
    rings = [ring for polygon in P.rings() for ring in polygon]
    return [side for ring in rings for side in pairwise([*ring, ring[0]])]


def squared_distance(x: Place, a: Place, b: Place) -> Fraction:
    u, v = (b[0] - a[0], b[1] - a[1]), (x[0] - a[0], x[1] - a[1])
    length, along = u[0] * u[0] + u[1] * u[1], u[0] * v[0] + u[1] * v[1]
    t = min(max(along / length, Fraction(0)), Fraction(1))
    return (v[0] - t * u[0]) ** 2 + (v[1] - t * u[1]) ** 2


def to_segment(x: Spot, a: Spot, b: Spot) -> float:
    """Return the distance from a segment, or from a point if both ends are one."""
    (ux, uy), (vx, vy) = (b[0] - a[0], b[1] - a[1]), (x[0] - a[0], x[1] - a[1])
    length = ux * ux + uy * uy
    t = min(max((ux * vx + uy * vy) / length, 0.0), 1.0) if length else 0.0
    return math.hypot(vx - t * ux, vy - t * uy)
