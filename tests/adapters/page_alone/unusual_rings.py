"""Right adapters in the plane with unusual cuts, orders and orientations of rings."""

from __future__ import annotations

import random
from fractions import Fraction
from typing import Any, ClassVar

from conversation import Answer, Request
from plane_adapter import Plane, Rings
from plane_sets import (
    Polygon,
    Ring,
    boundary_sum,
    polygons_of,
    rings_of,
    set_of,
    set_of_rings,
    trapezoids,
)

HALF = Fraction(1, 2)


def turned(ring: Ring, by: int) -> Ring:
    return ring[by % len(ring) :] + ring[: by % len(ring)]


class RingsStartElsewhere(Plane):
    """Rings start at another vertex, polygons and holes are in another order."""

    def form(self, polygons: list[Polygon]) -> Answer:
        moved = [
            (turned(outer, len(outer) // 2), [turned(hole, 1) for hole in holes[::-1]])
            for outer, holes in polygons[::-1]
        ]
        return super().form(moved)


class RingsReversed(Plane):
    """Outer rings run clockwise, holes counter-clockwise."""

    def ring(self, ring: Ring) -> list[list[Any]]:
        return super().ring(ring[::-1])


class AnotherFormEachTime(Plane):
    """The same set by other rings at each request: order, start and cuts by chance."""

    def form(self, polygons: list[Polygon]) -> Answer:
        if random.random() < HALF:
            return {"rings": [self.ring(ring) for ring in trapezoids(rings_of(polygons))]}
        random.shuffle(polygons)
        return super().form([(turned(o, random.randrange(len(o))), h) for o, h in polygons])


class Triangles(Plane):
    """Polygons that are triangles."""

    def form(self, polygons: list[Polygon]) -> Answer:
        pieces = trapezoids(rings_of(polygons))
        fans = [[r[0], r[k], r[k + 1]] for r in pieces for k in range(1, len(r) - 1)]
        return super().form([(ring, []) for ring in fans])


class AbuttingTrapezoids(Rings):
    """Flat rings: convex pieces side by side."""

    def rings(self, polygons: list[Polygon]) -> list[Ring]:
        return trapezoids(rings_of(polygons))


class OverlappingPieces(Rings):
    """Flat rings, the set and its pieces once more; no word of exactness."""

    declares: ClassVar[dict[str, Any]] = {"arithmetic": "rational", **Plane.declares}

    def rings(self, polygons: list[Polygon]) -> list[Ring]:
        return super().rings(polygons) + trapezoids(rings_of(polygons))


class FlatRings(Rings):
    """Flat rings, holes clockwise, holes first."""

    def rings(self, polygons: list[Polygon]) -> list[Ring]:
        return super().rings(polygons)[::-1]


class CollinearVertices(Plane):
    """Adds each side's middle as a vertex."""

    def ring(self, ring: Ring) -> list[list[Any]]:
        ends = zip(ring, ring[1:] + ring[:1], strict=True)
        middles = [((a[0] + b[0]) / 2, (a[1] + b[1]) / 2) for a, b in ends]
        return super().ring([p for pair in zip(ring, middles, strict=True) for p in pair])


class SumOfBoundaries(Rings):
    """All p + q of the boundaries."""

    declares: ClassVar[dict[str, Any]] = {"sum": "boundary", **Plane.declares}

    def at(self, request: Request) -> Answer:
        pair = [rings_of(polygons_of(set_of(one))) for one in (request["sP"], self.Q)]
        return self.form(polygons_of(set_of_rings(boundary_sum(*pair))))


class ClosedSets(Plane):
    """Keeps sums without area: points and segments."""

    declares: ClassVar[dict[str, Any]] = {"sets": "closed", **Plane.declares}

    def sum(self, request: Request) -> list[Polygon]:
        P, Q = set_of(request["sP"]), set_of(self.Q)
        found = super().sum(request)
        if found or P.is_empty or Q.is_empty:
            return found
        ends = [rings_of(polygons_of(one))[0] for one in (P, Q)]
        points = sorted((a[0] + b[0], a[1] + b[1]) for a in ends[0] for b in ends[1])
        return [(sorted({points[0], points[-1]}), [])]


class ExactOverlapping(OverlappingPieces):
    """Flat rings that overlap, and exact."""

    declares: ClassVar[dict[str, Any]] = Plane.declares
