"""Base of the faulty adapters in the plane: the exact sum, to be spoilt."""

from __future__ import annotations

from typing import Any

from conversation import Request
from minkref import _core
from plane_adapter import Plane
from plane_sets import Polygon, set_of, sum_of


class Faulty(Plane):
    """Has the operands of a request and the exact sum at hand."""

    def sum(self, request: Request) -> list[Polygon]:
        P, Q = set_of(request["sP"]), set_of(self.Q)
        return self.spoilt(P, Q, sum_of(P, Q))

    def spoilt(
        self, P: _core.PolygonSet, Q: _core.PolygonSet, found: list[Polygon]
    ) -> list[Polygon]:
        raise NotImplementedError


def without_holes(found: list[Polygon], lost: Any) -> list[Polygon]:
    return [(outer, [hole for hole in holes if not lost(hole)]) for outer, holes in found]


def first_vertex_moved(found: list[Polygon], by: Any) -> list[Polygon]:
    if not found:
        return found
    (x, y), *rest = found[0][0]
    return [([(by(x), y), *rest], found[0][1]), *found[1:]]


def a_corner_cut(found: list[Polygon]) -> list[Polygon]:
    """Removes one convex vertex from the first outer ring."""
    if not found or len(found[0][0]) < 4:
        return found
    return [(found[0][0][1:], found[0][1]), *found[1:]]


def vertices(*operands: _core.PolygonSet) -> int:
    return sum(operand.vertices for operand in operands)
