"""A right adapter in the plane; unusual and faulty adapters override parts."""

from __future__ import annotations

from fractions import Fraction
from typing import Any, ClassVar

from conversation import Adapter, Answer, Rejected, Request
from minkref import BadInput, _core
from plane_sets import Polygon, Ring, polygons_of, set_of, sum_of

SETS = ["non-convex", "holes", "components", "touching", "empty", "point", "segment"]


class Plane(Adapter):
    """Exact sums, from nothing but the request and the last load."""

    declares: ClassVar[dict[str, Any]] = {"capabilities": ["plane", *SETS, "rational"]}

    def at(self, request: Request) -> Answer:
        return self.form(self.sum(request))

    def sum(self, request: Request) -> list[Polygon]:
        return sum_of(set_of(request["sP"]), set_of(self.Q))

    def form(self, polygons: list[Polygon]) -> Answer:
        return {
            "polygons": [
                {"outer": self.ring(outer), "holes": [self.ring(hole) for hole in holes]}
                for outer, holes in polygons
            ]
        }

    def ring(self, ring: Ring) -> list[list[Any]]:
        return [[self.number(x), self.number(y)] for x, y in ring]

    def number(self, value: Fraction) -> Any:
        return str(value)


class Rings(Plane):
    """Answers with a flat list of rings."""

    def form(self, polygons: list[Polygon]) -> Answer:
        return {"rings": [self.ring(ring) for ring in self.rings(polygons)]}

    def rings(self, polygons: list[Polygon]) -> list[Ring]:
        return [ring for outer, holes in polygons for ring in (outer, *holes)]


class Doubles(Plane):
    """Speaks JSON numbers, each coordinate of the exact sum rounded to the nearest double."""

    declares: ClassVar[dict[str, Any]] = {
        "arithmetic": "float64",
        "numbers": "double",
        "tolerance": {"absolute": "0", "relative": "1/4503599627370496"},
        "capabilities": ["plane", *SETS],
    }

    def number(self, value: Fraction) -> Any:
        return float(value)


class Updating(Plane):
    """`update` steps from the scale of the last answer by the reference's dynamic sum."""

    declares: ClassVar[dict[str, Any]] = {"capabilities": ["plane", *SETS, "rational", "update"]}

    def at(self, request: Request) -> Answer:
        self.scale = Fraction(request["scale"])
        return super().at(request)

    def update(self, request: Request) -> Answer:
        before, self.scale = self.scale, Fraction(request["scale"])
        P, Q = set_of(self.P), set_of(self.Q)
        if not (P.is_region or Q.is_region):
            return super().at(request)
        window = [str(end) for end in sorted((before, self.scale))]
        walk = _core.DynamicSum(P, Q, *window)
        walk.move_to(str(before))
        walk.move_to(str(self.scale))
        return self.form(polygons_of(walk.sum().region))


class Events(Plane):
    """`events` from the dynamic sum of the window."""

    declares: ClassVar[dict[str, Any]] = {"capabilities": ["plane", *SETS, "rational", "events"]}

    def events(self, request: Request) -> Answer:
        return {"scales": [self.number(scale) for scale in self.scales(request)]}

    def scales(self, request: Request) -> list[Fraction]:
        return sorted({Fraction(event[0]) for event in self.found(request)})

    def found(self, request: Request) -> list[Any]:
        P, Q = set_of(self.P), set_of(self.Q)
        if P.is_empty or Q.is_empty or not (P.is_region or Q.is_region):
            return []
        window = [
            None if request.get(end) is None else str(Fraction(request[end]))
            for end in ("from", "to")
        ]
        return _core.DynamicSum(P, Q, *window).topology_events()


class Refusing(Plane):
    """Rejects invalid input, at `load`."""

    declares: ClassVar[dict[str, Any]] = {
        "capabilities": ["plane", *SETS, "rational", "rejects-invalid"]
    }

    def load(self, request: Request) -> Answer:
        for operand in (request["P"], request["Q"]):
            self.look_at(operand)
        return super().load(request)

    def look_at(self, operand: Any) -> None:
        try:
            set_of(operand).validate()
        except (BadInput, ValueError, KeyError, TypeError, ZeroDivisionError) as refusal:
            raise Rejected(str(refusal)) from refusal
