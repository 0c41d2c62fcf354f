"""When facets and edges in space come together, by the symbolic oracle."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from minkref.oracle.symbolic.pairs import Interval
from minkref.oracle.symbolic.rational import text
from minkref.oracle.symbolic.space import space_events
from minkref.oracle.symbolic.space.space_moving import (
    MovingFacet,
    SpaceSegment,
    SpaceVertex,
    facet,
    vector,
)

Place = tuple[Fraction, Fraction, Fraction]
Vertex = tuple[Place, Place]  # p, q: the point s p + q
Edge = tuple[str, Vertex, Vertex]  # its kind, S, T or D (a parallelogram's diagonal); its ends
Facet = tuple[str, Sequence[Place], Sequence[Place]]  # fv, vf or ee; corners in P, in Q
Coming = tuple[str, Fraction | None, bool | None]
"""once, always or never, of positive scales; for once the scale, and whether the facets meet there
and not only their planes."""


def vertex_event(of: Facet, vertex: Vertex) -> Coming:
    return _coming(space_events.vertex_event(_facet(of), _vertex(vertex)))


def plane_event(a: Facet, b: Facet) -> Coming:
    """The event of two facets in parallel planes."""
    return _coming(space_events.plane_event(_facet(a), _facet(b)))


def four_event(facets: Sequence[Facet]) -> Coming:
    return _coming(space_events.four_event([_facet(each) for each in facets]))


def edge_contact(a: Edge, b: Edge) -> tuple[Fraction | None, Fraction | None] | None:
    """Bounds on the scales at which two S- or T-edges meet, None for 0 and for no end; None if they
    never meet."""
    return _interval(space_events.edge_contact(_edge(a), _edge(b)))


def facet_contact(a: Facet, b: Facet) -> list[tuple[Fraction | None, Fraction | None] | None]:
    """Bounds for two always coplanar facets, one interval after another."""
    return [_interval(each) for each in space_events.facet_contact(_facet(a), _facet(b))]


def lines_polynomial(a: Edge, b: Edge) -> list[Fraction]:
    """The polynomial at whose roots two edges' lines are coplanar; the highest power first."""
    return [Fraction(text(c)) for c in space_events.lines_polynomial(_edge(a), _edge(b))]


def _coming(found: space_events.Coming) -> Coming:
    return found.case, None if found.s is None else Fraction(text(found.s)), found.meet


def _interval(found: Interval | None) -> tuple[Fraction | None, Fraction | None] | None:
    if found is None:
        return None
    low, high = (
        None if bound is None else Fraction(text(bound)) for bound in (found.low, found.high)
    )
    return low, high


def _vertex(numbers: Vertex) -> SpaceVertex:
    return SpaceVertex(vector(numbers[0]), vector(numbers[1]))


def _edge(numbers: Edge) -> SpaceSegment:
    kind, start, end = numbers
    return SpaceSegment(kind, _vertex(start), _vertex(end))


def _facet(numbers: Facet) -> MovingFacet:
    return facet(*numbers)
