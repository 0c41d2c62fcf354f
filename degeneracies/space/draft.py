"""Drafts from a generator in space, and facts about them."""

from __future__ import annotations

from bisect import bisect_left
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property

from minkref import _core
from minkref.certify.space.convex_certificate import ConvexCertificate
from minkref.degeneracies.family import Family
from minkref.degeneracies.space.body import Body, Corners, Facet
from minkref.degeneracies.space.doubles import signs_in_doubles
from minkref.degeneracies.space.vectors import direction, inverse
from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.geometry.space import Point, Whole, cross, dot

LARGEST_GAP = 8000  # 2^-k beside a factor is looked at down to this k
FINE = 60  # bits: a sibling lies this near; neighbouring doubles lie 52 or 53 bits apart
ONE = (Fraction(1),) * 3
VERTEX, EDGE, FACET = "vertex", "edge", "facet"


@dataclass(frozen=True)
class SpaceDraft:
    """Two bodies, the degenerate scaling, and the axis along which its siblings lie. `others`:
    further scalings for the family's statement."""

    P: Polyhedron
    Q: Polyhedron
    scaling: Point = ONE
    axis: int = 0
    others: tuple[Point, ...] = ()


@dataclass(frozen=True)
class Coincidence:
    """Faces of P and Q, by the vertices of the clean bodies, for which a predicate is zero.

    - parallel-facets, opposite-facets: the cross product of the normals
    - facet-and-edge, edge-and-facet: the product of the normal with the edge
    - parallel-edges: the cross product of the edges
    - compatible: none; a facet of the sum is the sum of the two
    - nearly-parallel-facets: nothing is zero; the cross product of the normals is small"""

    what: str
    P: Corners
    Q: Corners


@dataclass(frozen=True)
class SumAt:
    """SP + Q at one scaling, with the parent faces for each face."""

    found: _core.ConvexSum
    P: Body
    Q: Body

    @cached_property
    def parents(self) -> list[tuple[Corners, Corners]]:
        """For each facet the faces of P and of Q, vertices ascending."""
        return [(tuple(p), tuple(q)) for p, q in self.found.facet_parents]

    @cached_property
    def kinds(self) -> Counter[tuple[str, str]]:
        """Counts facets by their parents' kinds, first in P, then in Q."""
        return Counter((_kind(p), _kind(q)) for p, q in self.parents)

    @cached_property
    def parallel_edges(self) -> list[tuple[Corners, Corners]]:
        """The sum's edges that are sums of two parallel edges from P and Q, whose arcs overlap."""
        of = self.found.vertex_parents
        found = set()
        for ring in self.found.surface.rings():
            for a, b in zip(ring, ring[1:] + ring[:1], strict=True):
                (p, q), (u, v) = of[a], of[b]
                if p != u and q != v:
                    found.add(((min(p, u), max(p, u)), (min(q, v), max(q, v))))
        return sorted(found)

    @cached_property
    def structure(self) -> frozenset[tuple[Corners, Corners]]:
        """A value that two sums share if their facets are sums of the same faces."""
        return frozenset(self.parents)

    @property
    def facets_on_facets(self) -> int:
        return self.kinds[(FACET, FACET)]

    @property
    def facets_on_edges(self) -> int:
        return self.kinds[(FACET, EDGE)] + self.kinds[(EDGE, FACET)]

    @property
    def counts(self) -> dict[str, int]:
        """Facets of the sum by their parents' kinds, irrespective of which belongs to P; and the
        sum's edges made from two parallel edges."""
        return {
            "facet_and_facet": self.facets_on_facets,
            "facet_and_edge": self.facets_on_edges,
            "facet_and_vertex": self.kinds[(FACET, VERTEX)] + self.kinds[(VERTEX, FACET)],
            "edge_and_edge": self.kinds[(EDGE, EDGE)],
            "parallel_edges": len(self.parallel_edges),
        }


