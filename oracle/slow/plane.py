"""Directed edges between nodes in the plane, over any ordered kind of numbers.

The keys of its coordinates (germ.py) identify a node: keys equal and order lexicographically
exactly like the points. All other questions about points are answered here.
"""

from __future__ import annotations

import itertools
from bisect import bisect_left, bisect_right
from dataclasses import dataclass, field

from .exact import Vector
from .germ import Number

Node = tuple[Number, Number]  # a vertex's key: equality and order as for points


@dataclass
class Edge:
    """An edge from `start` to `end` along `d` (primitive), on the line cross(d, x) = `offset`."""

    start: Node
    end: Node
    d: Vector
    offset: Number

    def reversed(self) -> Edge:
        return Edge(self.end, self.start, (-self.d[0], -self.d[1]), -self.offset)


@dataclass
class Plane:
    """The nodes' points: x and y are the first two numbers over the third, a positive integer."""

    points: dict[Node, tuple[Number, Number, int]] = field(default_factory=dict)

    def is_on(self, node: Node, edge: Edge) -> bool:
        """Tell whether the edge's line contains the node."""
        x, y, den = self.points[node]
        return bool(y * edge.d[0] - x * edge.d[1] == edge.offset * den)

    def contains(self, edge: Edge, node: Node) -> bool:
        """Tell whether the closed edge contains the node."""
        low, high = sorted((edge.start, edge.end))
        return bool(low <= node <= high) and self.is_on(node, edge)

    def split(self, edges: list[Edge]) -> list[Edge]:
        """Cut edges at their nodes."""
        return self.cut(edges, set())

    def cut(self, edges: list[Edge], more: set[Node]) -> list[Edge]:
        """Cut edges at their nodes and at `more` nodes. Cost: nodes times edges."""
        nodes = sorted({end for edge in edges for end in (edge.start, edge.end)} | more)
        parts: list[Edge] = []
        for edge in edges:
            low, high = sorted((edge.start, edge.end))
            between = nodes[bisect_right(nodes, low) : bisect_left(nodes, high)]
            cuts = [node for node in between if self.is_on(node, edge)]
            if edge.start == high:
                cuts.reverse()
            stops = [edge.start, *cuts, edge.end]
            parts += [Edge(a, b, edge.d, edge.offset) for a, b in itertools.pairwise(stops)]
        return parts

    def left_of(self, middle: tuple[Number, Number, int], edge: Edge) -> bool:
        x, y, den = middle
        return bool(y * edge.d[0] - x * edge.d[1] > edge.offset * den)

    def middle(self, edge: Edge) -> tuple[Number, Number, int]:
        x0, y0, den0 = self.points[edge.start]
        x1, y1, den1 = self.points[edge.end]
        return x0 * den1 + x1 * den0, y0 * den1 + y1 * den0, 2 * den0 * den1

    def holds(self, ring: list[Edge], point: tuple[Number, Number, int]) -> bool:
        """Tell whether the ring surrounds the point, which must lie on no edge."""
        x, _, den = point
        odd = False
        for edge in ring:
            x0, _, den0 = self.points[edge.start]
            x1, _, den1 = self.points[edge.end]
            if (x0 * den <= x * den0) != (x1 * den <= x * den1):
                # Below the point iff the point lies to the left of an edge that runs to the right.
                odd ^= self.left_of(point, edge) == (edge.d[0] > 0)
        return odd
