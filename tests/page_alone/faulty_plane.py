"""Faulty adapters in the plane: each is right but for the fault that its first line states."""

from __future__ import annotations

import random
from fractions import Fraction
from typing import Any

from conversation import Answer, Request
from minkref import _core
from plane_adapter import Doubles, Plane
from plane_sets import (
    Polygon,
    Ring,
    cross,
    edges_of,
    hull,
    polygons_of,
    rings_of,
    set_of,
    set_of_rings,
    sum_of,
    trapezoids,
    twice_area,
)


class Faulty(Plane):
    """Has the operands of a request and the exact sum at hand."""

    def sum(self, request: Request) -> list[Polygon]:
        P, Q = set_of(request["sP"]), set_of(self.Q)
        return self.spoilt(P, Q, sum_of(P, Q))

    def spoilt(
        self, P: _core.PolygonSet, Q: _core.PolygonSet, found: list[Polygon]
    ) -> list[Polygon]:
        raise NotImplementedError


def without_holes(found: list[Polygon], lost: Any) -> list[Polygon]:
    return [(outer, [hole for hole in holes if not lost(hole)]) for outer, holes in found]


def first_vertex_moved(found: list[Polygon], by: Any) -> list[Polygon]:
    if not found:
        return found
    (x, y), *rest = found[0][0]
    return [([(by(x), y), *rest], found[0][1]), *found[1:]]


def a_corner_cut(found: list[Polygon]) -> list[Polygon]:
    """The first outer ring without one of its convex vertices."""
    if not found or len(found[0][0]) < 4:
        return found
    return [(found[0][0][1:], found[0][1]), *found[1:]]


def vertices(*operands: _core.PolygonSet) -> int:
    return sum(operand.vertices for operand in operands)


class SmallHolesLost(Faulty):
    """Holes of an area below 1/4 are lost."""

    def spoilt(self, P: Any, Q: Any, found: list[Polygon]) -> list[Polygon]:
        return without_holes(found, lambda hole: abs(twice_area(hole)) < Fraction(1, 2))


class PinchedHolesLost(Faulty):
    """Holes that touch another ring of the sum are lost."""

    def spoilt(self, P: Any, Q: Any, found: list[Polygon]) -> list[Polygon]:
        corners = [p for ring in rings_of(found) for p in ring]
        twice = {p for p in corners if corners.count(p) > 1} if len(corners) < 900 else set()
        return without_holes(found, lambda hole: any(p in twice for p in hole))


class HoleInvented(Faulty):
    """A sum of more than twenty vertices gets one more hole, of a ten-thousandth of a piece."""

    def spoilt(self, P: Any, Q: Any, found: list[Polygon]) -> list[Polygon]:
        if len([p for ring in rings_of(found) for p in ring]) <= 20:
            return found
        piece = max(trapezoids(rings_of(found)), key=twice_area)
        x, y = (sum(p[axis] for p in piece) / len(piece) for axis in range(2))
        small = [(x + (a - x) / 100, y + (b - y) / 100) for a, b in piece]
        return polygons_of(set_of_rings([small[::-1], *rings_of(found)]))


class LastComponentLost(Faulty):
    """Of three components or more the last is lost."""

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
    """A hole of Q with a reflex vertex loses it: the hole is taken as its hull."""

    def spoilt(self, P: Any, Q: Any, found: list[Polygon]) -> list[Polygon]:
        rings = [(o, [hull(h)[::-1] for h in holes]) for o, holes in polygons_of(Q)]
        return sum_of(P, set_of_rings(rings_of(rings))) if Q.is_region else found


class HullOfStars(Faulty):
    """The hull in place of the sum where P is not convex and Q is."""

    def spoilt(self, P: Any, Q: Any, found: list[Polygon]) -> list[Polygon]:
        rings = [rings_of(polygons_of(operand)) for operand in (P, Q)]
        convex = [len(one) == 1 and len(hull(one[0])) == len(one[0]) for one in rings]
        if convex == [False, True] and found:
            return [(hull([p for ring in rings_of(found) for p in ring]), [])]
        return found


class BillionthOff(Faulty):
    """One vertex is off by 1e-9."""

    def spoilt(self, P: Any, Q: Any, found: list[Polygon]) -> list[Polygon]:
        return first_vertex_moved(found, lambda x: x - Fraction(1, 10**9))


class UlpOff(Faulty):
    """One vertex is a double next to the exact number."""

    def spoilt(self, P: Any, Q: Any, found: list[Polygon]) -> list[Polygon]:
        return first_vertex_moved(found, lambda x: x - abs(x) / 2**52)


class WrongWhereParallel(Faulty):
    """A corner is cut where an edge of P has the direction of one of Q, if there are more than ten."""

    def spoilt(self, P: Any, Q: Any, found: list[Polygon]) -> list[Polygon]:
        ways = [
            {direction(a, b) for a, b in edges_of(rings_of(polygons_of(one)))} for one in (P, Q)
        ]
        return a_corner_cut(found) if len(ways[0] & ways[1]) > 1 else found


def direction(a: Any, b: Any) -> tuple[Fraction, Fraction]:
    x, y = b[0] - a[0], b[1] - a[1]
    size = abs(x) + abs(y)
    return (x / size, y / size) if size else (x, y)


class WrongWhenCritical(Plane):
    """At the scale of a topology event the sum of a scale a little above."""

    def sum(self, request: Request) -> list[Polygon]:
        P, Q, s = set_of(self.P), set_of(self.Q), request["scale"]
        if (P.is_region or Q.is_region) and vertices(P, Q) < 60:
            events = _core.DynamicSum(P, Q, s, s).topology_events()
            if events:
                return sum_of(P.scaled(str(Fraction(s) * Fraction(1025, 1024))), Q)
        return super().sum(request)


