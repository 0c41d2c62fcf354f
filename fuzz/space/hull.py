"""The exact convex hull of points in space, with coplanar triangles merged to faces."""

from __future__ import annotations

import random
from collections.abc import Iterable

from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.geometry.space import (
    Point,
    Scale,
    Whole,
    cross,
    denominator_of,
    dot,
    factors,
    minus,
    normal,
    primitive,
    whole,
)
from minkref.plane.rings import from_least

Triple = tuple[int, int, int]


def convex_hull(points: Iterable[Point]) -> Polyhedron:
    """Returns the hull, its vertices the extreme points in ascending order. Duplicates, collinear
    and coplanar points are legal; ValueError if all are coplanar. Incremental: O(n f) for f
    faces."""
    given = sorted(set(points))
    denominator = denominator_of(given)
    wholes = [whole(point, denominator) for point in given]
    rings = _facets(wholes, _triangles(wholes))
    used = sorted({index for ring in rings for index in ring})
    name = {index: place for place, index in enumerate(used)}
    return Polyhedron(
        tuple(given[index] for index in used),
        tuple(sorted(tuple(name[index] for index in from_least(ring)) for ring in rings)),
    )


def sum_of_convex(P: Polyhedron, Q: Polyhedron, scale: Scale) -> Polyhedron:
    """Returns sP + Q for convex operands: the hull of all vertex sums."""
    a, b, c = factors(scale)
    return convex_hull(
        (a * p[0] + q[0], b * p[1] + q[1], c * p[2] + q[2]) for p in P.vertices for q in Q.vertices
    )


def is_convex(polyhedron: Polyhedron) -> bool:
    """Whether no vertex lies outside a face's plane."""
    points = polyhedron.wholes
    for i, j, k in polyhedron.triangles:
        n = normal(points[i], points[j], points[k])
        height = dot(n, points[i])
        if any(dot(n, point) > height for point in points):
            return False
    return True


def _triangles(points: list[Whole]) -> list[Triple]:
    """Returns a triangulated hull. A new point that sees some triangle replaces all triangles that
    it sees or that are coplanar with it; then every new triangle has area."""
    start = _start(points)
    planes: dict[Triple, tuple[Whole, int]] = {}

    def add(i: int, j: int, k: int) -> None:
        n = normal(points[i], points[j], points[k])
        planes[(i, j, k)] = (n, dot(n, points[i]))

    a, b, c, d = start
    if dot(normal(points[a], points[b], points[c]), minus(points[d], points[a])) > 0:
        b, c = c, b
    for triple in ((a, b, c), (a, c, d), (c, b, d), (b, a, d)):
        add(*triple)
    order = [k for k in range(len(points)) if k not in start]
    random.Random(len(points)).shuffle(order)
    for k in order:
        x, y, z = points[k]
        sees = False
        facing = []
        for triple, (n, height) in planes.items():
            side = n[0] * x + n[1] * y + n[2] * z - height
            if side >= 0:
                facing.append(triple)
                sees = sees or side > 0
        if not sees:
            continue
        edges = {edge for u, v, w in facing for edge in ((u, v), (v, w), (w, u))}
        for triple in facing:
            del planes[triple]
        for i, j in sorted(edges):
            if (j, i) not in edges:
                add(i, j, k)
    return list(planes)


def _start(points: list[Whole]) -> tuple[int, int, int, int]:
    """Finds four points that are not coplanar, or raises ValueError."""
    count = len(points)
    flat = ValueError("the points have no convex hull with volume: they lie in one plane")
    if count < 4:
        raise flat
    first, last = 0, count - 1
    direction = minus(points[last], points[first])
    third = next(
        (k for k in range(count) if cross(direction, minus(points[k], points[first])) != (0, 0, 0)),
        None,
    )
    if third is None:
        raise flat
    n = normal(points[first], points[last], points[third])
    height = dot(n, points[first])
    fourth = next((k for k in range(count) if dot(n, points[k]) != height), None)
    if fourth is None:
        raise flat
    return first, last, third, fourth


def _facets(points: list[Whole], triples: list[Triple]) -> list[list[int]]:
    """The rings around all triangles of a plane."""
    planes: dict[tuple[Whole, int], set[tuple[int, int]]] = {}
    for i, j, k in triples:
        n = primitive(normal(points[i], points[j], points[k]))
        edges = planes.setdefault((n, dot(n, points[i])), set())
        edges.update(((i, j), (j, k), (k, i)))
    rings = []
    for edges in planes.values():
        onward = {i: j for i, j in edges if (j, i) not in edges}
        start = min(onward)
        ring = [start]
        while onward[ring[-1]] != start:
            ring.append(onward[ring[-1]])
        rings.append(ring)
    return rings
