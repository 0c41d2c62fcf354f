"""Faulty adapters in the plane: holes, components, reflex vertices."""

from __future__ import annotations

import random
from fractions import Fraction
from typing import Any

from faulty_sum import Faulty, without_holes
from minkref import _core
from plane_sets import (
    Polygon,
    Ring,
    cross,
    hull,
    polygons_of,
    rings_of,
    set_of_rings,
    sum_of,
    trapezoids,
    twice_area,
)


class SmallHolesLost(Faulty):
    """Loses holes with an area below 1/4."""

    def spoilt(self, P: Any, Q: Any, found: list[Polygon]) -> list[Polygon]:
        return without_holes(found, lambda hole: abs(twice_area(hole)) < Fraction(1, 2))


class PinchedHolesLost(Faulty):
    """Loses holes that touch another ring of the sum."""

    def spoilt(self, P: Any, Q: Any, found: list[Polygon]) -> list[Polygon]:
        corners = [p for ring in rings_of(found) for p in ring]
        twice = {p for p in corners if corners.count(p) > 1} if len(corners) < 900 else set()
        return without_holes(found, lambda hole: any(p in twice for p in hole))


class PinchedHolesInQ(Faulty):
    """Fills the smaller one where two holes of the sum touch."""

    def spoilt(self, P: Any, Q: Any, found: list[Polygon]) -> list[Polygon]:
        kept = []
        for outer, holes in found:
            held: list[Ring] = []
            for hole in sorted(holes, key=lambda ring: twice_area(ring)):
                if not any(p in other for p in hole for other in held):
                    held.append(hole)
            kept.append((outer, held))
        return kept


class TouchingHoleForgotten(Faulty):
    """Fills a hole of Q that touches another ring of Q."""

    def spoilt(self, P: Any, Q: Any, found: list[Polygon]) -> list[Polygon]:
        if not Q.is_region:
            return found
        polygons = polygons_of(Q)
        corners = [p for ring in rings_of(polygons) for p in ring]
        kept = without_holes(polygons, lambda hole: any(corners.count(p) > 1 for p in hole))
        return sum_of(P, set_of_rings(rings_of(kept)))


class HoleInvented(Faulty):
    """Adds a hole, a ten-thousandth of a piece, to each sum with more than twenty vertices."""

    def spoilt(self, P: Any, Q: Any, found: list[Polygon]) -> list[Polygon]:
        if len([p for ring in rings_of(found) for p in ring]) <= 20:
            return found
        piece = max(trapezoids(rings_of(found)), key=twice_area)
        x, y = (sum(p[axis] for p in piece) / len(piece) for axis in range(2))
        small = [(x + (a - x) / 100, y + (b - y) / 100) for a, b in piece]
        return polygons_of(set_of_rings([small[::-1], *rings_of(found)]))


class LastComponentLost(Faulty):
    """Loses the last of three or more components."""

    def spoilt(self, P: Any, Q: Any, found: list[Polygon]) -> list[Polygon]:
        return found[:-1] if len(found) > 2 else found


class OneReflexVertexForgotten(Faulty):
    """An operand with a single reflex vertex is taken as its hull."""

    def spoilt(self, P: Any, Q: Any, found: list[Polygon]) -> list[Polygon]:
        return sum_of(filled(P), filled(Q))


def filled(operand: _core.PolygonSet) -> _core.PolygonSet:
    rings = rings_of(polygons_of(operand))
    if len(rings) != 1 or len(rings[0]) < 4:
        return operand
    ring = rings[0]
    turns = [cross(ring[k - 2], ring[k - 1], ring[k]) for k in range(len(ring))]
    return set_of_rings([hull(ring)]) if sum(turn < 0 for turn in turns) == 1 else operand


class ConvexHoles(Faulty):
    """Replaces a hole of Q that has a reflex vertex with its hull."""

    def spoilt(self, P: Any, Q: Any, found: list[Polygon]) -> list[Polygon]:
        rings = [(o, [hull(h)[::-1] for h in holes]) for o, holes in polygons_of(Q)]
        return sum_of(P, set_of_rings(rings_of(rings))) if Q.is_region else found


class HullOfStars(Faulty):
    """Answers the hull instead of the sum if P is not convex and Q is."""

    def spoilt(self, P: Any, Q: Any, found: list[Polygon]) -> list[Polygon]:
        rings = [rings_of(polygons_of(operand)) for operand in (P, Q)]
        convex = [len(one) == 1 and len(hull(one[0])) == len(one[0]) for one in rings]
        if convex == [False, True] and found:
            return [(hull([p for ring in rings_of(found) for p in ring]), [])]
        return found


class HangsOnManyHoles(Faulty):
    """Never answers where both operands have holes."""

    def spoilt(self, P: Any, Q: Any, found: list[Polygon]) -> list[Polygon]:
        while all(any(holes for _, holes in polygons_of(operand)) for operand in (P, Q)):
            pass
        return found


class ByChance(Faulty):
    """Loses the holes of one answer in eight, by chance."""

    def spoilt(self, P: Any, Q: Any, found: list[Polygon]) -> list[Polygon]:
        return without_holes(found, lambda hole: random.randrange(8) == 0)