class CutTo200Bits(Faulty):
    """Integers beyond 2^200 are cut to 200 bits."""

    def spoilt(self, P: Any, Q: Any, found: list[Polygon]) -> list[Polygon]:
        return first_vertex_moved(
            found, lambda x: x if abs(x) < 2**200 else x * (1 - Fraction(1, 2**200))
        )


class SmallIsZero(Faulty):
    """Coordinates of the sum below 2^-60 are taken as zero."""

    def spoilt(self, P: Any, Q: Any, found: list[Polygon]) -> list[Polygon]:
        tiny = Fraction(1, 2**60)
        cut = [
            [tuple(n if abs(n) >= tiny else Fraction(0) for n in p) for p in ring]
            for ring in rings_of(found)
        ]
        return polygons_of(set_of_rings(cut))


class WrongAbove80(Faulty):
    """A corner is cut where the operands have more than 80 vertices."""

    def spoilt(self, P: Any, Q: Any, found: list[Polygon]) -> list[Polygon]:
        return a_corner_cut(found) if vertices(P, Q) > 80 else found


class WrongAbove250(Faulty):
    """A corner is cut where the operands have more than 250 vertices."""

    def spoilt(self, P: Any, Q: Any, found: list[Polygon]) -> list[Polygon]:
        return a_corner_cut(found) if vertices(P, Q) > 250 else found


class TouchingHoleForgotten(Faulty):
    """A hole of Q that touches another ring of Q is filled."""

    def spoilt(self, P: Any, Q: Any, found: list[Polygon]) -> list[Polygon]:
        if not Q.is_region:
            return found
        polygons = polygons_of(Q)
        corners = [p for ring in rings_of(polygons) for p in ring]
        kept = without_holes(polygons, lambda hole: any(corners.count(p) > 1 for p in hole))
        return sum_of(P, set_of_rings(rings_of(kept)))


class PinchedHolesInQ(Faulty):
    """Of two holes of the sum that touch each other the smaller is filled."""

    def spoilt(self, P: Any, Q: Any, found: list[Polygon]) -> list[Polygon]:
        kept = []
        for outer, holes in found:
            held: list[Ring] = []
            for hole in sorted(holes, key=lambda ring: twice_area(ring)):
                if not any(p in other for p in hole for other in held):
                    held.append(hole)
            kept.append((outer, held))
        return kept


class PointForgotten(Faulty):
    """A point as Q is not added."""

    def spoilt(self, P: Any, Q: Any, found: list[Polygon]) -> list[Polygon]:
        return polygons_of(P) if Q.is_point and P.is_region else found


class SegmentAsItsEnds(Faulty):
    """A segment is taken as its two ends."""

    def spoilt(self, P: Any, Q: Any, found: list[Polygon]) -> list[Polygon]:
        for one, other in ((P, Q), (Q, P)):
            if one.is_segment and other.is_region:
                ends = rings_of(polygons_of(one))[0]
                moved = [other.translated(str(x), str(y)) for x, y in ends]
                return polygons_of(
                    set_of_rings([r for m in moved for r in rings_of(polygons_of(m))])
                )
        return found


class EmptyCrashes(Faulty):
    """An empty operand ends the program."""

    def spoilt(self, P: Any, Q: Any, found: list[Polygon]) -> list[Polygon]:
        if P.is_empty or Q.is_empty:
            raise SystemExit(11)
        return found


class HangsOnManyHoles(Faulty):
    """Never answers where both operands have holes."""

    def spoilt(self, P: Any, Q: Any, found: list[Polygon]) -> list[Polygon]:
        while all(any(holes for _, holes in polygons_of(operand)) for operand in (P, Q)):
            pass
        return found


class ByChance(Faulty):
    """One of eight answers with a hole has lost it, by chance."""

    def spoilt(self, P: Any, Q: Any, found: list[Polygon]) -> list[Polygon]:
        return without_holes(found, lambda hole: random.randrange(8) == 0)


class SimplifiesALittle(Faulty):
    """Vertices at a thousandth from the line of their neighbours are dropped."""

    def spoilt(self, P: Any, Q: Any, found: list[Polygon]) -> list[Polygon]:
        return [(straight(outer), holes) for outer, holes in found]


def straight(ring: Ring) -> Ring:
    kept = [
        b
        for a, b, c in zip(ring[-1:] + ring[:-1], ring, ring[1:] + ring[:1], strict=True)
        if abs(cross(a, b, c)) * 1000 >= max(abs(c[0] - a[0]), abs(c[1] - a[1]))
    ]
    return kept if len(kept) > 2 else ring


class StaleOperand(Plane):
    """Where a new Q has as many vertices as the last one, the last one stays."""

    def load(self, request: Request) -> Answer:
        before = getattr(self, "Q", None)
        super().load(request)
        if before and set_of(before).vertices == set_of(self.Q).vertices > 8:
            self.Q = before
        return {}


class TooRough(Doubles):
    """Rounds to seven digits and promises twelve."""

    def hello(self) -> Answer:
        return {**super().hello(), "tolerance": {"absolute": "0", "relative": "1e-12"}}

    def number(self, value: Fraction) -> Any:
        return float(f"{float(value):.7g}")


class LongNumbersInWords(Plane):
    """Numbers of more than twenty digits are written as decimals, rounded."""

    def number(self, value: Fraction) -> Any:
        text = str(value)
        return text if len(text) <= 20 else str(Fraction(f"{float(value):.12e}"))
