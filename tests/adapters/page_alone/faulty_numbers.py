"""Faulty adapters in the plane: numbers, sizes, special positions and operands."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from conversation import Answer, Request
from faulty_sum import Faulty, a_corner_cut, first_vertex_moved, vertices
from minkref import _core
from plane_adapter import Doubles, Plane
from plane_sets import (
    Polygon,
    Ring,
    cross,
    edges_of,
    polygons_of,
    rings_of,
    set_of,
    set_of_rings,
    sum_of,
)


class BillionthOff(Faulty):
    """Moves one vertex by 1e-9."""

    def spoilt(self, P: Any, Q: Any, found: list[Polygon]) -> list[Polygon]:
        return first_vertex_moved(found, lambda x: x - Fraction(1, 10**9))


class UlpOff(Faulty):
    """Writes one vertex as a double next to the exact number."""

    def spoilt(self, P: Any, Q: Any, found: list[Polygon]) -> list[Polygon]:
        return first_vertex_moved(found, lambda x: x - abs(x) / 2**52)


class WrongWhereParallel(Faulty):
    """Cuts a corner if two edge directions of P are also directions of Q."""

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
    """Rounds coordinates of the sum below 2^-60 to zero."""

    def spoilt(self, P: Any, Q: Any, found: list[Polygon]) -> list[Polygon]:
        tiny = Fraction(1, 2**60)
        cut = [
            [tuple(n if abs(n) >= tiny else Fraction(0) for n in p) for p in ring]
            for ring in rings_of(found)
        ]
        return polygons_of(set_of_rings(cut))


class WrongAbove80(Faulty):
    """Cuts a corner if the operands have more than 80 vertices."""

    def spoilt(self, P: Any, Q: Any, found: list[Polygon]) -> list[Polygon]:
        return a_corner_cut(found) if vertices(P, Q) > 80 else found


class WrongAbove250(Faulty):
    """Cuts a corner if the operands have more than 250 vertices."""

    def spoilt(self, P: Any, Q: Any, found: list[Polygon]) -> list[Polygon]:
        return a_corner_cut(found) if vertices(P, Q) > 250 else found


class PointForgotten(Faulty):
    """A point as Q is not added."""

    def spoilt(self, P: Any, Q: Any, found: list[Polygon]) -> list[Polygon]:
        return polygons_of(P) if Q.is_point and P.is_region else found


class SegmentAsItsEnds(Faulty):
    """Takes a segment for its two ends."""

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
    """Keeps the last Q if a new Q has as many vertices."""

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
    """Writes numbers of more than twenty digits as rounded decimals."""

    def number(self, value: Fraction) -> Any:
        text = str(value)
        return text if len(text) <= 20 else str(Fraction(f"{float(value):.12e}"))
