"""Events of three moving convex facets, and of four: they start or stop sharing a point, or share a
point at one scale. docs/definitions.md, In space.

The common point of three planes moves evenly; it may enter or leave a facet only on a plane
standing on a side, which is a condition on four planes. Facets that stand still show the change.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations

from ..pairs import intervals
from ..rational import Rational
from ..solutions import root
from .coplanar_triples import (
    TupleEvent,
    always_in_one_plane,
    coplanar_triple_events,
    through_one_point,
    walls,
)
from .facet_pairs import facet_events
from .space_events import common_point, four_event, planes_parallel
from .space_moving import MovingFacet, Plane, cross, dot
from .space_standing import in_polygon, shared, shared_by_polygons

Facets = Sequence[MovingFacet]


def triple_events(facets: Facets) -> list[TupleEvent]:
    """Find the events of three facets, ascending, except where two facets have an event at the same
    scale and point. Parallel facets count only if they are always coplanar. Exact."""
    if any(always_in_one_plane(a, b) for a, b in combinations(facets, 2)):
        return coplanar_triple_events(facets)
    if parallel_among(facets):
        return []
    planes = [facet.plane() for facet in facets]
    normals = [plane[:3] for plane in planes]
    if dot(cross(normals[0], normals[1]), normals[2]):
        found = _of_a_track(facets, planes)
    else:
        found = _of_a_line(facets, planes)
    return sorted(event for event in found if not _is_of_fewer(facets, 2, event))


def quadruple_event(facets: Facets) -> TupleEvent | None:
    """Find the event of four facets, no two parallel; None if fewer facets have an event at its
    scale and point. Exact."""
    normals = [facet.plane()[:3] for facet in facets]
    if not any(dot(cross(a, b), c) for a, b, c in combinations(normals, 3)):
        return None
    found = four_event(facets)
    if found.s is None or found.s <= 0 or not found.meet or found.at is None:
        return None
    event = TupleEvent(found.s, "touch", found.at)
    if _is_of_fewer(facets, 2, event) or _is_of_fewer(facets, 3, event):
        return None
    return event


def parallel_among(facets: Facets) -> bool:
    return any(planes_parallel(a, b) for a, b in combinations(facets, 2))


def _is_of_fewer(facets: Facets, count: int, event: TupleEvent) -> bool:
    """Tell whether `count` facets have an event at the same scale and point."""
    for some in combinations(facets, count):
        known: Sequence[object] = (
            facet_events(some[0], some[1]).events if count == 2 else triple_events(some)
        )
        if any((each.s, each.at) == (event.s, event.at) for each in known):  # type: ignore[attr-defined]
            return True
    return False


def _of_a_track(facets: Facets, planes: Sequence[Plane]) -> Iterator[TupleEvent]:
    found = [through_one_point([*planes, wall]) for facet in facets for wall in walls(facet)]
    marks = [s for s in found if s is not None]

    def member(s: Rational) -> bool:
        x = common_point(planes, s)
        return all(in_polygon(x, facet.corners(s)) for facet in facets)

    for interval in intervals(marks, member):
        low, high = interval.low, interval.high
        if low is not None and low == high:
            yield TupleEvent(low, "touch", common_point(planes, low))
            continue
        if low is not None:
            yield TupleEvent(low, "birth", common_point(planes, low))
        if high is not None:
            yield TupleEvent(high, "death", common_point(planes, high))


def _of_a_line(facets: Facets, planes: Sequence[Plane]) -> Iterator[TupleEvent]:
    """Find events where all planes are parallel to one line: unless always or never, they share a
    line at one scale, and the facets then perhaps a segment."""
    n = [plane[:3] for plane in planes]
    along = cross(n[0], n[1])
    a, b = (dot(cross(u, v), along) / dot(along, along) for u, v in ((n[2], n[1]), (n[0], n[2])))
    slope, height = (planes[2][k] - a * planes[0][k] - b * planes[1][k] for k in (3, 4))
    for s in root(-height, slope):
        if s <= 0:
            continue
        of_two = [shared_by_polygons(facets[k].corners(s), facets[2].corners(s)) for k in (0, 1)]
        if of_two[0] is None or of_two[1] is None:
            continue
        of_three = shared(of_two[0], of_two[1])
        for x in dict.fromkeys(of_three or ()):
            yield TupleEvent(s, "touch", x)
