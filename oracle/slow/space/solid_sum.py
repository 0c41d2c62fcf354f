"""Tests points in a sum in space: `sP + Q` unites the sums of all pairs of convex pieces.

The sum of two convex pieces contains x iff n . x <= max n . a + max n . b for all normals n of both
and all cross products of their edges: its facets have no other normals, and each such n gives a
half-space that holds the sum. No construction is needed.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from ..exact import InputError
from .solid import Place, Solid, Whole, inner, outer, plus, shortest, wholes
from .solid_pieces import Piece, convex_pieces

HalfSpace = tuple[Whole, int, int]  # n . x <= bound / unit


class SolidSum:
    """A sum prepared for many points. InputError if neither operand has faces."""

    def __init__(self, P: Solid, Q: Solid, factors: Place) -> None:
        if P.ends and Q.ends:
            raise InputError("one of the two operands has a volume")
        self.P = convex_pieces(P.scaled(factors))
        self.Q = convex_pieces(Q)
        self.pairs = [(a, b) for a in self.P for b in self.Q]
        self.boxes = [(plus(a.low, b.low), plus(a.high, b.high)) for a, b in self.pairs]
        self._ends = [wholes([*box]) for box in self.boxes]
        self._bounds: dict[int, list[HalfSpace]] = {}

    def bounds(self, pair: int) -> list[HalfSpace]:
        found = self._bounds.get(pair)
        if found is None:
            found = self._bounds[pair] = half_spaces(*self.pairs[pair])
        return found

    def holds(self, x: Place, ways: Sequence[Whole] = (), interiors: bool = False) -> bool:
        """Tell whether the closed sum, or with `interiors` the sum of the (relative) interiors,
        contains x; with ways u, v, ... the point x + e u + e^2 v + ... for all small e > 0. Exact.
        Cost: pairs of pieces times their half-spaces at worst."""
        w, (whole,) = wholes([x])
        for pair, (unit, (low, high)) in enumerate(self._ends):
            place = (c * unit for c in whole)
            if not all(a * w <= c <= b * w for a, c, b in zip(low, place, high, strict=True)):
                continue
            if self._in_pair(pair, whole, w, ways, interiors):
                return True
        return False

    def _in_pair(self, pair: int, x: Whole, w: int, ways: Sequence[Whole], interiors: bool) -> bool:
        bounds = self.bounds(pair)
        for place, (n, bound, unit) in enumerate(bounds):
            left = inner(n, x) * unit - bound * w
            if left < 0:
                continue
            if left == 0:
                steps = (inner(n, way) for way in ways)
                first = next((step for step in steps if step), 0)
                if first < 0 or (first == 0 and not interiors):
                    continue
            bounds.insert(0, bounds.pop(place))  # a separating half-space separates again
            return False
        return True


def half_spaces(a: Piece, b: Piece) -> list[HalfSpace]:
    normals = dict.fromkeys([*a.normals, *b.normals])
    for u in a.edges:
        for v in b.edges:
            n = outer(u, v)
            if n != (0, 0, 0):
                x, y, z = shortest(n)
                normals[(x, y, z)] = normals[(-x, -y, -z)] = None
    unit = a.unit * b.unit
    return [(n, a.support(n) * b.unit + b.support(n) * a.unit, unit) for n in normals]


def uniform(scale: Fraction) -> Place:
    return scale, scale, scale
