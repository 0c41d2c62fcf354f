"""The reduced convolution's edges as moving segments, by the rule of compatibility.

docs/definitions.md, Compatibility. An operand is a list of rings, outer rings counter-clockwise and
holes clockwise; ring and index name a feature, and an edge has the index of its start.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from .moving import MovingSegment, Point, cross
from .rational import rationals
from .standing import minus

Ring = Sequence[Point]
Feature = tuple[int, int]


@dataclass(frozen=True, slots=True)
class ConvolutionEdge:
    """A moving segment with its parents: one operand's edge, and the other's vertex."""

    segment: MovingSegment
    edge: Feature
    vertex: Feature

    @property
    def parents(self) -> tuple[str, int, int, int, int]:
        return (self.segment.kind, *self.edge, *self.vertex)


def edges(rings: Sequence[Ring]) -> Iterator[tuple[Feature, Point, Point]]:
    for r, ring in enumerate(rings):
        for i, start in enumerate(ring):
            yield (r, i), start, ring[(i + 1) % len(ring)]


def convex_vertices(rings: Sequence[Ring]) -> Iterator[tuple[Feature, Point, Point, Point]]:
    """Yield strictly convex vertices with the directions of their incoming and outgoing edges."""
    for r, ring in enumerate(rings):
        for i, at in enumerate(ring):
            into, out = minus(at, ring[i - 1]), minus(ring[(i + 1) % len(ring)], at)
            if cross(into, out) > 0:
                yield (r, i), at, into, out


def reduced_convolution(P: Sequence[Ring], Q: Sequence[Ring]) -> list[ConvolutionEdge]:
    """Find S-edges, then T-edges, ordered by edge, then by vertex. O(mn), exact."""
    found = []
    for edge, a, b in edges(P):
        d = minus(b, a)
        for vertex, at, into, out in convex_vertices(Q):
            if cross(into, d) >= 0 and cross(d, out) > 0:  # [in, out)
                segment = MovingSegment("S", rationals((*a, *b, *at)))
                found.append(ConvolutionEdge(segment, edge, vertex))
    for edge, a, b in edges(Q):
        d = minus(b, a)
        for vertex, at, into, out in convex_vertices(P):
            if cross(into, d) > 0 and cross(d, out) >= 0:  # (in, out]
                segment = MovingSegment("T", rationals((*at, *a, *b)))
                found.append(ConvolutionEdge(segment, edge, vertex))
    return found
