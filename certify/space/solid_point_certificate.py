"""The producer of certificates for points of sums of polyhedra (docs/certificates-solids.md,
Points). The producer is not trusted: the checker is."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import chain, product
from math import lcm
from typing import Any

from minkref.argument_types import three_exact
from minkref.certify.plane.certificate import NoProof
from minkref.certify.space.solid_pieces import Hull, Whole, hulls_at, inner, minus, outer, primitive
from minkref.certify.space.tiled_solids import TiledSolids
from minkref.errors import Refusal

SIMPLEST = ((1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1))
Place = tuple[Fraction, Fraction, Fraction]
Number = str | int | Fraction
Three = tuple[Number, Number, Number]


class SolidPointCertificate(TiledSolids):
    """Proves where points lie: in the sum of two polyhedra, or outside. Scalings and points are
    three exact numbers. Exact. A point costs a test for each pair of convex pieces; this computes
    no sum."""

    form = "solid-point-certificate-v1"

    def point(self, scaling: Three, point: Three) -> int:
        """Claims a point inside the sum, with p and q; returns the claim's number. Raises NoProof
        for a point outside."""
        asked = _Asked(self, scaling, point)
        for (i, A), (j, B) in product(enumerate(asked.P), enumerate(asked.Q)):
            found = asked.meeting(A, B)
            if found is not None:
                p, q = asked.parts(found)
                return self._claim("point", asked, p=p, q=q, pieces=[i, j])
        raise NoProof(f"the point ({', '.join(asked.point)}) is not in the sum")

    def outside(self, scaling: Three, point: Three) -> int:
        """Claims a point outside the sum, with a normal for each pair of pieces; returns the
        claim's number. Raises NoProof for a point inside."""
        asked = _Asked(self, scaling, point)
        numbers: dict[Whole, int] = {}
        code = []
        for A, B in product(asked.P, asked.Q):
            normal = next((n for n in _normals(A, B, numbers) if asked.is_apart(n, A, B)), None)
            if normal is None:
                raise NoProof(f"the point ({', '.join(asked.point)}) is in the sum")
            code.append(numbers.setdefault(normal, len(numbers)))
        return self._claim("outside", asked, normals=[list(n) for n in numbers], code=code)

    def _claim(self, claim: str, asked: _Asked, /, **members: Any) -> int:
        said = {"claim": claim, "scaling": list(asked.scaling), "point": list(asked.point)}
        self.claims.append({**said, **members})
        return len(self.claims) - 1


class _Asked:
    """A point and both operands' pieces at a scaling, times a unit: all numbers become whole."""

    def __init__(self, of: SolidPointCertificate, scaling: Three, point: Three) -> None:
        self.scaling, self.point = three_exact("scaling", scaling), three_exact("point", point)
        if min(map(Fraction, self.scaling)) <= 0:
            raise Refusal(
                "a factor of the scaling is not positive", "scaling", "give three above 0"
            )
        common = lcm(*(Fraction(c).denominator for c in (*self.scaling, *self.point)))
        first, second = of._tilings
        self.unit = lcm(first.unit(), second.unit()) * common
        self.P = hulls_at(first, self.scaling, self.unit)
        self.Q = hulls_at(second, ("1", "1", "1"), self.unit)
        x, y, z = (int(Fraction(c) * self.unit) for c in self.point)
        self.x: Whole = (x, y, z)

    def is_apart(self, n: Whole, A: Hull, B: Hull) -> bool:
        return inner(n, self.x) > A.support(n) + B.support(n)

    def meeting(self, A: Hull, B: Hull) -> Place | None:
        """Finds a point a in A with x - a in B: A meets a mirror image of B."""
        if any(self.is_apart(n, A, B) for n in SIMPLEST):
            return None
        mirrored = Hull([[minus(self.x, p) for p in ring[::-1]] for ring in B.facets.values()])
        for one, other in ((A, mirrored), (mirrored, A)):
            for ring in one.facets.values():
                polygon = [_place(p) for p in ring]
                for half in other.levels:
                    polygon = _below(polygon, half)
                if polygon:
                    return polygon[0]
            if other.holds(one.corners[0]):
                return _place(one.corners[0])
        return None

    def parts(self, found: Place) -> tuple[list[str], list[str]]:
        """p and q."""
        p, q = [], []
        for factor, a, x in zip(self.scaling, found, self.x, strict=True):
            p.append(str(a / self.unit / Fraction(factor)))
            q.append(str((x - a) / self.unit))
        return p, q


def _normals(A: Hull, B: Hull, known: dict[Whole, int]) -> Iterator[Whole]:
    """Yields normals already used, then all normals that decide membership for A + B."""
    yield from [*reversed(known), *SIMPLEST]
    yield from chain(A.facets, B.facets)
    for e, f in product(A.ways, B.ways):
        way = primitive(outer(e, f))
        if any(way):
            yield from (way, (-way[0], -way[1], -way[2]))


def _below(polygon: Sequence[Place], half: tuple[Whole, int]) -> list[Place]:
    """The closed part of a convex polygon below a plane."""
    (a, b, c), level = half
    heights = [a * x + b * y + c * z - level for x, y, z in polygon]
    kept: list[Place] = []
    for k, end in enumerate(polygon):
        s, e = heights[k - 1], heights[k]
        if (s < 0 < e) or (e < 0 < s):
            start, t = polygon[k - 1], s / (s - e)
            x, y, z = (u + t * (v - u) for u, v in zip(start, end, strict=True))
            kept.append((x, y, z))
        if e <= 0:
            kept.append(end)
    return kept


def _place(p: Whole) -> Place:
    return Fraction(p[0]), Fraction(p[1]), Fraction(p[2])
