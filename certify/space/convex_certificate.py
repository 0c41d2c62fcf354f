"""The producer of certificates for sums of convex polyhedra (docs/certificates-convex.md). The
producer is not trusted: the checker is."""

from __future__ import annotations

import json
from collections.abc import Iterable
from fractions import Fraction
from math import gcd, lcm
from typing import Any, NamedTuple

from minkref import _core
from minkref.argument_types import expect_surfaces, three_exact
from minkref.certify.claims_text import shown
from minkref.exact import digest
from minkref.version import version

Scaling = tuple[str, str, str]  # a factor for each axis, n or n/d
Row = tuple[str, str, str]


class Texts(NamedTuple):
    certificate: str
    case: str


def convex_certificate(
    P: _core.Polyhedron,
    Q: _core.Polyhedron,
    scalings: Iterable[Scaling],
    case: str,
    title: str = "",
    producer: str = "",
) -> Texts:
    """A certificate for SP + Q at each scaling, and the case, which the certificate expects at the
    path `case`. Raises _core.BadInput if an operand is not convex or a scaling not positive."""
    certificate = ConvexCertificate(P, Q)
    for scaling in scalings:
        certificate.sum(scaling)
    return Texts(certificate.text(case, title, producer), certificate.case())


class ConvexCertificate:
    """Sums of two convex polyhedra, each with a proof and a claim. Exact."""

    def __init__(self, P: _core.Polyhedron, Q: _core.Polyhedron) -> None:
        """Raises _core.BadInput where an operand is not valid, not convex or has no volume."""
        expect_surfaces(P=P, Q=Q)
        self.P, self.Q = _Operand(P, "P"), _Operand(Q, "Q")
        self.claims: list[dict[str, Any]] = []
        self._sums: list[dict[str, Any]] = []
        self._numbers: dict[Scaling, int] = {}  # claims' numbers

    def __repr__(self) -> str:
        return shown(self, self.claims)

    def sum(self, scaling: Scaling) -> int:
        """Claims the sum at a scaling. Returns the claim's number: an earlier number if the scaling
        repeats."""
        at = three_exact("scaling", scaling)
        if at in self._numbers:
            return self._numbers[at]
        return self.add(at, _core.convex_sum(self.P.convex, self.Q.convex, at))

    def add(self, scaling: Scaling, found: _core.ConvexSum) -> int:
        """Claims a result that exists already, for these operands at this scaling."""
        at = three_exact("scaling", scaling)
        if at in self._numbers:
            return self._numbers[at]
        vertices = [[self.P.given[p], self.Q.given[q]] for p, q in found.vertex_parents]
        parents = [(self.P.face(p), self.Q.face(q)) for p, q in found.facet_parents]
        rings = found.surface.rings()
        facets = [[ring, *of] for ring, of in zip(rings, parents, strict=True)]
        self._sums.append({"scaling": at, "vertices": vertices, "facets": facets})
        self.claims.append(
            {
                "claim": "sum",
                "sum": len(self._sums) - 1,
                "scaling": at,
                "vertices": len(vertices),
                "facets": len(facets),
                "volume": str(found.surface.sextuple_volume() / 6),
                "digest": digest(found.surface.canonical_json()),
            }
        )
        self._numbers[at] = len(self.claims) - 1
        return self._numbers[at]

    def text(self, case: str, title: str = "", producer: str = "") -> str:
        """The certificate; `case`: the path to the case, relative to the certificate."""
        head = {
            "certificate": "convex-certificate-v1",
            "title": title,
            "producer": producer or f"minkref {version()}",
            "case": {"path": case, "sha256": self.case_digest()},
        }
        told = {name: value for name, value in head.items() if value}
        parts = [f'"{name}":{json.dumps(told[name], ensure_ascii=False)}' for name in told]
        parts += [f'"sums":{_compact(self._sums)}', f'"claims":{_compact(self.claims)}']
        return "{" + ",\n".join(parts) + "}\n"

    def case_digest(self) -> str:
        """The digest of both operands, by which the certificate names the case."""
        return digest(f'{{"P":{self.P.plain},"Q":{self.Q.plain}}}')

    def case(self) -> str:
        """The text of the certified case."""
        return f'{{"dimension":3,\n"P":{self.P.plain},\n"Q":{self.Q.plain}}}\n'


class _Operand:
    """A given polyhedron, and the strictly convex polyhedron that the reference makes from it: the
    same set without flat vertices, which lie inside a facet or an edge."""

    def __init__(self, surface: _core.Polyhedron, name: str) -> None:
        self.convex = _core.ConvexPolyhedron(surface, name)
        points, rings = surface.written_points(), surface.rings()
        self.plain = _compact({"faces": rings, "vertices": points})
        place = {point: i for i, point in enumerate(points)}
        hull = self.convex.surface()
        self.given = [place[point] for point in hull.written_points()]  # the number of each vertex
        self._flat: dict[int, list[tuple[int, set[int]]]] = {}
        if len(self.given) < len(points):
            facets = ([self.given[i] for i in ring] for ring in hull.rings())
            self._find_flat(_whole(points), rings, list(facets))

    def face(self, corners: Iterable[int]) -> list[int]:
        """All given vertices on the face with these corners: a face holds a flat vertex if the face
        holds the smallest face around the vertex."""
        found = {self.given[corner] for corner in corners}
        flat = [v for i in found for v, carrier in self._flat.get(i, ()) if carrier <= found]
        return sorted(found.union(flat))

    def _find_flat(
        self, points: list[tuple[int, ...]], rings: list[list[int]], facets: list[list[int]]
    ) -> None:
        """Sets `_flat`: the flat vertices, each with the corners of the smallest face around the
        vertex, by the least corner. Intersecting the facets around the vertex gives this face."""
        facet_of = {_normal([points[i] for i in facet]): set(facet) for facet in facets}
        carriers: dict[int, set[int]] = {}
        for ring in rings:
            facet = facet_of[_normal([points[i] for i in ring])]
            for v in ring:
                carriers[v] = carriers.get(v, facet) & facet
        for v in sorted(carriers.keys() - set(self.given)):
            self._flat.setdefault(min(carriers[v]), []).append((v, carriers[v]))


def _whole(points: list[Row]) -> list[tuple[int, ...]]:
    """The points times a common denominator."""
    exact = [tuple(map(Fraction, point)) for point in points]
    unit = lcm(*(c.denominator for point in exact for c in point))
    return [tuple(int(c * unit) for c in point) for point in exact]


def _normal(ring: list[tuple[int, ...]]) -> tuple[int, ...]:
    """Primitive, to the side from which the ring runs counter-clockwise."""
    area = [0, 0, 0]
    for a, b in zip(ring, ring[1:] + ring[:1], strict=True):
        for k in range(3):
            u, v = (k + 1) % 3, (k + 2) % 3
            area[k] += a[u] * b[v] - a[v] * b[u]
    divisor = gcd(*area)
    return tuple(c // divisor for c in area)


def _compact(value: Any) -> str:
    return json.dumps(value, separators=(",", ":"))
