"""Paths by tests of convex pieces, for libraries that tell whether two convex bodies meet.

Part and obstacles are cut into convex polygons (Shapely's constrained Delaunay triangulation, which
makes no vertex). A piece that goes along a segment sweeps the hull of both its places. Each hull
and each obstacle become prisms of one height, which meet iff the polygons do.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from fractions import Fraction
from itertools import pairwise, product
from typing import Any

import shapely  # type: ignore[import-not-found,import-untyped,unused-ignore]

Ring = list[tuple[float, float]]
Set = dict[str, Any]
Meets = Callable[[Any, Any], bool]


def path_of(body_of: Callable[[Ring], Any], meets: Meets) -> Callable[..., dict[str, Any]]:
    """Answers the verb `path`: `body_of` makes a body of a convex ring, counter-clockwise. Bodies
    that touch may count as either."""

    def answer(P: Set, Q: Set, request: dict[str, Any]) -> dict[str, Any]:
        part, walls = list(pieces_of(P)), [body_of(ring) for ring in pieces_of(Q)]
        places = request["path"]
        ways = list(pairwise(places)) or [(places[0], places[0])]

        def passes(scale: float) -> bool:
            swept = (body_of(_swept(ring, scale, *way)) for way, ring in product(ways, part))
            return not any(meets(body, wall) for body in swept for wall in walls)

        return {"valid": [passes(float(Fraction(scale))) for scale in request["scales"]]}

    return answer


def prism_of(ring: Ring) -> tuple[list[tuple[float, float, float]], list[list[int]]]:
    """Vertices and faces of the ring between the heights -1 and 1, seen from outside
    counter-clockwise."""
    n = len(ring)
    vertices = [(x, y, z) for z in (-1.0, 1.0) for x, y in ring]
    sides = [[k, (k + 1) % n, n + (k + 1) % n, n + k] for k in range(n)]
    return vertices, [list(range(n))[::-1], list(range(n, 2 * n)), *sides]


def pieces_of(value: Set) -> Iterator[Ring]:
    """Convex polygons that cover a set; a convex one as it is."""
    for polygon in value["polygons"]:
        outer = [(float(x), float(y)) for x, y in polygon["outer"]]
        if not polygon["holes"] and len(_hull(outer)) == len(outer):
            yield outer
            continue
        whole = shapely.Polygon(outer, polygon["holes"])
        for triangle in shapely.constrained_delaunay_triangles(whole).geoms:
            yield _hull([(x, y) for x, y in triangle.exterior.coords])


def _swept(ring: Ring, scale: float, a: list[float], b: list[float]) -> Ring:
    return _hull([(scale * x + c, scale * y + d) for c, d in (a, b) for x, y in ring])


def _hull(points: Ring) -> Ring:
    """The corners of the hull, counter-clockwise."""
    ordered = sorted(set(points))

    def half(some: Ring) -> Ring:
        found: Ring = []
        for p in some:
            while len(found) > 1 and not _turns_left(found[-2], found[-1], p):
                found.pop()
            found.append(p)
        return found[:-1]

    return half(ordered) + half(ordered[::-1])


def _turns_left(a: tuple[float, float], b: tuple[float, float], c: tuple[float, float]) -> bool:
    return (b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0]) > 0
