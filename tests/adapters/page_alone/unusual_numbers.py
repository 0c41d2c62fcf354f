"""Right adapters in the plane with numbers, tolerances and grids of their own."""

from __future__ import annotations

import random
from fractions import Fraction
from typing import Any, ClassVar

from conversation import Request
from plane_adapter import SETS, Doubles, Plane
from plane_sets import Polygon, grown, polygons_of, rings_of, set_of, shrunk, sum_of

HALF = Fraction(1, 2)


class OddSpellings(Plane):
    """Unreduced fractions, JSON integers, a negative zero."""

    def number(self, value: Fraction) -> Any:
        if value == 0:
            return random.choice(["0", 0, "-0", "0/7"])
        if value.denominator == 1 and random.random() < HALF:
            return value.numerator
        return f"{value.numerator * 6}/{value.denominator * 6}"


class OddDoubles(Doubles):
    """Doubles as `1.5E+00`, `-0.0`, and whole ones as integers."""

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
