"""The ties of a case of general polyhedra, computed again from the case file alone."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from itertools import combinations, pairwise
from typing import Any

from members import Vector, cross, dot, minus

ZERO = (Fraction(0),) * 3
Plane = tuple[Vector, Fraction]


class Read:
    """P, scaled, and Q, as the file has them."""

    def __init__(self, value: Any, s: Fraction) -> None:
        self.points = {
            name: [tuple(Fraction(c) * factor for c in row) for row in value[name]["vertices"]]
            for name, factor in (("P", s), ("Q", Fraction(1)))
        }
        self.faces = {name: value[name]["faces"] for name in "PQ"}

    def way(self, name: str, ends: list[int]) -> Vector:
        a, b = (self.points[name][k] for k in sorted(ends))
        return minus(b, a)  # type: ignore[arg-type]

    def normal(self, name: str, face: list[int]) -> Vector:
        """The outward normal of a face: the sum of all turns along the face."""
        assert face in self.faces[name], "this is no face"
        return self.vector_area(name, face)

    def vector_area(self, name: str, face: list[int]) -> Vector:
        x = y = z = Fraction(0)
        at = self.points[name]
        for a, b in pairwise(face[1:]):
            n = cross(minus(at[a], at[face[0]]), minus(at[b], at[face[0]]))  # type: ignore[arg-type]
            x, y, z = x + n[0], y + n[1], z + n[2]
        assert (x, y, z) != ZERO
        return x, y, z

    def sides_of_edge(self, name: str, ends: list[int]) -> tuple[Vector, Vector]:
        """The normals on the left and the right of an edge, from its lesser vertex."""
        a, b = sorted(ends)
        found = {}
        for face in self.faces[name]:
            for u, v in zip(face, face[1:] + face[:1], strict=True):
                if {u, v} == {a, b}:
                    found[u == a] = self.vector_area(name, face)
        return found[True], found[False]

    def plane(self, feature: list[list[int]]) -> Plane:
        """The plane of a convolution facet, with outward normal."""
        p, q = feature
        if len(p) > 2:
            n = self.normal("P", p)
        elif len(q) > 2:
            n = self.normal("Q", q)
        else:
            n = self._of_edges(p, q)
        return n, dot(n, self.sum_of(p[0], q[0]))

    def sum_of(self, p: int, q: int) -> Vector:
        x, y, z = (a + b for a, b in zip(self.points["P"][p], self.points["Q"][q], strict=True))
        return x, y, z

    def _of_edges(self, p: list[int], q: list[int]) -> Vector:
        """The normal of two convex edges, which lies between the normals of each edge's faces."""
        n = cross(self.way("P", p), self.way("Q", q))
        left, right = self.sides_of_edge("P", p)
        return n if dot(left, self.way("Q", q)) - dot(right, self.way("Q", q)) >= 0 else (
            -n[0], -n[1], -n[2])  # fmt: skip

    def is_facet(self, feature: list[list[int]]) -> bool:
        """Whether all edges at the vertex run down from the normal, for a face and a vertex; for
        two edges, whether the faces beside both do."""
        n, _ = self.plane(feature)
        return all(dot(n, way) < 0 for way in self._ways_down(feature))

    def _ways_down(self, feature: list[list[int]]) -> Iterator[Vector]:
        for name, corners in zip("PQ", feature, strict=True):
            if len(corners) == 1:
                for other in self.beside(name, corners[0]):
                    yield self.way_from(name, corners[0], other)
            elif len(corners) == 2:
                left, right = self.sides_of_edge(name, corners)
                yield cross(left, self.way(name, corners))
                yield cross(self.way(name, corners), right)

    def way_from(self, name: str, a: int, b: int) -> Vector:
        return minus(self.points[name][b], self.points[name][a])  # type: ignore[arg-type]

    def beside(self, name: str, k: int) -> set[int]:
        found = set()
        for face in self.faces[name]:
            if k in face:
                at = face.index(k)
                found |= {face[at - 1], face[(at + 1) % len(face)]}
        return found


def sign(value: Fraction) -> int:
    return (value > 0) - (value < 0)


def value_of(row: Any, read: Read) -> int:
    """Value of the predicate named by a row."""
    what, features = row["what"], row["features"]
    p, q = features[0]
    if what in ("parallel-facets", "opposite-facets"):
        m, n = read.normal("P", p), read.normal("Q", q)
        if cross(m, n) == ZERO:
            assert (dot(m, n) > 0) == (what == "parallel-facets")
        return int(cross(m, n) != ZERO)
    if what == "parallel-edges":
        return int(cross(read.way("P", p), read.way("Q", q)) != ZERO)
    if what == "facet-and-edge":
        return sign(dot(read.normal("P", p), read.way("Q", q)))
    if what == "edge-and-facet":
        return sign(dot(read.way("P", p), read.normal("Q", q)))
    if what == "vertices-meet":
        return int(len({read.sum_of(u[0], v[0]) for u, v in features}) > 1)
    if what == "flat-vertex":
        name, k = ("P", p[0]) if p else ("Q", q[0])
        normals = [read.normal(name, face) for face in read.faces[name] if k in face]
        return int(any(dot(a, cross(b, c)) for a, b, c in combinations(normals, 3)))
    if what == "three-facets":
        return int(not all(map(read.is_facet, features[1:])))
    return _of_planes(what, [read.plane(feature) for feature in features])


def _of_planes(what: str, planes: list[Plane]) -> int:
    (n, d), *others = planes
    if what == "coplanar":
        steps = []
        for m, e in others:
            assert cross(n, m) == ZERO and dot(n, m) > 0
            steps.append(sign(e * dot(n, n) - d * dot(n, m)))
        return next((step for step in steps if step), 0)
    if what == "facing":
        ((m, e),) = others
        assert cross(n, m) == ZERO and dot(n, m) < 0
        return sign(-(e * dot(n, n) - d * dot(n, m)))
    if what == "one-line":
        rows = [(*m, e) for m, e in planes]
        return int(any(
            _determinant([[row[k] for k in columns] for row in three])
            for three in combinations(rows, 3)
            for columns in combinations(range(4), 3)
        ))  # fmt: skip
    assert what == "one-point" and len(planes) == 4
    rows = [(*m, e) for m, e in planes]
    total = Fraction(0)
    for k, row in enumerate(rows):
        rest = [list(other[:3]) for j, other in enumerate(rows) if j != k]
        total += (-1) ** (k + 3) * row[3] * _determinant(rest)
    return sign(total)


def _determinant(rows: list[list[Fraction]]) -> Fraction:
    (a, b, c), (d, e, f), (g, h, i) = rows
    return a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)
