"""The boundary of a sum with a disc in long binary numbers, from its canonical form alone: a judge
of written numbers. It shares with the library only docs/disc.md's description of the form."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from mpmath import mp, mpf

BITS = 1500
Point = tuple[Any, Any]


@dataclass
class TrueRing:
    """The corners, each at the start of the curve with its number, and the curves."""

    corners: list[Point]
    curves: list[list[str]]


class TrueBoundary:
    """Takes the document of a canonical form."""

    def __init__(self, form: dict[str, Any]) -> None:
        mp.prec = BITS
        self.squared_radius = number(form["squared_radius"])
        self.radius = mp.sqrt(self.squared_radius)
        self.rings = [
            self._ring(ring)
            for part in form["components"]
            for ring in (part["outer"], *part["holes"])
        ]

    def _ring(self, curves: list[list[str]]) -> TrueRing:
        if len(curves) == 1:
            return TrueRing([], curves)
        before = [curves[-1], *curves[:-1]]
        corners = [self._corner(a, b) for a, b in zip(before, curves, strict=True)]
        return TrueRing([(_or_zero(x), _or_zero(y)) for x, y in corners], curves)

    def _line(self, curve: list[str]) -> tuple[Any, Any, Any]:
        """The unit normal, and its product with a point of the line."""
        dx, dy, c = map(number, curve[1:])
        length = mp.hypot(dx, dy)
        return dy / length, -dx / length, c / length + self.radius

    def _corner(self, first: list[str], second: list[str]) -> Point:
        """The point where the first curve, run with the sum on its left, enters the offset of the
        second curve's feature."""
        if first[0] == second[0] == "line":
            (nx, ny, h), (mx, my, k) = self._line(first), self._line(second)
            turn = nx * my - ny * mx
            return (h * my - k * ny) / turn, (nx * k - mx * h) / turn
        if first[0] == second[0]:
            (ax, ay), (bx, by) = (tuple(map(number, curve[1:])) for curve in (first, second))
            wx, wy = bx - ax, by - ay
            square = wx * wx + wy * wy
            far = mp.sqrt(max(self.squared_radius / square - mpf(1) / 4, mpf(0)))
            found = [((ax + bx) / 2 - s * wy, (ay + by) / 2 + s * wx) for s in (far, -far)]
        else:
            line, arc = (first, second) if first[0] == "line" else (second, first)
            (nx, ny, h), (cx, cy) = self._line(line), map(number, arc[1:])
            height = nx * cx + ny * cy - h
            far = mp.sqrt(max(self.squared_radius - height * height, mpf(0)))
            found = [(cx - height * nx - s * ny, cy - height * ny + s * nx) for s in (far, -far)]
        return min(found, key=lambda p: self._rate(first, second, p))

    def _rate(self, first: list[str], second: list[str], p: Point) -> Any:
        """How the distance from what the second is about grows along the first."""
        if first[0] == "line":
            nx, ny, _ = self._line(first)
            way = -ny, nx
        else:
            way = number(first[2]) - p[1], p[0] - number(first[1])
        if second[0] == "line":
            nx, ny, _ = self._line(second)
            return way[0] * nx + way[1] * ny
        return way[0] * (p[0] - number(second[1])) + way[1] * (p[1] - number(second[2]))

    def measures(self) -> tuple[Any, Any]:
        """Area and length."""
        area = length = mpf(0)
        for ring in self.rings:
            if not ring.corners:
                area += self.squared_radius * mp.pi
                length += 2 * self.radius * mp.pi
            for k, curve in enumerate(ring.curves if ring.corners else []):
                (x, y), (u, v) = ring.corners[k], ring.corners[(k + 1) % len(ring.corners)]
                if curve[0] == "line":
                    area += (x * v - y * u) / 2
                    length += mp.hypot(u - x, v - y)
                    continue
                cx, cy = map(number, curve[1:])
                start, end = mp.atan2(y - cy, x - cx), mp.atan2(v - cy, u - cx)
                angle = end - start if end > start else end - start + 2 * mp.pi
                area += (self.squared_radius * angle + cx * (v - y) - cy * (u - x)) / 2
                length += self.radius * angle
        return area, length


def _or_zero(value: Any) -> Any:
    """Rounds to zero: no example has a nonzero coordinate this close to 0."""
    return mpf(0) if abs(value) < mpf(2) ** (-BITS // 3) else value


def number(text: str | Fraction) -> Any:
    value = Fraction(text)
    return mpf(value.numerator) / value.denominator
