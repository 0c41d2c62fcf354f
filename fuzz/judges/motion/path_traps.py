"""Traps by static means: an enclosing ring that the part's place cannot cross, or a way out."""

from __future__ import annotations

import heapq
from collections.abc import Sequence
from fractions import Fraction
from itertools import pairwise
from math import hypot

from minkref import _core
from minkref.fuzz.geometry.plane import Point, fraction_rings
from minkref.fuzz.motion.path_collisions import Collisions, by_triangles

MOST_TRIES = 40


def enclosing_ring(
    part: _core.PolygonSet, obstacles: _core.PolygonSet, at: Point, scale: Fraction
) -> list[Point] | None:
    """Returns a hole of the closed sum around an outside place: the hole's ring belongs to the sum,
    and leads around the place. None if no single ring does."""
    turned = part.scaled("-1")
    region = _core.minkowski_sum(turned, obstacles, str(scale), "definition").region
    for ring in fraction_rings(region.canonical_json()):
        if _doubled_area(ring) < 0 and _winding(ring, at) != 0:
            return list(ring)
    return None


def way_out(
    part: _core.PolygonSet, obstacles: _core.PolygonSet, at: Point, scale: Fraction
) -> list[Point] | None:
    """A polyline from the place to a point beyond the sum's box, along which interiors never meet:
    it follows vertices of the sum that see each other in doubles, and is then proven as a whole,
    from the definition. None if none was found."""
    turned = part.scaled("-1")
    region = _core.minkowski_sum(turned, obstacles, str(scale), "definition").region
    rings = fraction_rings(region.canonical_json())
    corners = [p for ring in rings for p in ring]
    far = max(abs(Fraction(c)) for p in (*corners, at) for c in p) + 1
    box = [(-far, -far), (far, -far), (far, far), (-far, far)]
    nodes: list[Point] = [at, *corners, *box]
    walls = [
        (_near(a), _near(b))
        for ring in rings
        for a, b in zip(ring, ring[1:] + ring[:1], strict=True)
    ]
    decide = by_triangles(part, obstacles)
    closed: set[tuple[int, int]] = set()
    for _ in range(MOST_TRIES):
        way = _shortest(nodes, len(box), walls, closed)
        if way is None:
            return None
        fault = next(
            (
                (i, j)
                for i, j in pairwise(way)
                if Collisions(part, obstacles, [nodes[i], nodes[j]]).collides(
                    scale, "allowed", decide
                )
            ),
            None,
        )
        if fault is None:
            return [nodes[k] for k in way]
        closed |= {fault, fault[::-1]}
    return None


Near = tuple[float, float]


def _near(p: Point) -> Near:
    return float(p[0]), float(p[1])


def _shortest(
    nodes: Sequence[Point],
    goals: int,
    walls: Sequence[tuple[Near, Near]],
    closed: set[tuple[int, int]],
) -> list[int] | None:
    """The way from the first node to one of the last `goals`, through pairs with no wall
    between."""
    near = [_near(p) for p in nodes]
    best, before, queue = {0: 0.0}, {0: 0}, [(0.0, 0)]
    done: set[int] = set()
    while queue:
        length, k = heapq.heappop(queue)
        if k in done:
            continue
        done.add(k)
        if k >= len(nodes) - goals:
            way = [k]
            while way[-1] != 0:
                way.append(before[way[-1]])
            return way[::-1]
        for other in range(len(nodes)):
            if other in done or (k, other) in closed:
                continue
            step = length + hypot(near[other][0] - near[k][0], near[other][1] - near[k][1])
            if step < best.get(other, float("inf")) and not _blocked(near[k], near[other], walls):
                best[other], before[other] = step, k
                heapq.heappush(queue, (step, other))
    return None


def _blocked(a: Near, b: Near, walls: Sequence[tuple[Near, Near]]) -> bool:
    """Whether a wall crosses the segment well within both: a guess, in doubles."""

    def side(p: Near, q: Near, r: Near) -> float:
        return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])

    small = 1e-9 * (1 + hypot(b[0] - a[0], b[1] - a[1]))
    for p, q in walls:
        own = side(a, b, p), side(a, b, q)
        other = side(p, q, a), side(p, q, b)
        if min(own) < -small and max(own) > small and min(other) < -small and max(other) > small:
            return True
    return False


def _doubled_area(ring: Sequence[Point]) -> Fraction:
    turned = zip(ring, [*ring[1:], ring[0]], strict=True)
    return Fraction(sum(a[0] * b[1] - a[1] * b[0] for a, b in turned))


def _winding(ring: Sequence[Point], x: Point) -> int:
    """The winding number of a ring around a point off the ring."""
    number = 0
    for a, b in zip(ring, [*ring[1:], ring[0]], strict=True):
        if (a[1] <= x[1]) != (b[1] <= x[1]):
            side = (b[0] - a[0]) * (x[1] - a[1]) - (b[1] - a[1]) * (x[0] - a[0])
            if (side > 0) == (b[1] > a[1]):
                number += 1 if b[1] > a[1] else -1
    return number
