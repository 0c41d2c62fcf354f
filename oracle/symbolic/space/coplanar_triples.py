"""Events of three moving convex facets, two or all of them coplanar at all scales: a side of each
coplanar facet passes through one common point. docs/definitions.md, In space.

The planes standing on two such sides, the facets' plane, and the third facet's plane or its side's
standing plane come to pass through one point: a condition on four planes. Facets that stand still
show the change there.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations, product

from ..rational import Rational, cells
from ..solutions import branch
from .facet_pairs import facet_events
from .space_events import TRIPLES, common_point, function, plane_event, planes_parallel
from .space_moving import MovingFacet, Plane, SpaceVertex, Vector, cross, dot
from .space_standing import in_polygon, shared, shared_by_convex, shared_by_polygons

Facets = Sequence[MovingFacet]


@dataclass(frozen=True, slots=True, order=True)
class TupleEvent:
    """At scale s and the point `at`; `change` birth, death, touch or, if two facets are coplanar,
    pass."""

    s: Rational
    change: str
    at: Vector


def always_in_one_plane(first: MovingFacet, second: MovingFacet) -> bool:
    return planes_parallel(first, second) and plane_event(first, second).case == "always"


def coplanar_triple_events(facets: Facets) -> list[TupleEvent]:
    """Find the events, ascending, except where two of the three have an event at the same scale and
    point. Exact. Raises ValueError unless two facets are coplanar."""
    flat = [pair for pair in combinations(range(3), 2) if always_in_one_plane(*_two(facets, pair))]
    if not flat:
        raise ValueError("no two of the facets lie in one plane at all scales")
    if len(flat) == 3:
        return _events(facets, None)
    (pair,) = flat
    (across,) = {0, 1, 2} - set(pair)
    ordered = [facets[pair[0]], facets[pair[1]], facets[across]]
    return [] if planes_parallel(ordered[0], ordered[2]) else _events(ordered[:2], ordered[2])


def walls(facet: MovingFacet) -> Iterator[Plane]:
    """Yield the planes standing on the sides."""
    normal = facet.plane()[:3]
    for side in facet.edges():
        start: SpaceVertex = side.start
        n = cross(normal, side.direction())
        yield (*n, dot(n, start.p), dot(n, start.q))


def through_one_point(planes: Sequence[Plane]) -> Rational | None:
    """Find the only scale at which four planes pass through one point, if any."""
    case, s = branch(*function("four planes", (5, 5, 5, 5))(*(x for p in planes for x in p)))
    return s if case == "once" else None


def _two(facets: Facets, pair: tuple[int, int]) -> tuple[MovingFacet, MovingFacet]:
    return facets[pair[0]], facets[pair[1]]


def _events(flat: Facets, across: MovingFacet | None) -> list[TupleEvent]:
    """Find events of coplanar facets, with or without a facet across."""
    every = [*flat, *([] if across is None else [across])]
    plane = flat[0].plane()
    found: set[tuple[Rational, Vector]] = set()
    for sides in product(*(list(walls(facet)) for facet in flat)):
        planes = [plane, *sides, *([] if across is None else [across.plane()])]
        s = through_one_point(planes)
        if s is None or s <= 0:
            continue
        some = next(
            [planes[k] for k in t]
            for t in TRIPLES
            if dot(cross(planes[t[0]][:3], planes[t[1]][:3]), planes[t[2]][:3])
        )
        x = common_point(some, s)
        if all(in_polygon(x, facet.corners(s)) for facet in every):
            found.add((s, x))
    of_pairs = {(e.s, e.at) for a, b in combinations(every, 2) for e in facet_events(a, b).events}
    return sorted(
        TupleEvent(s, change, x)
        for s, change, x in _changes(sorted(found), [s for s, _ in of_pairs], every)
        if (s, x) not in of_pairs
    )


def _changes(
    found: list[tuple[Rational, Vector]], others: list[Rational], every: Facets
) -> Iterator[tuple[Rational, str, Vector]]:
    """Name each change by whether all share points just below and just above: nothing happens
    between events."""
    ordered, inner = cells([s for s, _ in found] + others)
    names = {
        (True, True): "pass", (False, True): "birth", (True, False): "death",
        (False, False): "touch",
    }  # fmt: skip
    for s, x in found:
        k = ordered.index(s)
        yield s, names[_share(every, inner[k]), _share(every, inner[k + 1])], x


def _share(every: Facets, s: Rational) -> bool:
    """Tell whether three facets share a point at a scale, the first two coplanar."""
    corners = [facet.corners(s) for facet in every]
    if planes_parallel(every[0], every[2]):
        return bool(shared_by_convex(corners))
    segments = [shared_by_polygons(own, corners[2]) for own in corners[:2]]
    if segments[0] is None or segments[1] is None:
        return False
    return shared(segments[0], segments[1]) is not None
