"""A sum with a void: P plus a cube Q with a tetrahedral cavity. Exact.

The void holds every x for which x - sP fits into the cavity: n . x <= c + s m for each facet n . y
<= c of the cavity, with m the least n . p.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from itertools import combinations

from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.geometry.space import cross
from minkref.fuzz.judges.space import paper_space
from minkref.fuzz.space.meeting import Meeting
from minkref.reports.audit.bodies import Body, compatible_pairs, dot, hull, minus, support
from minkref.reports.audit.space import Facet, Vector, determinant, vector

P = hull([(1, -3, 2), (-1, 1, 3), (-3, -1, -2), (3, 2, 0)])
CAVITY = hull([(0, 0, 6), (6, 0, -5), (-4, 8, -4), (-4, -8, -4)])
SIDE = 20
CUBE = hull([(x, y, z) for x in (-SIDE, SIDE) for y in (-SIDE, SIDE) for z in (-SIDE, SIDE)])
Plane = tuple[Vector, Fraction, Fraction]  # n, m, c


def Q() -> Polyhedron:
    return CUBE.polyhedron.with_faces_of(CAVITY.polyhedron.turned_inside_out())


def in_sum(s: Fraction, x: Vector) -> bool:
    """Whether x lies in the closed sum, from the definition."""
    return Meeting(P.polyhedron, Q(), s).meets(x)


def planes() -> list[Plane]:
    return [
        (
            vector(n),
            Fraction(min(dot(n, p) for p in P.points)),
            Fraction(dot(n, CAVITY.points[facet[0]])),
        )
        for facet, n in zip(CAVITY.facets, CAVITY.normals, strict=True)
    ]


def corners(s: Fraction) -> list[Vector]:
    """Meeting points of three planes each, chosen from four, by Cramer's rule: the void's vertices
    while the void exists."""
    return [_meeting_point(chosen, s) for chosen in combinations(planes(), 3)]


def _meeting_point(three: Sequence[Plane], s: Fraction) -> Vector:
    (a, m, c), (b, k, d), (e, j, f) = three
    weights = (c + s * m, d + s * k, f + s * j)
    turned = (cross(b, e), cross(e, a), cross(a, b))
    x, y, z = (
        sum((w * t[i] for w, t in zip(weights, turned, strict=True)), Fraction(0)) for i in range(3)
    )
    den = determinant(a, b, e)
    return x / den, y / den, z / den


def slack(s: Fraction) -> Fraction:
    """The sum of l (c + s m), with weights l > 0 for which the sum of l n is zero. A negative
    result rules out a void for every x."""
    found = planes()
    total = Fraction(0)
    for k, (_, m, c) in enumerate(found):
        a, b, e = (n for i, (n, _, _) in enumerate(found) if i != k)
        total += abs(determinant(a, b, e)) * (c + s * m)
    return total


def inner_facets() -> list[Facet]:
    """Facets around the void: each cavity facet at P's farthest vertex along Q's normal, which
    points into the cavity."""
    return [
        _facet("vf", support(P.points, minus((0, 0, 0), n)), CAVITY, facet)
        for facet, n in zip(CAVITY.facets, CAVITY.normals, strict=True)
    ]


def outer_facets() -> list[Facet]:
    """Outer facets, from P and the cube. Raises ValueError if a facet has several vertices."""
    pairs = compatible_pairs(P, CUBE)
    if not pairs.unique:
        raise ValueError("a facet has several vertices")
    return [
        *(_facet("fv", f, CUBE, v) for f, v in zip(P.facets, pairs.fv, strict=True)),
        *(_facet("vf", v, CUBE, f) for f, v in zip(CUBE.facets, pairs.vf, strict=True)),
        *(_facet("ee", e, CUBE, g) for e, g in sorted(pairs.ee)),
    ]


def _facet(
    kind: str, p: Sequence[int] | frozenset[int], other: Body, q: Sequence[int] | frozenset[int]
) -> Facet:
    return Facet(
        kind, tuple(vector(P.points[k]) for k in p), tuple(vector(other.points[k]) for k in q)
    )


def pair_events(facets: Sequence[Facet]) -> set[Fraction]:
    """The scales at which a vertex comes to a facet, or two edges start or stop meeting, by the
    symbolic oracle."""
    vertices = {vertex for facet in facets for vertex in facet.vertices}
    edges = {
        frozenset((edge.start, edge.end)): edge for facet in facets for edge in facet.edges
    }.values()
    found = set()
    for facet in facets:
        for vertex in vertices:
            _, s, meet = paper_space.vertex_event(facet.numbers, vertex.numbers)
            if s is not None and s > 0 and meet:
                found.add(s)
    for a, b in combinations(edges, 2):
        bounds = paper_space.edge_contact(a.numbers, b.numbers)
        found |= {s for s in bounds or () if s is not None}
    return found
