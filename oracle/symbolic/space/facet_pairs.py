"""Events of two moving convex facets: their common segment is born, dies, or turns one of its ends.
docs/definitions.md, In space.

The derived solutions give the possible scales: a corner on a plane, two coplanar sides. Facets that
stand still show the change, at each such scale and between scales; the common segment's ends move
evenly between.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import product

from ..pairs import end_conditions, end_meetings
from ..rational import Rational, cells
from ..solutions import root
from .space_events import lines_polynomial, plane_event, planes_parallel, vertex_event
from .space_moving import MovingFacet, SpaceSegment, Vector, cross, minus
from .space_standing import Segment3, on_segment, polygons_meet, share_an_area, shared_by_polygons


@dataclass(frozen=True, slots=True, order=True)
class FacetEvent:
    """At scale s and the point `at`: `kind` vertex (a corner of a facet), edge (sides of both) or
    parallel (an area, without a point); `change` birth, death, touch or pass."""

    s: Rational
    kind: str
    change: str
    at: Vector | None


@dataclass(frozen=True, slots=True)
class FacetEvents:
    """The events, and how the planes stand. `standing`: "once", "always" or "never" if parallel
    planes coincide so; else "crossing". `degenerate`: scales coincide, or something always
    touches."""

    standing: str
    events: tuple[FacetEvent, ...]
    degenerate: bool


def facet_events(first: MovingFacet, second: MovingFacet) -> FacetEvents:
    """Find all events with s > 0, ascending. Exact."""
    if planes_parallel(first, second):
        coming = plane_event(first, second)
        if coming.case == "always":
            return FacetEvents("always", tuple(sorted(_in_one_plane(first, second))), True)
        found = () if coming.s is None or coming.s <= 0 else tuple(_once(first, second, coming.s))
        return FacetEvents(coming.case, found, True)
    marks, always = _marks(first, second)
    positive = [s for s in marks if s > 0]
    degenerate = always or len(set(positive)) < len(positive)
    return FacetEvents("crossing", tuple(sorted(_crossing(first, second, positive))), degenerate)


def _marks(first: MovingFacet, second: MovingFacet) -> tuple[list[Rational], bool]:
    """Find scales at which something may happen, and tell whether something always touches."""
    marks, always = [], False
    for facet, other in ((first, second), (second, first)):
        for vertex in other.vertices():
            coming = vertex_event(facet, vertex)
            always |= coming.case == "always"
            marks += [] if coming.s is None else [coming.s]
    for a, b in product(first.edges(), second.edges()):
        slope, constant = lines_polynomial(a, b)
        marks += root(-constant, slope)
        if slope == 0 and constant == 0:
            always = True
            marks += _ends_on_lines(a, b)
    return marks, always


def _ends_on_lines(a: SpaceSegment, b: SpaceSegment) -> list[Rational]:
    marks = []
    for data, other in zip(a.projections(), b.projections(), strict=True):
        marks += end_conditions(a.kind + b.kind, data + other)
        marks += end_meetings(a.kind + b.kind, data + other)
    return marks


def _crossing(
    first: MovingFacet, second: MovingFacet, marks: list[Rational]
) -> Iterator[FacetEvent]:
    def shared(s: Rational) -> Segment3 | None:
        found = shared_by_polygons(first.corners(s), second.corners(s))
        return found and _along(first, second, found)

    ordered, inner = cells(marks)
    here, between = [shared(s) for s in ordered], [shared(s) for s in inner]
    for i, s in enumerate(ordered):
        at, below, above = here[i], between[i], between[i + 1]
        if at is None:
            continue
        change = _change(below is not None, above is not None)
        corners = {*first.corners(s), *second.corners(s)}
        for end, x in enumerate(dict.fromkeys(at)):
            if change == "pass" and below is not None and above is not None:
                sides = range(2) if at[0] == at[1] else (end,)
                if all(_straight(below[k], inner[i], x, s, above[k], inner[i + 1]) for k in sides):
                    continue
            yield FacetEvent(s, "vertex" if x in corners else "edge", change, x)


def _along(first: MovingFacet, second: MovingFacet, found: Segment3) -> Segment3:
    """Order the ends along the planes' common line, whose direction never changes."""
    direction = cross(first.plane()[:3], second.plane()[:3])
    ends = sorted(found, key=lambda x: sum(a * b for a, b in zip(x, direction, strict=True)))
    return ends[0], ends[1]


def _straight(a: Vector, r: Rational, x: Vector, s: Rational, b: Vector, t: Rational) -> bool:
    """Tell whether a point at a, x, b at the scales r < s < t may move evenly."""
    before = [(y - z) / (s - r) for y, z in zip(x, a, strict=True)]
    return before == [(y - z) / (t - s) for y, z in zip(b, x, strict=True)]


def _change(below: bool, above: bool) -> str:
    return {(True, True): "pass", (False, True): "birth", (True, False): "death"}.get(
        (below, above), "touch"
    )


def _once(first: MovingFacet, second: MovingFacet, s: Rational) -> Iterator[FacetEvent]:
    """Find the event where the planes coincide at this scale."""
    f, g = first.corners(s), second.corners(s)
    if polygons_meet(f, g):
        yield FacetEvent(s, "parallel" if share_an_area(f, g) else "vertex", "touch", None)


def _in_one_plane(first: MovingFacet, second: MovingFacet) -> Iterator[FacetEvent]:
    """Find the events of always coplanar facets: corners come to lie on sides."""
    marks = [s for a, b in product(first.edges(), second.edges()) for s in _ends_on_lines(a, b)]
    found: dict[Rational, set[Vector]] = {}
    for s in cells(marks)[0]:
        for facet, other in ((first, second), (second, first)):
            for vertex, side in product(other.vertices(), facet.edges()):
                x = vertex.at(s)
                if on_segment(x, side.at(s)) and not _on_line(vertex.at(s + 1), side.at(s + 1)):
                    found.setdefault(s, set()).add(x)
    ordered, inner = cells(found)
    meet = [polygons_meet(first.corners(s), second.corners(s)) for s in inner]
    for i, s in enumerate(ordered):
        for x in found[s]:
            yield FacetEvent(s, "vertex", _change(meet[i], meet[i + 1]), x)


def _on_line(x: Vector, segment: Segment3) -> bool:
    return not any(cross(minus(segment[1], segment[0]), minus(x, segment[0])))
