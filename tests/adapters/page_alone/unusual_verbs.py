"""Right adapters in the plane for `update`, `events` and invalid input."""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Any, ClassVar

from conversation import Answer, Request
from plane_adapter import SETS, Doubles, Events, Plane, Refusing, Updating

HALF = Fraction(1, 2)


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
        nearest = [(s, float(s)) for s in super().scales(request)]
        return [d if d > s else math.nextafter(d, math.inf) for s, d in nearest]


class EventsDown(EventsNearest):
    """Scales as the next double below."""

    def scales(self, request: Request) -> list[Any]:
        nearest = [(s, float(s)) for s in super().scales(request)]
        return [d if d < s else math.nextafter(d, 0) for s, d in nearest]


class EventsAbsolute(Events):
    """Rounds scales to multiples of a thousandth, within a declared absolute tolerance."""

    declares: ClassVar[dict[str, Any]] = {
        "arithmetic": "fixed-point",
        "tolerance": {"absolute": "1/1000", "relative": "0"},
        "capabilities": ["plane", *SETS, "rational", "events"],
    }

    def scales(self, request: Request) -> list[Fraction]:
        return sorted({Fraction(round(s * 1000), 1000) for s in super().scales(request)})


class RejectsAtLoad(Refusing):
    """`load` rejects invalid operands."""


class RejectsAtSum(Refusing):
    """`at` rejects invalid operands."""

    def load(self, request: Request) -> Answer:
        return Plane.load(self, request)

    def at(self, request: Request) -> Answer:
        for operand in (request["sP"], self.Q):
            self.look_at(operand)
        return super().at(request)


class EventsByRelative(Events):
    """Scales cut to five digits, by a relative tolerance."""

    declares: ClassVar[dict[str, Any]] = {
        "arithmetic": "decimal",
        "tolerance": {"absolute": "0", "relative": "1/10000"},
        "capabilities": ["plane", *SETS, "rational", "events"],
    }

    def scales(self, request: Request) -> list[Fraction]:
        return sorted({Fraction(f"{float(scale):.5g}") for scale in super().scales(request)})


class UpdatesInDoubles(Updating, Doubles):
    """Updates exactly, answers the nearest doubles."""

    declares: ClassVar[dict[str, Any]] = {
        **Doubles.declares,
        "capabilities": ["plane", *SETS, "update"],
    }
