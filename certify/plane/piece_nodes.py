"""An operand's pieces and groups as convex hulls, with whole numbers."""

from __future__ import annotations

from collections.abc import Sequence
from math import gcd
from typing import Any

from minkref.certify.plane.predicate import Place

Vector = tuple[int, int]


class Tree:
    """The step `pieces`, with vertices as whole numbers, scaled by `unit`."""

    def __init__(self, step: dict[str, Any], vertices: Sequence[Place], unit: int) -> None:
        self.points = [(int(x * unit), int(y * unit)) for x, y in vertices]
        self.pieces = len(step["pieces"])
        self.children: list[list[int]] = [[] for _ in step["pieces"]] + step["groups"]
        self.hulls: list[list[Vector]] = []
        for node, children in enumerate(self.children):
            if children:
                points = [p for child in children for p in self.hulls[child]]
                self.hulls.append(hull_of(points))
            else:
                self.hulls.append([self.points[i] for i in step["pieces"][node]])
        self.extents = [_extent(hull) for hull in self.hulls]
        self.sides = [sides(hull) for hull in self.hulls]
        self._most: dict[tuple[int, Vector], int] = {}

    @property
    def root(self) -> int:
        return len(self.hulls) - 1

    def most(self, node: int, normal: Vector) -> int:
        key = (node, normal)
        if key not in self._most:
            x, y = normal
            self._most[key] = max(x * u + y * v for u, v in self.hulls[node])
        return self._most[key]


def sides(ring: Sequence[Vector]) -> list[Vector]:
    """Outward normals of the half-planes whose intersection is a convex polygon, segment or
    point."""
    if len(ring) > 2:
        turned = zip(ring, [*ring[1:], ring[0]], strict=True)
        normals = [shortest((b[1] - a[1], a[0] - b[0])) for a, b in turned]
        return list(dict.fromkeys(normals))
    x, y = (1, 0)
    if len(ring) == 2:
        x, y = shortest((ring[1][0] - ring[0][0], ring[1][1] - ring[0][1]))
    return [(x, y), (-x, -y), (y, -x), (-y, x)]


def shortest(v: Vector) -> Vector:
    """The shortest whole vector along a vector."""
    d = gcd(*v)
    return v[0] // d, v[1] // d


def _extent(hull: Sequence[Vector]) -> int:
    xs, ys = [x for x, _ in hull], [y for _, y in hull]
    return max(max(xs) - min(xs), max(ys) - min(ys))


def hull_of(points: Sequence[Vector]) -> list[Vector]:
    """The vertices of the convex hull, counter-clockwise."""
    ordered = sorted(set(points))
    if len(ordered) < 3:
        return ordered
    both: list[Vector] = []
    for run in (ordered, ordered[::-1]):
        chain: list[Vector] = []
        for p in run:
            while len(chain) > 1 and _turn(chain[-2], chain[-1], p) <= 0:
                chain.pop()
            chain.append(p)
        both += chain[:-1]
    return both


def _turn(a: Vector, b: Vector, c: Vector) -> int:
    return (b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0])
