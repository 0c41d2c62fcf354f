"""Random operands for the slow engine, by seed: meshes with omitted triangles, and stars with
holes.

A mesh is a grid of slightly moved vertices, its cells cut into triangles, some of them chosen. Its
boundary has holes, several components, touching rings, straight vertices and parallel edges, and is
valid for any choice of triangles: so a mesh shrinks triangle by triangle.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from fractions import Fraction
from math import atan2

from minkref.oracle.slow.exact import cross, primitive
from minkref.oracle.slow.operand import Operand, Polygon
from minkref.oracle.slow.plane import Edge, Plane
from minkref.oracle.slow.walks import components

Vertex = tuple[int, int]
Triangle = tuple[Vertex, Vertex, Vertex]


@dataclass(frozen=True)
class Mesh:
    """Triangles, counter-clockwise, with disjoint interiors, that meet in whole edges and
    vertices."""

    triangles: tuple[Triangle, ...]

    def operand(self) -> Operand:
        ways = {(t[i], t[i - 2]) for t in self.triangles for i in range(3)}
        edges = []
        plane = Plane()
        for a, b in sorted(way for way in ways if way[::-1] not in ways):
            d = primitive(b[0] - a[0], b[1] - a[1])
            plane.points[a] = (*a, 1)
            edges.append(Edge(a, b, d, cross(d, a)))
        parts, _ = components(plane, edges)

        def ring(of: list[Edge]) -> list[tuple[Fraction, Fraction]]:
            return [(Fraction(e.start[0]), Fraction(e.start[1])) for e in of]

        return Operand([Polygon(ring(p.outer), [ring(h) for h in p.holes]) for p in parts], [])

    def smaller(self) -> Iterator[Mesh]:
        for index in range(len(self.triangles)):
            yield Mesh(self.triangles[:index] + self.triangles[index + 1 :])


@dataclass(frozen=True)
class Star:
    """Corners seen from the origin in counter-clockwise order; the hole is a third of the size."""

    corners: tuple[Vertex, ...]
    hole: bool

    def operand(self) -> Operand:
        outer = [(Fraction(x), Fraction(y)) for x, y in self.corners]
        hole = [(x / 3, y / 3) for x, y in reversed(outer)]
        return Operand([Polygon(outer, [hole] if self.hole else [])], [])

    def smaller(self) -> Iterator[Star]:
        if self.hole:
            yield replace(self, hole=False)
        for index in range(len(self.corners)):
            left = self.corners[:index] + self.corners[index + 1 :]
            if is_star(left):
                yield replace(self, corners=left)


@dataclass(frozen=True)
class Segment:
    ends: tuple[Vertex, ...]

    def operand(self) -> Operand:
        return Operand([], [(Fraction(x), Fraction(y)) for x, y in self.ends])

    def smaller(self) -> Iterator[Segment]:
        if len(self.ends) == 2:
            yield Segment(self.ends[:1])


Source = Mesh | Star | Segment


def is_star(corners: tuple[Vertex, ...]) -> bool:
    return len(corners) > 2 and all(
        cross(a, b) > 0 for a, b in zip(corners, corners[1:] + corners[:1], strict=True)
    )


def mesh(rng: random.Random, cells: int) -> Mesh:
    step, jitter = rng.choice(((1, 0), (1, 0), (6, 1), (12, 2)))
    at = {
        (i, j): (step * i + rng.randint(-jitter, jitter), step * j + rng.randint(-jitter, jitter))
        for i in range(cells + 1)
        for j in range(cells + 1)
    }
    found: list[Triangle] = []
    share = rng.choice((0.5, 0.7, 0.85))
    for i in range(cells):
        for j in range(cells):
            a, b, c, d = at[i, j], at[i + 1, j], at[i + 1, j + 1], at[i, j + 1]
            halves = ((a, b, c), (a, c, d)) if rng.random() < 0.5 else ((a, b, d), (b, c, d))
            whole = rng.random() < 0.5
            taken = [rng.random() < share for _ in halves]
            found += [
                t for t, take in zip(halves, taken, strict=True) if (taken[0] if whole else take)
            ]
    return Mesh(tuple(found))


def star(rng: random.Random, most: int, reach: int) -> Star:
    while True:
        corners = [(rng.randint(-reach, reach), rng.randint(-reach, reach)) for _ in range(most)]
        corners = [c for c in corners if c != (0, 0)]
        corners.sort(key=lambda c: atan2(c[1], c[0]))
        ways: dict[Vertex, Vertex] = {}
        for corner in corners:
            ways.setdefault(primitive(*corner), corner)
        ring = tuple(ways.values())
        if is_star(ring):
            return Star(ring, rng.random() < 0.5)


def source(rng: random.Random, small: bool, flat: bool = False) -> Source:
    if flat:
        ends = {(rng.randint(-3, 3), rng.randint(-3, 3)) for _ in range(2)}
        return Segment(tuple(sorted(ends)))
    if rng.random() < 0.6:
        return mesh(rng, 2 if small else rng.choice((3, 4)))
    return star(rng, rng.randint(3, 8 if small else 14), rng.choice((2, 4, 9)))


def pair(seed: int, index: int, small: bool = True) -> tuple[Source, Source]:
    """The pair for a seed and index; about one pair in ten has a point or a segment."""
    rng = random.Random(f"{seed}:{index}:{small}")
    flat = rng.choice(("", "", "", "", "", "", "", "", "", "P", "Q"))
    return source(rng, small, flat == "P"), source(rng, small, flat == "Q")


def shrunk(P: Source, Q: Source, fails: Callable[[Source, Source], bool]) -> tuple[Source, Source]:
    """A smallest failing pair, found by omitting triangles or corners one after another."""
    while True:
        fewer = ((p, Q) for p in P.smaller())
        less = ((P, q) for q in Q.smaller())
        better = next((both for gen in (fewer, less) for both in gen if fails(*both)), None)
        if better is None:
            return P, Q
        P, Q = better


def as_json(operand: Operand) -> dict[str, object]:
    if operand.ends:
        return {"polygons": [{"outer": [[str(x), str(y)] for x, y in operand.ends]}]}
    return {
        "polygons": [
            {
                "outer": [[str(x), str(y)] for x, y in part.outer],
                "holes": [[[str(x), str(y)] for x, y in hole] for hole in part.holes],
            }
            for part in operand.polygons
        ]
    }
