"""Sets grown or eroded with sharp corners, from the page of the protocol alone, and seeded faults
of that, by name."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import ClassVar

from plain_offset import STRAIGHT, How, PlainOffset, Point, Ring, ccw, go


class PlainSharp(PlainOffset):
    """Rectangles at sides, and whole kites at corners that open; no other offsets."""

    tolerance: ClassVar[dict[str, str]] = {"relative": "1e-9"}
    able = (
        "plane", "non-convex", "holes", "components", "touching", "empty", "join-sharp",
        "inset-sharp",
    )  # fmt: skip

    def join(self, v: Point, n: Point, m: Point, r: float, how: How) -> Ring:
        return ccw(self.kite(v, n, m, r)) if self.opens(n, m, r) else []

    def opens(self, n: Point, m: Point, r: float) -> bool:
        """Whether there is a gap between the rectangles of two sides."""
        return (n[0] * m[1] - n[1] * m[0]) * math.copysign(1, r) > -STRAIGHT

    def kite(self, v: Point, n: Point, m: Point, r: float) -> Ring:
        return [v, go(v, n, r), self.tip(v, n, m, r), go(v, m, r)]

    def tip(self, v: Point, n: Point, m: Point, r: float) -> Point:
        return go(v, (n[0] + m[0], n[1] + m[1]), r * self.stretch(n, m) ** 2 / 2)

    def stretch(self, n: Point, m: Point) -> float:
        """How far a tip is, in radii."""
        return 2 / math.hypot(n[0] + m[0], n[1] + m[1])


class SharpFault(PlainSharp):
    """A right implementation with a wrong step."""


class CornersCut(SharpFault):
    """Cuts corners with a tip beyond two radii."""

    def kite(self, v: Point, n: Point, m: Point, r: float) -> Ring:
        whole = super().kite(v, n, m, r)
        return whole if self.stretch(n, m) <= 2 else [whole[0], whole[1], whole[3]]


class CornersRound(SharpFault):
    """Rounds all corners."""

    def kite(self, v: Point, n: Point, m: Point, r: float) -> Ring:
        return self.disc(v, r)


class HolesCornersRound(SharpFault):
    """Rounds corners of holes."""

    def of_ring(self, ring: Ring, r: float, how: How, is_hole: bool) -> Iterator[Ring]:
        return (CornersRound() if is_hole else PlainSharp()).of_ring(ring, r, how, is_hole)


class ArmsLost(SharpFault):
    """Omits the arm of a corner beside its second side."""

    def kite(self, v: Point, n: Point, m: Point, r: float) -> Ring:
        return super().kite(v, n, m, r)[:3]


class SlantedSidesMovedLess(SharpFault):
    """Moves slanted sides two hundredths less."""

    def normal(self, a: Point, b: Point) -> Point:
        x, y = super().normal(a, b)
        return (0.98 * x, 0.98 * y) if x and y else (x, y)


class ReflexTurnsMistaken(SharpFault):
    """Erodes with the corners that open for growing."""

    def opens(self, n: Point, m: Point, r: float) -> bool:
        return super().opens(n, m, abs(r))


class ReflexCornersMirrored(SharpFault):
    """Erodes reflex corners on their wrong side."""

    def kite(self, v: Point, n: Point, m: Point, r: float) -> Ring:
        return super().kite(v, n, m, abs(r))


class VerticesAtUnitSpeed(SharpFault):
    """Moves vertices as far as sides."""

    def tip(self, v: Point, n: Point, m: Point, r: float) -> Point:
        return go(v, (n[0] + m[0], n[1] + m[1]), r * self.stretch(n, m) / 2)


class TipsTooFar(SharpFault):
    """Moves tips a hundredth too far."""

    def tip(self, v: Point, n: Point, m: Point, r: float) -> Point:
        return super().tip(v, n, m, 1.01 * r)


class FirstCornersLost(SharpFault):
    """Omits the corner at a ring's first vertex."""

    def of_ring(self, ring: Ring, r: float, how: How, is_hole: bool) -> Iterator[Ring]:
        return iter(list(super().of_ring(ring, r, how, is_hole))[:-1])


SHARP_FAULTS: dict[str, type[PlainSharp]] = {
    fault.__name__: fault for fault in SharpFault.__subclasses__()
}
