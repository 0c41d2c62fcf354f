"""Right adapters in the plane, each with one habit that the page allows."""

from __future__ import annotations

import math
import random
from fractions import Fraction
from typing import Any, ClassVar

from conversation import Answer, Request
from plane_adapter import SETS, Doubles, Events, Plane, Refusing, Rings, Updating
from plane_sets import (
    Polygon,
    Ring,
    boundary_sum,
    grown,
    polygons_of,
    rings_of,
    set_of,
    shrunk,
    sum_of,
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
    """The same set by other rings each time it is asked: order, start and cuts by chance."""

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
    """The middle of each side is a vertex."""

    def ring(self, ring: Ring) -> list[list[Any]]:
        ends = zip(ring, ring[1:] + ring[:1], strict=True)
        middles = [((a[0] + b[0]) / 2, (a[1] + b[1]) / 2) for a, b in ends]
        return super().ring([p for pair in zip(ring, middles, strict=True) for p in pair])


class OddSpellings(Plane):
    """Fractions that are not in lowest terms, JSON integers, a negative zero."""

    def number(self, value: Fraction) -> Any:
        if value == 0:
            return random.choice(["0", 0, "-0", "0/7"])
        if value.denominator == 1 and random.random() < HALF:
            return value.numerator
        return f"{value.numerator * 6}/{value.denominator * 6}"


class OddDoubles(Doubles):
    """Doubles as `1.5E+00`, `-0.0`, integers where they are whole."""

    def number(self, value: Fraction) -> Any:
        near = float(value)
        if near == 0:
            return -0.0
        return int(near) if near.is_integer() and abs(near) < 2**70 else near


class AllOut(Plane):
    """The sum grown by nine tenths of the absolute tolerance."""

    declares: ClassVar[dict[str, Any]] = {
        "arithmetic": "directed",
        "tolerance": {"absolute": "1/1000", "relative": "0"},
        **Plane.declares,
    }
    by = Fraction(9, 10000)

    def sum(self, request: Request) -> list[Polygon]:
        return grown(super().sum(request), self.by)


class AllIn(AllOut):
    """The sum shrunk by nine tenths of the absolute tolerance."""

    def sum(self, request: Request) -> list[Polygon]:
        return shrunk(Plane.sum(self, request), self.by)


class RelativeOut(Plane):
    """The sum grown by nine tenths of the relative tolerance, a decimal."""

    declares: ClassVar[dict[str, Any]] = {
        "arithmetic": "directed",
        "tolerance": {"absolute": "0", "relative": "0.0001"},
        **Plane.declares,
    }

    def sum(self, request: Request) -> list[Polygon]:
        P, Q = set_of(request["sP"]), set_of(self.Q)
        sizes = [
            max([abs(n) for ring in rings_of(polygons_of(one)) for p in ring for n in p], default=0)
            for one in (P, Q)
        ]
        return grown(super().sum(request), Fraction(9, 100000) * sum(sizes))


class GridOfBits(Plane):
    """Takes 24 bits, answers whole or not."""

    declares: ClassVar[dict[str, Any]] = {
        "arithmetic": "integer-grid",
        "grid": {"bits": 24},
        "tolerance": {"absolute": "0", "relative": "0"},
        "capabilities": ["plane", *SETS],
    }


class GridOfUnits(Plane):
    """Takes multiples of a hundredth up to a million, rounds to a thousandth."""

    declares: ClassVar[dict[str, Any]] = {
        "arithmetic": "integer-grid",
        "grid": {"unit": "1/100", "largest": "1e6"},
        "tolerance": {"absolute": "0.0005", "relative": "0"},
        "capabilities": ["plane", *SETS, "rational"],
    }

    def number(self, value: Fraction) -> Any:
        return str(Fraction(round(value * 1000), 1000))


class SumOfBoundaries(Rings):
    """All p + q of the boundaries."""

    declares: ClassVar[dict[str, Any]] = {"sum": "boundary", **Plane.declares}

    def at(self, request: Request) -> Answer:
        pair = [rings_of(polygons_of(set_of(one))) for one in (request["sP"], self.Q)]
        from plane_sets import set_of_rings

        return self.form(polygons_of(set_of_rings(boundary_sum(*pair))))


class ClosedSets(Plane):
    """Keeps parts without area: points and segments where the sum is one."""

    declares: ClassVar[dict[str, Any]] = {"sets": "closed", **Plane.declares}

    def sum(self, request: Request) -> list[Polygon]:
        P, Q = set_of(request["sP"]), set_of(self.Q)
        found = super().sum(request)
        if found or P.is_empty or Q.is_empty:
            return found
        ends = [rings_of(polygons_of(one))[0] for one in (P, Q)]
        points = sorted((a[0] + b[0], a[1] + b[1]) for a in ends[0] for b in ends[1])
        return [(sorted({points[0], points[-1]}), [])]


class UpdatesFromState(Updating):
    """Steps from scale to scale."""


class EventsExact(Events):
    """All scales at which the topology changes, exactly."""


class EventsNearest(Events, Doubles):
    """Scales as the nearest doubles."""

    declares: ClassVar[dict[str, Any]] = {
        **Doubles.declares,
        "capabilities": ["plane", *SETS, "events"],
    }


class EventsUp(EventsNearest):
    """Scales as the next double above."""

    def scales(self, request: Request) -> list[Any]:
        return [math.nextafter(float(s), math.inf) for s in super().scales(request)]


class EventsDown(EventsNearest):
    """Scales as the next double below."""

    def scales(self, request: Request) -> list[Any]:
        return [math.nextafter(float(s), 0) for s in super().scales(request)]


class EventsAbsolute(Events):
    """Scales rounded to multiples of a thousandth, by an absolute tolerance."""

    declares: ClassVar[dict[str, Any]] = {
        "arithmetic": "fixed-point",
        "tolerance": {"absolute": "1/1000", "relative": "0"},
        "capabilities": ["plane", *SETS, "rational", "events"],
    }

    def scales(self, request: Request) -> list[Fraction]:
        return sorted({Fraction(round(s * 1000), 1000) for s in super().scales(request)})


class RejectsAtLoad(Refusing):
    """Invalid operands are rejected by `load`."""


class RejectsAtSum(Refusing):
    """Invalid operands are rejected by `at`."""

    def load(self, request: Request) -> Answer:
        return Plane.load(self, request)

    def at(self, request: Request) -> Answer:
        for operand in (request["sP"], self.Q):
            self.look_at(operand)
        return super().at(request)


class ScalesItself(Plane):
    """Takes P and the scale, and leaves sP alone."""

    def sum(self, request: Request) -> list[Polygon]:
        return sum_of(set_of(self.P).scaled(request["scale"]), set_of(self.Q))


class ScalesItselfInDoubles(Doubles):
    """Takes P and the scale, a text also for one that speaks doubles, and rounds the sum once."""

    declares: ClassVar[dict[str, Any]] = {
        **Doubles.declares,
        "tolerance": {"absolute": "1e-300", "relative": "1e-15"},
    }

    def sum(self, request: Request) -> list[Polygon]:
        return sum_of(set_of(self.P).scaled(request["scale"]), set_of(self.Q))
