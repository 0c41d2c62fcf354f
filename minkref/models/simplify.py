"""Rings with fewer vertices, still simple and disjoint, by integer arithmetic."""

from __future__ import annotations

import heapq
import itertools
from collections import defaultdict

from drawing import Ring

Point = tuple[int, int]


def cross(a: Point, b: Point, c: Point) -> int:
    """Compute twice the signed area of the triangle a b c."""
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def simplify(rings: list[Ring], vertices: int, least: int = 8) -> list[Ring]:
    """Cut rings down to `vertices` in total by dropping the vertex with the smallest triangle
    first.

    Drops a vertex only if its triangle holds no other vertex of any ring, so that simple disjoint
    rings stay so (Visvalingam & Whyatt 1993, with that guard). Every ring keeps at least `least`
    vertices. Raises ValueError if no further vertex can go.
    """
    points = [p for ring in rings for p in ring]
    before: list[int] = []
    after: list[int] = []
    owner: list[int] = []
    for number, ring in enumerate(rings):
        first, count = len(before), len(ring)
        for k in range(count):
            before.append(first + (k - 1) % count)
            after.append(first + (k + 1) % count)
            owner.append(number)
    size = 1 + max(
        abs(a[0] - b[0]) + abs(a[1] - b[1]) for r in rings for a, b in itertools.pairwise(r)
    )
    buckets: dict[Point, set[int]] = defaultdict(set)
    for k, (x, y) in enumerate(points):
        buckets[(x // size, y // size)].add(k)

    def empty(a: int, b: int, c: int) -> bool:
        corners = [points[a], points[b], points[c]]
        if cross(*corners) < 0:
            corners.reverse()
        columns = range(min(p[0] for p in corners) // size, max(p[0] for p in corners) // size + 1)
        rows = range(min(p[1] for p in corners) // size, max(p[1] for p in corners) // size + 1)
        for column in columns:
            for row in rows:
                for k in buckets.get((column, row), ()):
                    if k not in (a, b, c) and all(
                        cross(corners[i - 1], corners[i], points[k]) >= 0 for i in range(3)
                    ):
                        return False
        return True

    def weight(k: int) -> int:
        return abs(cross(points[before[k]], points[k], points[after[k]]))

    left = len(points)
    sizes = [len(ring) for ring in rings]
    alive = [True] * left
    current = [weight(k) for k in range(left)]
    queue = [(current[k], k) for k in range(left)]
    heapq.heapify(queue)
    while left > vertices:
        if not queue:
            raise ValueError(f"no vertex can be dropped at {left} vertices, {vertices} are wanted")
        value, k = heapq.heappop(queue)
        if not alive[k] or value != current[k] or sizes[owner[k]] <= least:
            continue
        a, c = before[k], after[k]
        if not empty(a, k, c):
            continue
        alive[k] = False
        buckets[(points[k][0] // size, points[k][1] // size)].discard(k)
        after[a], before[c] = c, a
        left -= 1
        sizes[owner[k]] -= 1
        for other in (a, c):
            current[other] = max(weight(other), value)
            heapq.heappush(queue, (current[other], other))
    return [
        [points[k] for k in range(len(points)) if alive[k] and owner[k] == number]
        for number in range(len(rings))
    ]


def faults(rings: list[Ring]) -> list[str]:
    """Find faults that keep the rings from bounding one polygon with holes; exact, all edge
    pairs."""
    found = []
    edges = [
        (number, k, ring[k], ring[(k + 1) % len(ring)])
        for number, ring in enumerate(rings)
        for k in range(len(ring))
    ]
    for number, ring in enumerate(rings):
        doubled = sum(
            a[0] * b[1] - a[1] * b[0] for a, b in zip(ring, ring[1:] + ring[:1], strict=True)
        )
        if (doubled > 0) != (number == 0):
            found.append(f"ring {number} turns the wrong way")
        for k in range(len(ring)):
            if cross(ring[k - 2], ring[k - 1], ring[k]) == 0:
                found.append(f"ring {number} is straight at vertex {(k - 1) % len(ring)}")
        if number and not _inside(rings[0], ring[0]):
            found.append(f"ring {number} lies outside the outer ring")
    edges.sort(key=lambda e: min(e[2][0], e[3][0]))
    for i, (ring_a, k_a, a, b) in enumerate(edges):
        right = max(a[0], b[0])
        for ring_b, k_b, c, d in edges[i + 1 :]:
            if min(c[0], d[0]) > right:
                break
            if max(a[1], b[1]) < min(c[1], d[1]) or max(c[1], d[1]) < min(a[1], b[1]):
                continue
            neighbours = ring_a == ring_b and (k_a - k_b) % len(rings[ring_a]) in (
                1,
                len(rings[ring_a]) - 1,
            )
            if not neighbours and _meet(a, b, c, d):
                found.append(f"edges {ring_a}:{k_a} and {ring_b}:{k_b} meet")
    return found


def _sign(value: int) -> int:
    return (value > 0) - (value < 0)


def _meet(a: Point, b: Point, c: Point, d: Point) -> bool:
    """Tell whether two closed segments with meeting boxes share a point."""
    return (
        _sign(cross(a, b, c)) * _sign(cross(a, b, d)) <= 0
        and _sign(cross(c, d, a)) * _sign(cross(c, d, b)) <= 0
    )


def _inside(ring: Ring, p: Point) -> bool:
    crossings = 0
    for a, b in zip(ring, ring[1:] + ring[:1], strict=True):
        if (a[1] > p[1]) != (b[1] > p[1]):
            crossings += (cross(a, b, p) > 0) == (b[1] > a[1])
    return crossings % 2 == 1
