"""Convex pieces of a part and of obstacles, and the places and scales at which two pieces
collide."""

from __future__ import annotations

import json
from collections.abc import Sequence
from fractions import Fraction
from math import gcd, lcm
from typing import Any

from minkref import _core
from minkref.certify.case_text import places
from minkref.certify.motion.convex_cells import Place
from minkref.certify.plane.piece_nodes import Tree, Vector, shortest
from minkref.motion.scale_ranges import ScaleRange

#: Linear in t, s and w.
Gap = tuple[int, int, int]
#: At t / w along a segment and the scale s / w; w = 0 far up.
Corner = tuple[int, int, int]
#: x0, x1, y0, y1: the place (x0 + s x1, y0 + s y1).
MovingPlace = tuple[Fraction, Fraction, Fraction, Fraction]


class Pair:
    """The trees for a part R and for obstacles O, in one unit."""

    def __init__(self, part: _core.PolygonSet, obstacles: _core.PolygonSet) -> None:
        prover = _core.Prover(part, obstacles)
        self.steps: list[dict[str, Any]] = []
        for name, operand in (("R", "P"), ("O", "Q")):
            step = json.loads(prover.pieces(operand))
            self.steps.append({**step, "of": name})
        vertices = places(part), places(obstacles)
        self.unit = lcm(*(c.denominator for of in vertices for place in of for c in place))
        self.R, self.O = (
            Tree(step, of, self.unit) for step, of in zip(self.steps, vertices, strict=True)
        )

    def directions(self, A: int, B: int) -> list[Vector]:
        """Returns enough normals to hold two convex nodes apart, or to say where the nodes
        collide."""
        turned = [(-x, -y) for x, y in self.R.sides[A]]
        return list(dict.fromkeys(self.O.sides[B] + turned))


class Way:
    """A segment of part places, from t = 0 to t = 1, in whole numbers."""

    def __init__(self, pair: Pair, start: Place, end: Place) -> None:
        self.pair, self.ends = pair, (start, end)
        self._parts = lcm(*(c.denominator for place in self.ends for c in place))
        unit = pair.unit * self._parts
        (x, y), (X, Y) = ((int(x * unit), int(y * unit)) for x, y in self.ends)
        self._set((x, y), (0, 0), (X - x, Y - y), 1)

    def _set(self, start: Vector, slope: Vector, along: Vector, square: int) -> None:
        """The places start + s slope + t along / square, in units."""
        self._start, self._slope, self._along, self._square = start, slope, along, square
        self.length = Fraction(max(map(abs, along)), self._parts * square)  # per unit of t
        self.across: list[Vector] = []
        if along != (0, 0):
            n = shortest((-along[1], along[0]))
            self.across = [n, (-n[0], -n[1])]

    def cell(self, scales: ScaleRange) -> list[Corner]:
        """The segment at all scales of a range, counter-clockwise."""
        (s, w), (S, W) = ends_of(scales)
        return list(dict.fromkeys([(0, s, w), (w, s, w), (W, S, W), (0, S, W)]))

    def gap(self, normal: Vector, A: int, B: int) -> Gap:
        """Positive where the normal holds the nodes apart, zero where the nodes may touch."""
        least = self._parts * -self.pair.R.most(A, (-normal[0], -normal[1]))
        most = self._parts * self.pair.O.most(B, normal)
        grows, far = _dot(normal, self._slope) + least, _dot(normal, self._start) - most
        return _dot(normal, self._along), self._square * grows, self._square * far

    def at(self, t: Fraction) -> Place:
        (x, y), (X, Y) = self.ends
        return x + t * (X - x), y + t * (Y - y)


class MovingWay(Way):
    """A segment whose ends move with the scale, with the same direction at all scales of a range.
    Raises ValueError if the segment turns."""

    def __init__(
        self, pair: Pair, start: MovingPlace, end: MovingPlace, scales: ScaleRange
    ) -> None:
        self.pair = pair
        self._parts = lcm(*(c.denominator for place in (start, end) for c in place))
        unit = pair.unit * self._parts
        (x, u, y, v), (X, U, Y, V) = ([int(c * unit) for c in place] for place in (start, end))
        ends = ends_of(scales)
        first, last = (
            (w * (X - x) + s * (U - u), w * (Y - y) + s * (V - v)) for s, w in ends
        )  # at the ends of the range
        if first[0] * last[1] != first[1] * last[0] or _dot(first, last) < 0:
            raise ValueError("a segment turns as the scale changes")
        along = first[0] + last[0], first[1] + last[1]
        self._set((x, y), (u, v), along, _dot(along, along) or 1)
        (s, w), (S, W) = ends
        t, T = _dot(first, along), _dot(last, along)
        self._cell = list(dict.fromkeys([(0, s, w), (t, s, w), (T, S, W), (0, S, W)]))

    def cell(self, scales: ScaleRange) -> list[Corner]:
        return self._cell


def stays(place: Place) -> MovingPlace:
    return Fraction(place[0]), Fraction(0), Fraction(place[1]), Fraction(0)


def ends_of(scales: ScaleRange) -> tuple[Vector, Vector]:
    """The first and the last scale, as (s, w); (1, 0) for infinity."""
    last = (1, 0) if scales.high is None else scales.high.as_integer_ratio()
    return scales.low.as_integer_ratio(), last


def levels(gap: Gap, corners: Sequence[Corner]) -> list[int]:
    a, b, c = gap
    return [a * t + b * s + c * w for t, s, w in corners]


def cut(corners: Sequence[Corner], gap: Gap) -> list[Corner]:
    """Returns the part of a convex polygon where the gap is not positive."""
    at = levels(gap, corners)
    if max(at) <= 0:
        return list(corners)
    if min(at) > 0:
        return []
    kept: dict[Corner, None] = {}
    for k, (corner, v) in enumerate(zip(corners, at, strict=True)):
        before, u = corners[k - 1], at[k - 1]
        if (u < 0 < v) or (v < 0 < u):
            t, s, w = (abs(v) * i + abs(u) * j for i, j in zip(before, corner, strict=True))
            d = gcd(t, s, w)
            kept[t // d, s // d, w // d] = None
        if v <= 0:
            kept[corner] = None
    return list(kept)


def _dot(u: Vector, v: Vector) -> int:
    return u[0] * v[0] + u[1] * v[1]
