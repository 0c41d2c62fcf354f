"""Events of moving facets and edges in space: the scales at which planes or lines come together,
and whether the facets or edges themselves meet."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from itertools import product
from typing import Any

from ..pairs import Interval, end_conditions, end_meetings, intervals
from ..rational import Rational
from ..solutions import all_solutions, branch, compiled, root
from .space_moving import MovingFacet, SpaceSegment, SpaceVertex, Vector, cross, dot
from .space_standing import in_polygon, polygons_meet, shared


@dataclass(frozen=True, slots=True)
class Coming:
    """When planes come together: `case` once (at `s`), always or never (s None). `meet`: whether
    the facets themselves share a point at s; None unless `case` is once."""

    case: str
    s: Rational | None = None
    meet: bool | None = None
    at: Vector | None = None


@cache
def function(name: str, sizes: tuple[int, ...]) -> Any:
    found = all_solutions()[name]
    texts = found.get("coefficients") or (found["numerator"], found["denominator"])
    arguments = [f"{x}{i}" for x, size in zip("abcd", sizes, strict=False) for i in range(size)]
    return compiled(texts, arguments)


def vertex_event(facet: MovingFacet, vertex: SpaceVertex) -> Coming:
    """Find when a moving vertex lies in a facet's plane; `meet`: whether in the facet. Exact."""
    case, s = branch(*function("vertex in plane", (5, 6))(*facet.plane(), *vertex.p, *vertex.q))
    if s is None:
        return Coming(case)
    at = vertex.at(s)
    return Coming(case, s, in_polygon(at, facet.corners(s)), at)


def planes_parallel(first: MovingFacet, second: MovingFacet) -> bool:
    return not any(cross(first.plane()[:3], second.plane()[:3]))


def plane_event(first: MovingFacet, second: MovingFacet) -> Coming:
    """Find when parallel planes coincide; always: the facets are coplanar at every scale. Raises
    ValueError unless the planes are parallel. Exact."""
    if not planes_parallel(first, second):
        raise ValueError("the planes are not parallel")
    a, b = first.plane(), second.plane()
    ratio = dot(a[:3], a[:3]) / dot(a[:3], b[:3])
    case, s = branch(*function("parallel planes", (2, 2))(*a[3:], ratio * b[3], ratio * b[4]))
    if s is None:
        return Coming(case)
    return Coming(case, s, polygons_meet(first.corners(s), second.corners(s)))


def four_event(facets: Sequence[MovingFacet]) -> Coming:
    """Find when the planes of four facets, not all parallel to one direction, pass through one
    point; `meet`: whether all four facets contain the point. The determinant decides `always` and
    `never`. Raises ValueError for normals in one plane, which give no single point. Exact."""
    planes = [facet.plane() for facet in facets]
    free = [t for t in TRIPLES if dot(cross(planes[t[0]][:3], planes[t[1]][:3]), planes[t[2]][:3])]
    if len(planes) != 4 or not free:
        raise ValueError("four facets with normals in all directions are asked for")
    case, s = branch(*function("four planes", (5, 5, 5, 5))(*(x for p in planes for x in p)))
    if s is None:
        return Coming(case)
    at = common_point([planes[i] for i in free[0]], s)
    return Coming(case, s, all(in_polygon(at, facet.corners(s)) for facet in facets), at)


TRIPLES = ((0, 1, 2), (0, 1, 3), (0, 2, 3), (1, 2, 3))


def common_point(planes: Sequence[Vector], s: Rational) -> Vector:
    """Return the common point of three planes at scale s, by Cramer's rule."""
    n, h = [p[:3] for p in planes], [p[3] * s + p[4] for p in planes]
    weights = (cross(n[1], n[2]), cross(n[2], n[0]), cross(n[0], n[1]))
    return tuple(
        sum((h[k] * weights[k][i] for k in range(3)), Rational(0)) / dot(n[0], weights[0])
        for i in range(3)
    )


def lines_polynomial(first: SpaceSegment, second: SpaceSegment) -> list[Rational]:
    """Return the polynomial in s, highest power first, with the scales as roots at which two edges'
    lines are coplanar. Degree 1 for S- and T-edges, 2 with one diagonal of an ee-facet, 3 with two
    (leading zeros included)."""
    sizes = (len(first.data), len(second.data))
    name = f"lines {first.kind}{second.kind}"
    return list(function(name, sizes)(*first.data, *second.data))


def edge_contact(first: SpaceSegment, second: SpaceSegment) -> Interval | None:
    """Find all s > 0 at which two moving S- or T-edges share a point: exact.

    Candidates: the scale at which the lines are coplanar; and, for lines always coplanar, scales
    with an end on the other's line, which then holds for each projection."""
    slope, constant = lines_polynomial(first, second)
    marks = root(-constant, slope)
    kinds = first.kind + second.kind
    for data, other in zip(first.projections(), second.projections(), strict=True):
        marks += end_conditions(kinds, data + other) + end_meetings(kinds, data + other)
    found = list(intervals(marks, lambda s: shared(first.at(s), second.at(s)) is not None))
    assert len(found) <= 1, "the set of scales of contact is convex"
    return found[0] if found else None


def facet_contact(first: MovingFacet, second: MovingFacet) -> list[Interval]:
    """Find all s > 0 at which two always coplanar facets share a point, as maximal intervals.
    Contact begins and ends where sides' contact does. Raises ValueError for other facets. Exact."""
    if plane_event(first, second).case != "always":
        raise ValueError("the facets are not coplanar at all scales")
    marks = []
    for a, b in product(first.edges(), second.edges()):
        found = edge_contact(a, b)
        marks += [s for s in (found.low, found.high) if s is not None] if found else []
    return list(intervals(marks, lambda s: polygons_meet(first.corners(s), second.corners(s))))
