"""Remnants of a sum of two sets of lines in plain fractions, from the flat sums and the region."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Sequence
from fractions import Fraction
from itertools import pairwise

from minkref.oracle.slow.place import inside, on_boundary

Point = tuple[Fraction, Fraction]
Way = tuple[Point, Point]  # from the smaller to the larger point
Rings = Sequence[Sequence[Point]]


def flat_remnants(flat: Iterable[Sequence[Point]], rings: Rings) -> list[list[Point]]:
    """List the maximal polylines and points of what flat sums, each given by points on a line, have
    beside a region. Canonical: docs/definitions.md, "Tight passages", "Pieces". Exact."""
    ends = [(min(points), max(points)) for points in flat]
    long = [(a, b) for a, b in set(ends) if a != b]
    sides = [way for ring in rings for way in pairwise([*ring, ring[0]])]
    bare: set[Way] = set()
    for way in long:
        stops = sorted({*way, *(x for other in [*long, *sides] for x in meetings(way, other))})
        bare |= {(a, b) for a, b in pairwise(stops) if not is_in(rings, middle(a, b))}
    alone = {a for a, b in ends if a == b and not is_in(rings, a)}
    return sorted([*polylines(bare), *([x] for x in alone if not any(is_on(x, w) for w in bare))])


def polylines(ways: Iterable[Way]) -> list[list[Point]]:
    """Join segments, which meet at ends only, wherever exactly two meet."""
    at: dict[Point, set[Point]] = defaultdict(set)
    for a, b in ways:
        at[a].add(b)
        at[b].add(a)
    found = []
    # Closed polylines come last, from the smallest point.
    for start in [*sorted(x for x in at if len(at[x]) != 2), *sorted(at)]:
        while at[start]:
            line = [start]
            here = min(at[start])
            while True:
                line.append(here)
                at[line[-2]].discard(here)
                passed = len(at[here]) == 2
                at[here].discard(line[-2])
                if not passed or here == start:
                    break
                (here,) = at[here]
            found.append(canonical(line))
    return found


def canonical(line: list[Point]) -> list[Point]:
    """Drop straight points, and take the smaller of both directions."""
    bends = [b for a, b, c in zip(line, line[1:], line[2:], strict=False) if turn(a, b, c)]
    points = [line[0], *bends, line[-1]]
    return min(points, points[::-1])


def meetings(way: Way, other: Way) -> list[Point]:
    """List the points of a segment where it meets another one, or where an overlap ends."""
    (a, b), (c, d) = way, other
    u, v = minus(b, a), minus(d, c)
    if across := u[0] * v[1] - u[1] * v[0]:
        w = minus(c, a)
        s, t = (w[0] * v[1] - w[1] * v[0]) / across, (w[0] * u[1] - w[1] * u[0]) / across
        met = 0 <= s <= 1 and 0 <= t <= 1
        return [(a[0] + s * u[0], a[1] + s * u[1])] if met else []
    return [x for x in other if is_on(x, way)]


def is_in(rings: Rings, point: Point) -> bool:
    return on_boundary(rings, point) or inside(rings, point)


def is_on(point: Point, way: Way) -> bool:
    return turn(*way, point) == 0 and way[0] <= point <= way[1]


def middle(a: Point, b: Point) -> Point:
    return (a[0] + b[0]) / 2, (a[1] + b[1]) / 2


def minus(b: Point, a: Point) -> Point:
    return b[0] - a[0], b[1] - a[1]


def turn(a: Point, b: Point, c: Point) -> Fraction:
    (ux, uy), (vx, vy) = minus(b, a), minus(c, b)
    return ux * vy - uy * vx
