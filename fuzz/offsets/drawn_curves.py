"""Rings of circles and lines in doubles: their corners, and whether a point lies inside.

The corner between two curves of a ring is the point where the first one enters the neighbourhood of
the second. Places are measured from an origin near the set.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from fractions import Fraction

from minkref.fuzz.geometry.plane import Point
from minkref.fuzz.offsets.curves import Curve, Ring, components_of

Spot = tuple[float, float]
SLACK = 1e-6  # of the radius: curves that miss each other by less touch
PARALLEL = 1e-12


@dataclass(frozen=True)
class Piece:
    """From `start` to `end`; an arc runs counter-clockwise about its centre."""

    start: Spot
    end: Spot
    centre: Spot | None = None

    def middle(self, radius: float) -> tuple[Spot, Spot]:
        """The middle, and the direction to the right there."""
        (x0, y0), (x1, y1) = self.start, self.end
        if self.centre is None:
            length = math.hypot(x1 - x0, y1 - y0) or 1.0
            return ((x0 + x1) / 2, (y0 + y1) / 2), ((y1 - y0) / length, (x0 - x1) / length)
        first, turn = self._angles()
        way = (math.cos(first + turn / 2), math.sin(first + turn / 2))
        return (self.centre[0] + radius * way[0], self.centre[1] + radius * way[1]), way

    def length(self, radius: float) -> float:
        if self.centre is not None:
            return radius * self._angles()[1]
        return math.hypot(self.end[0] - self.start[0], self.end[1] - self.start[1])

    def _angles(self) -> tuple[float, float]:
        assert self.centre is not None
        x, y = self.centre
        first = math.atan2(self.start[1] - y, self.start[0] - x)
        if self.start == self.end:
            return first, math.tau
        return first, (math.atan2(self.end[1] - y, self.end[0] - x) - first) % math.tau

    def path(self, steps: int) -> list[Spot]:
        """Points along the piece, without the end; `steps`: for a whole turn."""
        if self.centre is None:
            return [self.start]
        first, turn = self._angles()
        radius = math.hypot(self.start[0] - self.centre[0], self.start[1] - self.centre[1])
        count = max(1, math.ceil(steps * turn / math.tau))
        angles = [first + turn * k / count for k in range(count)]
        x, y = self.centre
        return [(x + radius * math.cos(a), y + radius * math.sin(a)) for a in angles]

    def crossings(self, spot: Spot, radius: float) -> int:
        """How often it crosses the way from a place to the right, upwards less downwards."""
        x, y = spot
        if self.centre is None:
            (x0, y0), (x1, y1) = self.start, self.end
            if (y0 > y) == (y1 > y) or x0 + (x1 - x0) * (y - y0) / (y1 - y0) <= x:
                return 0
            return 1 if y1 > y0 else -1
        up = (y - self.centre[1]) / radius
        if not -1 < up < 1:
            return 0
        first, turn = self._angles()
        found = 0
        for angle, sign in ((math.asin(up), 1), (math.pi - math.asin(up), -1)):
            if (angle - first) % math.tau < turn:
                found += sign * (self.centre[0] + radius * math.cos(angle) > x)
        return found


@dataclass(frozen=True)
class DrawnCurves:
    """`rings` of each component, the outer one first. `broken`: rings whose curves do not meet.
    `around`: how often all is wound around, beside what the rings do."""

    origin: Point
    radius: float
    rings: list[list[list[Piece]]]
    broken: int
    around: int = 0

    def pieces(self) -> list[Piece]:
        return [piece for rings in self.rings for ring in rings for piece in ring]

    def winding(self, spot: Spot) -> int:
        return self.around + sum(piece.crossings(spot, self.radius) for piece in self.pieces())


def drawn_curves(text: str, radius: Fraction, origin: Point) -> DrawnCurves:
    """Draws what `read_curves` wrote."""
    drawing = _Drawing(float(radius), radius, origin)
    rings = [
        [drawing.ring(ring) for ring in (outer, *holes)] for outer, holes in components_of(text)
    ]
    whole = [[ring for ring in each if ring is not None] for each in rings]
    return DrawnCurves(origin, float(radius), whole, sum(each.count(None) for each in rings))


@dataclass(frozen=True)
class _Drawing:
    radius: float
    exact: Fraction
    origin: Point

    def ring(self, curves: Ring) -> list[Piece] | None:
        if len(curves) == 1:
            if curves[0][0] != "arc":
                return None
            x, y = self._centre(curves[0])
            return [Piece((x + self.radius, y), (x + self.radius, y), (x, y))]
        corners = [
            self._corner(a, b) for a, b in zip(curves, [*curves[1:], curves[0]], strict=True)
        ]
        if any(corner is None for corner in corners):
            return None
        found: list[Piece] = []
        for k, curve in enumerate(curves):
            start, end = corners[k - 1], corners[k]
            assert start is not None and end is not None
            found.append(Piece(start, end, self._centre(curve) if curve[0] == "arc" else None))
        return found

    def _centre(self, arc: Curve) -> Spot:
        return (float(arc[1] - self.origin[0]), float(arc[2] - self.origin[1]))

    def _line(self, line: Curve) -> tuple[Spot, Spot, float]:
        """Direction, normal to the right, and the distance from the origin along the normal."""
        _, dx, dy, c = line
        length = math.hypot(float(dx), float(dy))
        x, y = float(dx) / length, float(dy) / length
        off = c - (dy * self.origin[0] - dx * self.origin[1])
        return (x, y), (y, -x), float(off) / length + self.radius

    def _corner(self, a: Curve, b: Curve) -> Spot | None:
        if a[0] == b[0] == "arc":
            return self._of_arcs(self._centre(a), self._centre(b))
        if a[0] == b[0]:
            return self._of_lines(a, b)
        line = self._line(a if a[0] == "line" else b)
        return self._of_both(line, self._centre(b if a[0] == "line" else a), a[0] == "line")

    def _of_arcs(self, a: Spot, b: Spot) -> Spot | None:
        x, y = b[0] - a[0], b[1] - a[1]
        apart = math.hypot(x, y)
        if not 0 < apart <= 2 * self.radius * (1 + SLACK):
            return None
        up = math.sqrt(max(self.radius**2 - apart**2 / 4, 0.0)) / apart
        return (a[0] + x / 2 + up * y, a[1] + y / 2 - up * x)

    def _of_lines(self, a: Curve, b: Curve) -> Spot | None:
        (_, n, k), (_, m, h) = self._line(a), self._line(b)
        turn = n[0] * m[1] - n[1] * m[0]
        if abs(turn) < PARALLEL:
            return None
        return ((k * m[1] - h * n[1]) / turn, (h * n[0] - k * m[0]) / turn)

    def _of_both(
        self, line: tuple[Spot, Spot, float], centre: Spot, enters_disc: bool
    ) -> Spot | None:
        """From a line into a disc, or from a circle below a line."""
        way, normal, k = line
        above = normal[0] * centre[0] + normal[1] * centre[1] - k
        if abs(above) > self.radius * (1 + SLACK):
            return None
        along = math.sqrt(max(self.radius**2 - above**2, 0.0))
        along = -along if enters_disc else along
        x, y = centre[0] - above * normal[0], centre[1] - above * normal[1]
        return (x + along * way[0], y + along * way[1])
