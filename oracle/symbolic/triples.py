"""When three moving segments share a point, and where two of them swap along the third.

Three lines pass through one point at one scale, at none or at all. The segments' own scales begin
and end there, or where two segments start or stop meeting.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations, product

from .moving import MovingSegment, Point, parallel
from .pairs import Event, Interval, candidates, intervals
from .rational import Rational, cells
from .solutions import root, solution
from .standing import Common, common, common_to_three, minus

Triple = tuple[MovingSegment, MovingSegment, MovingSegment]


def concurrency(triple: Triple) -> list[Rational]:
    """Find the isolated scale, if any, at which the three lines pass through one point."""
    ordered = sorted(triple, key=lambda segment: segment.kind)
    kinds = "".join(segment.kind for segment in ordered)
    data = (number for segment in ordered for number in segment.data)
    return root(*solution(f"triple {kinds}", "abc")(*data))


def turning_points(triple: Triple) -> list[Rational]:
    """Find all scales between which nothing changes: neither which segments meet nor their
    order."""
    pairs = combinations(triple, 2)
    return concurrency(triple) + [s for a, b in pairs for s in candidates(a, b)]


def shared_at(triple: Triple, s: Rational) -> Common:
    return common_to_three(*(segment.at(s) for segment in triple))


def meeting_scales(triple: Triple) -> list[Interval]:
    """Find all s > 0 at which three moving segments share a point, as maximal intervals, ascending;
    an isolated scale gives an interval with equal ends. Exact; constant time."""
    return list(intervals(turning_points(triple), lambda s: shared_at(triple, s) is not None))


def swaps(triple: Triple) -> Iterator[tuple[Event, int]]:
    """Find where two segments swap along the third: the three share a point, and just below and
    just above both other segments meet the third, each at one point, in opposite orders. Adds the
    third's place (0, 1, 2) to each event. Ascending; exact; constant time."""
    marks, inner = cells(turning_points(triple))
    for i, mark in enumerate(marks):
        shared = shared_at(triple, mark)
        if shared is None or shared[0] != shared[1]:
            continue
        for third in range(3):
            before, after = (order_along(triple, third, s) for s in (inner[i], inner[i + 1]))
            if before * after < 0:
                yield Event(mark, "swap", shared[0]), third


def triple_events(triple: Triple) -> list[Event]:
    """Find the triple events of three segments: one per scale at which any two swap along the
    third. docs/definitions.md, Critical scales."""
    return list(dict.fromkeys(event for event, _ in swaps(triple)))


def ends_passed(triple: Triple) -> Iterator[tuple[Event, int]]:
    """Find where two segments pass each other along the third, with one or both always on the
    third's line: both meet the third just below, at and just above the scale, a segment on the line
    along a whole segment, whose end passes the other's place or end, inside the third. Adds the
    third's place to each event.

    The order of a point and a segment that the point enters is only a convention, so this stays
    apart from `swaps`. The first two begin or end contact there, or have a swap of their own.
    Ascending for each third; exact."""
    for third, (one, other) in ((0, (1, 2)), (1, (0, 2)), (2, (0, 1))):
        first, second, along = triple[one], triple[other], triple[third]
        if not (parallel(first, along) or parallel(second, along)):
            continue
        marks, inner = cells(turning_points(triple))
        for i, mark in enumerate(marks):
            sides = [inner[i], mark, inner[i + 1]]
            a, b = ([reach(x, along, s) for s in sides] for x in (first, second))
            if not all(a) or not all(b):
                continue
            passed = set()
            # The ends keep their order along the third at every scale.
            for m, n in product((0, 1), repeat=2):
                below, there, above = (x[m] - y[n] for x, y in zip(a, b, strict=True))
                # Where the third ends, the shared part ends too: no end of either segment.
                within = all(0 < x[k] < 1 for k, x in ((m, a[0]), (m, a[2]), (n, b[0]), (n, b[2])))
                if there == 0 and below * above < 0 and within:
                    passed.add(place(along, a[1][m], mark))
            for at in sorted(passed):
                yield Event(mark, "swap", at), third


def reach(segment: MovingSegment, along: MovingSegment, s: Rational) -> list[Rational]:
    """Return both ends of two segments' common part, as parameters on `along`; or nothing."""
    shared = common(segment.at(s), along.at(s))
    if shared is None:
        return []
    start, end = along.at(s)
    d = minus(end, start)
    found = [minus(x, start) for x in shared]
    return [(x[0] * d[0] + x[1] * d[1]) / (d[0] * d[0] + d[1] * d[1]) for x in found]


def place(along: MovingSegment, t: Rational, s: Rational) -> Point:
    start, end = along.at(s)
    return start[0] + t * (end[0] - start[0]), start[1] + t * (end[1] - start[1])


def order_along(triple: Triple, third: int, s: Rational) -> int:
    """Return 1, -1 or 0: whether the first of the two others meets segment `third` farther along,
    nearer, or at the same point; also 0 unless each meets the third in one point at scale s."""
    along = triple[third]
    places: list[Point] = []
    for index, other in enumerate(triple):
        if index == third:
            continue
        shared = common(other.at(s), along.at(s))
        if shared is None or parallel(other, along):
            return 0
        places.append(shared[0])
    d = along.direction()
    ahead = (places[0][0] - places[1][0]) * d[0] + (places[0][1] - places[1][1]) * d[1]
    return (ahead > 0) - (ahead < 0)
