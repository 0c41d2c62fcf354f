"""Edges and vectors in decimals."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from decimal import Decimal

from minkref.certify.disc.joint_places import Exact, Near, near

Edge = tuple[Exact, Exact]


def minus(p: Near, q: Near) -> Near:
    return p[0] - q[0], p[1] - q[1]


def cross(p: Near, q: Near) -> Decimal:
    return p[0] * q[1] - p[1] * q[0]


def dot(p: Near, q: Near) -> Decimal:
    return p[0] * q[0] + p[1] * q[1]


def way_of(edge: Edge) -> Exact:
    return edge[1][0] - edge[0][0], edge[1][1] - edge[0][1]


@dataclass(frozen=True)
class NearEdge:
    """An edge from `a` to `b`, along `u`."""

    exact: Edge
    a: Near
    b: Near
    u: Near
    length: Decimal

    @classmethod
    def of(cls, edge: Edge) -> NearEdge:
        u = near(way_of(edge))
        return cls(edge, near(edge[0]), near(edge[1]), u, dot(u, u).sqrt())

    def nearest(self, p: Near) -> Near:
        """The point nearest to p."""
        part = dot(minus(p, self.a), self.u) / self.length**2
        part = min(max(part, Decimal(0)), Decimal(1))
        return self.a[0] + part * self.u[0], self.a[1] + part * self.u[1]


def boxes_within(edges: Mapping[int, NearEdge], reach: Decimal) -> dict[int, list[int]]:
    """For each edge the edges whose boxes are as near as this, or a bit farther. O(n²)."""
    boxes = {n: [pick(edge.a[k], edge.b[k]) for pick in (min, max) for k in (0, 1)]
             for n, edge in edges.items()}  # fmt: skip
    reach += reach.scaleb(-9)
    return {n: [f for f, c in boxes.items() if _apart(b, c) <= reach] for n, b in boxes.items()}


def _apart(b: list[Decimal], c: list[Decimal]) -> Decimal:
    return max(b[0] - c[2], c[0] - b[2], b[1] - c[3], c[1] - b[3])
