"""Finds a point to tell a set of curves from a set grown by a disc, by exact distances."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property

from minkref.fuzz.offsets.curves import rings_in, written
from minkref.fuzz.offsets.distance import Distances, Exact
from minkref.fuzz.offsets.drawn_curves import DrawnCurves, Piece, Spot, drawn_curves
from minkref.fuzz.offsets.sandwich import Breach, shortened

STEPS = tuple(2.0**-k for k in (2, 4, 7, 10, 14, 18))  # of a piece, or of the radius
GRID = 16
TOUCHING = 2.0**-24  # of the radius: corners of circles that touch are off by so much
ROUNDED = 2.0**-40  # of the coordinates


@dataclass(frozen=True)
class CurveWitness:
    """Looks beside the pieces of rings that only the answer or only the sum has, and on a grid.
    Doubles tell whether the answer has a point, fractions whether the grown set has it. To find
    none proves nothing. O(k (n + k)) for k pieces, n edges. For an erosion `near` measures from the
    outside, and the rings, which have it on their right, bound what it leaves out: `turned`."""

    near: Distances
    answer: str
    truth: str
    radius: Fraction
    turned: bool = False

    def differing_point(self, half: Fraction) -> Breach | None:
        """A point of one only, farther than `half` within, or outside."""
        near, radius = self.near, self.radius
        own = self._own
        for spot in self._spots:
            inside = own.winding(spot) > 0
            point = near.place(spot)
            if _is_clear(own, spot, inside) and _differs(near, point, radius, half, inside):
                return _short(near, own, point, radius, half, inside)
        return None

    def overlap(self) -> Exact | None:
        """A point around which the rings of the answer wind twice or more, or less than zero
        times: they are no boundary."""
        own = self._own
        for x, y in self._spots:
            by = _margin(own, (x, y))
            around = {own.winding((x + i, y + j)) for i in (-by, by) for j in (-by, by)}
            if len(around) == 1 and not around <= {0, 1}:
                return self.near.place((x, y))
        return None

    @cached_property
    def _own(self) -> DrawnCurves:
        drawn = drawn_curves(self.answer, self.radius, self.near.origin)
        return replace(drawn, around=1) if self.turned else drawn

    @cached_property
    def _spots(self) -> list[Spot]:
        rings = [rings_in(text) for text in (self.answer, self.truth)]
        only = [
            [ring for ring in these if ring not in those] for these, those in (rings, rings[::-1])
        ]
        texts = (written([(ring, ())]) for each in only for ring in each)
        drawn = [drawn_curves(text, self.radius, self.near.origin) for text in texts]
        pieces = [piece for each in drawn for piece in each.pieces()]
        spots = _spots(pieces, float(self.radius))
        return [spot for spot in spots if math.isfinite(spot[0] + spot[1])]


def _differs(near: Distances, point: Exact, radius: Fraction, half: Fraction, inside: bool) -> bool:
    square = near.of(point).square
    if inside:
        return square > (radius + half) ** 2
    return radius > half and square < (radius - half) ** 2


def _short(
    near: Distances, own: DrawnCurves, point: Exact, radius: Fraction, half: Fraction, inside: bool
) -> Breach:
    def serves(x: Exact) -> bool:
        spot = near.spot(x)
        return (
            (own.winding(spot) > 0) == inside
            and _is_clear(own, spot, inside)
            and _differs(near, x, radius, half, inside)
        )

    short = shortened(point, serves)
    return Breach(short, not inside, near.of(short).square)


def _margin(own: DrawnCurves, spot: Spot) -> float:
    return TOUCHING * own.radius + ROUNDED * (abs(spot[0]) + abs(spot[1]))


def _is_clear(own: DrawnCurves, spot: Spot, inside: bool) -> bool:
    """Whether places next to it lie on the same side of the answer's boundary."""
    by = _margin(own, spot)
    ways = ((by, 0.0), (-by, 0.0), (0.0, by), (0.0, -by))
    return all((own.winding((spot[0] + x, spot[1] + y)) > 0) == inside for x, y in ways)


def _spots(pieces: list[Piece], radius: float) -> Iterator[Spot]:
    """The largest steps first."""
    for step in STEPS:
        for piece in pieces:
            (x, y), (nx, ny) = piece.middle(radius)
            by = step * min(radius, 4 * piece.length(radius))
            yield (x + by * nx, y + by * ny)
            yield (x - by * nx, y - by * ny)
        if step == STEPS[0] and pieces:
            yield from _on_grid([place for piece in pieces for place in piece.path(8)])


def _on_grid(places: list[Spot]) -> Iterator[Spot]:
    (left, right), (low, up) = (
        (min(p[k] for p in places), max(p[k] for p in places)) for k in (0, 1)
    )
    for i in range(GRID):
        for j in range(GRID):
            yield (left + (right - left) * (i + 0.5) / GRID, low + (up - low) * (j + 0.5) / GRID)