@dataclass(frozen=True)
class SpaceFacts:
    """A draft as the reference sees it. All exact, computed when asked for."""

    P: Body
    Q: Body
    scaling: Point
    axis: int
    others: tuple[Point, ...]
    _sums: dict[Point, SumAt] = field(default_factory=dict, compare=False)

    @classmethod
    def of(cls, draft: SpaceDraft) -> SpaceFacts:
        """Raises _core.BadInput if an operand is no convex body."""
        P, Q = Body(draft.P, "P"), Body(draft.Q, "Q")
        P.certify()
        Q.certify()
        return cls(P, Q, draft.scaling, draft.axis, draft.others)

    def sum(self, scaling: Point | None = None) -> SumAt:
        """Returns the sum at the draft's scaling, or at another."""
        at = scaling or self.scaling
        if at not in self._sums:
            x, y, z = at
            found = _core.convex_sum(self.P.convex, self.Q.convex, (str(x), str(y), str(z)))
            self._sums[at] = SumAt(found, self.P, self.Q)
        return self._sums[at]

    @cached_property
    def certificate(self) -> ConvexCertificate:
        made = ConvexCertificate(self.P.surface, self.Q.surface)
        for at in self.scalings:
            x, y, z = at
            made.add((str(x), str(y), str(z)), self.sum(at).found)
        return made

    @cached_property
    def scalings(self) -> list[Point]:
        """The scaling; its siblings, with one factor ± 2^-k: the nearest such steps apart from
        other critical factors, and still smaller steps; and the others."""
        factor = self.scaling[self.axis]
        size = factor.denominator.bit_length() - factor.numerator.bit_length()
        steps = sorted({self.gap, max(self.gap, FINE + size)})
        near = [Fraction(1, 2**k) for k in steps]
        found = [self.scaling, *(self.beside(-d) for d in near), *(self.beside(d) for d in near)]
        return list(dict.fromkeys((*found, *self.others)))

    def beside(self, step: Fraction) -> Point:
        x, y, z = (f + step * (k == self.axis) for k, f in enumerate(self.scaling))
        return x, y, z

    @cached_property
    def near(self) -> tuple[Point, Point]:
        """Below and above, with no critical factor between."""
        step = Fraction(1, 2**self.gap)
        return self.beside(-step), self.beside(step)

    @cached_property
    def gap(self) -> int:
        """The least k > 0 such that no other factor within 2^-k is critical along the axis."""
        factor = self.scaling[self.axis]
        gaps = (abs(root - factor) for root in self.roots if root != factor)
        room = min((*gaps, factor))
        found = bisect_left(range(LARGEST_GAP), True, 1, key=lambda k: Fraction(1, 2**k) < room)
        if found >= LARGEST_GAP:
            raise ValueError(f"another event is within 2^-{LARGEST_GAP} of {factor}")
        return found

    @cached_property
    def roots(self) -> set[Fraction]:
        """The factors along the axis, with the other two fixed, at which the product of one body's
        normal and the other's edge vanishes, unless it always does. Between roots the sum keeps its
        faces."""
        found = set()
        k = self.axis
        for normal, along, power in self._pairs():
            own = normal[k] * along[k]
            rest = sum(
                Fraction(normal[j] * along[j]) * self.scaling[j] ** power
                for j in range(3)
                if j != k
            )
            if own and rest and (own > 0) != (rest > 0):
                root = -rest / own
                found.add(root if power > 0 else 1 / root)
        return found

    def _pairs(self) -> Iterator[tuple[Whole, Whole, int]]:
        """A normal, an edge, and the power of the factors in their product."""
        for facets, edges, power in ((self.P, self.Q, -1), (self.Q, self.P, 1)):
            normals = sorted({facet.normal for facet in facets.facets})
            along = sorted({_upwards(edge.direction) for edge in edges.edges})
            for n in normals:
                for d in along:
                    yield n, d, power

    def weights(self, at: Point | None = None) -> tuple[Whole, Whole]:
        """Whole factors in proportion to 1 / s_i, for normals of P, and to s_i, for its edges."""
        factors = at or self.scaling
        return direction(inverse(factors)), direction(factors)

    def signs(self, at: Point | None = None) -> list[int]:
        """Signs for all facets of one body with all edges of the other: first the facets of P."""
        down, up = self.weights(at)
        found = []
        for facet in self.P.facets:
            n = _weighted(facet.normal, down)
            found += [_sign(dot(n, edge.direction)) for edge in self.Q.edges]
        along = [_weighted(edge.direction, up) for edge in self.P.edges]
        for facet in self.Q.facets:
            found += [_sign(dot(facet.normal, d)) for d in along]
        return found

    def signs_in_doubles(self, at: Point | None = None) -> list[int | None]:
        factors = at or self.scaling
        return [
            *signs_in_doubles(self.P, self.Q, (factors, ONE)),
            *signs_in_doubles(self.Q, self.P, (ONE, factors)),
        ]

    def wrong_in_doubles(self, at: Point | None = None) -> int:
        """How many of the signs doubles have otherwise, decided the plain way."""
        pairs = zip(self.signs(at), self.signs_in_doubles(at), strict=True)
        return sum(exact != found for exact, found in pairs)

    def directions_of_P(self, at: Point | None = None) -> list[Whole]:
        """The directions of the normals of S P."""
        down, _ = self.weights(at)
        return [direction(_weighted(facet.normal, down)) for facet in self.P.facets]

    def facet_pairs(self, at: Point | None = None, sign: int = 1) -> list[tuple[Facet, Facet]]:
        """Facets of P and Q with the same normal at the scaling; with opposite ones for -1."""
        of_Q = {facet.normal: facet for facet in self.Q.facets}
        return [
            (facet, of_Q[wanted])
            for facet, n in zip(self.P.facets, self.directions_of_P(at), strict=True)
            for wanted in [(sign * n[0], sign * n[1], sign * n[2])]
            if wanted in of_Q
        ]

    def value(self, shown: Coincidence, at: Point) -> int:
        """The value of a coincidence's predicate at a scaling: its sign, or 1 if a cross product
        does not vanish, or the faces are no longer farthest in one direction."""
        if shown.what == "compatible":
            return int((shown.P, shown.Q) not in self.sum(at).structure)
        first, second = self.P.directions[shown.P], self.Q.directions[shown.Q]
        down, up = self.weights(at)
        first = _weighted(first, up if len(shown.P) == 2 else down)
        if shown.what in ("facet-and-edge", "edge-and-facet"):
            return _sign(dot(first, second))
        return int(cross(first, second) != (0, 0, 0))

    def pairs_of_signs(self) -> Iterator[tuple[Corners, Corners]]:
        """Yields the faces of P and Q behind each entry of `signs`."""
        for facet in self.P.facets:
            for edge in self.Q.edges:
                yield facet.corners, edge.ends
        for facet in self.Q.facets:
            for edge in self.P.edges:
                yield edge.ends, facet.corners

    @cached_property
    def numbers(self) -> list[Fraction]:
        """All coordinates of both bodies."""
        return [c for body in (self.P, self.Q) for vertex in body.given.vertices for c in vertex]


class SpaceFamily(Family[SpaceDraft, SpaceFacts]):
    """A family of bodies in space: `belongs` gives some coincidences."""

    def look(self, draft: SpaceDraft) -> SpaceFacts:
        return SpaceFacts.of(draft)


def _kind(face: Corners) -> str:
    return (VERTEX, EDGE, FACET)[min(len(face), 3) - 1]


def _weighted(vector: Whole, weights: Whole) -> Whole:
    return vector[0] * weights[0], vector[1] * weights[1], vector[2] * weights[2]


def _upwards(vector: Whole) -> Whole:
    """The same for a direction and its opposite."""
    return max(vector, (-vector[0], -vector[1], -vector[2]))


def _sign(value: Fraction | int) -> int:
    return (value > 0) - (value < 0)
