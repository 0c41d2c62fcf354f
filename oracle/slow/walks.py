"""From directed boundary edges, with the set on their left, to components, rings and pinches.

The rules are those of docs/definitions.md, "Canonical form": edges are paired so that each pair
bounds one wedge of the interior, the closed walks are split at repeated vertices into simple rings.
The same edges reversed bound the complement, so its components come from the same code. An edge
that is there both ways (a slit) belongs to both sides: what it cuts apart are two components.

Only directions (integers) and the order of vertices decide anything here, so the coordinates may be
numbers of any ordered kind; they are seen through `Plane` alone.
"""

from __future__ import annotations

import itertools
from bisect import bisect_left, bisect_right
from collections import defaultdict
from dataclasses import dataclass, field
from functools import cmp_to_key

from .exact import InputError, Vector, cross, dot
from .germ import Number

Node = tuple[Number, Number]  # the key of a vertex: equal iff the points are, ordered as they are


@dataclass
class Edge:
    """From `start` to `end` in the direction `d` (primitive), on the line cross(d, x) =
    `offset`."""

    start: Node
    end: Node
    d: Vector
    offset: Number

    def reversed(self) -> Edge:
        return Edge(self.end, self.start, (-self.d[0], -self.d[1]), -self.offset)


@dataclass
class Plane:
    """The points of the nodes: x and y are the first two over the third, an integer above zero."""

    points: dict[Node, tuple[Number, Number, int]] = field(default_factory=dict)

    def is_on(self, node: Node, edge: Edge) -> bool:
        """Whether the node lies on the line of the edge."""
        x, y, den = self.points[node]
        return bool(y * edge.d[0] - x * edge.d[1] == edge.offset * den)

    def contains(self, edge: Edge, node: Node) -> bool:
        """Whether the node is a point of the closed edge."""
        low, high = sorted((edge.start, edge.end))
        return bool(low <= node <= high) and self.is_on(node, edge)

    def split(self, edges: list[Edge]) -> list[Edge]:
        """The edges, cut at every node of them that lies inside of one."""
        return self.cut(edges, set())

    def cut(self, edges: list[Edge], more: set[Node]) -> list[Edge]:
        """The edges, cut at their nodes and at `more` nodes. Cost: nodes times edges."""
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
        """Whether the point, which is on no edge of the ring, is inside."""
        x, _, den = point
        odd = False
        for edge in ring:
            x0, _, den0 = self.points[edge.start]
            x1, _, den1 = self.points[edge.end]
            if (x0 * den <= x * den0) != (x1 * den <= x * den1):
                # Under the point iff it is on the left of an edge that runs to the right.
                odd ^= self.left_of(point, edge) == (edge.d[0] > 0)
        return odd


@dataclass
class Component:
    """One connected component of the open set on the left of the edges."""

    outer: list[Edge]
    holes: list[list[Edge]]


def leaving(d_in: Vector, out: list[Edge]) -> Edge:
    """The edge after one that arrives in the direction `d_in`: the first clockwise from where it
    came."""
    if len(out) == 1:
        return out[0]
    back = (-d_in[0], -d_in[1])

    def sector(v: Vector) -> int:
        turn = cross(back, v)
        if turn:
            return 0 if turn < 0 else 2
        return 1 if dot(back, v) < 0 else 3

    def order(a: Edge, b: Edge) -> int:
        return sector(a.d) - sector(b.d) or cross(a.d, b.d)

    return min(out, key=cmp_to_key(order))


def closed_walks(edges: list[Edge]) -> list[list[Edge]]:
    """Each edge once, wedge by wedge. Edges must already be cut at the nodes on them."""
    out: dict[Node, list[Edge]] = defaultdict(list)
    for edge in edges:
        out[edge.start].append(edge)
    done: set[int] = set()
    walks = []
    for first in edges:
        if id(first) in done:
            continue
        walk: list[Edge] = []
        edge = first
        while id(edge) not in done:
            done.add(id(edge))
            walk.append(edge)
            if not out[edge.end]:
                raise InputError("the boundary does not close: rings cross or overlap")
            edge = leaving(edge.d, out[edge.end])
        if edge is not first:
            raise InputError("the boundary does not close: rings cross or overlap")
        walks.append(walk)
    return walks


def simple_rings(walk: list[Edge]) -> list[list[Edge]]:
    """The walk, split at repeated nodes. Walks do not cross themselves, so the rings are
    determined."""
    rings = []
    stack: list[Edge] = []
    depth: dict[Node, int] = {}
    for edge in walk:
        depth[edge.start] = len(stack)
        stack.append(edge)
        if edge.end in depth:
            ring = stack[depth[edge.end] :]
            del stack[depth[edge.end] :]
            for part in ring:
                del depth[part.start]
            rings.append(ring)
    return rings


def turn_of(ring: list[Edge]) -> int:
    """1 if a simple ring runs counter-clockwise, -1 if clockwise, 0 if it is a slit there and
    back."""
    low = min(range(len(ring)), key=lambda i: ring[i].start)
    turn = cross(ring[low - 1].d, ring[low].d)
    return (turn > 0) - (turn < 0)


def components(plane: Plane, edges: list[Edge]) -> tuple[list[Component], list[list[Edge]]]:
    """The components of the set on the left of the edges, and the holes that lie in none of them
    (they bound an unbounded component). Rings that are slits, there and back, bound nothing."""
    found: list[Component] = []
    lone: list[list[list[Edge]]] = []
    for walk in closed_walks(edges):
        rings = simple_rings(walk)
        turns = [turn_of(ring) for ring in rings]
        outer = [ring for ring, turn in zip(rings, turns, strict=True) if turn > 0]
        holes = [ring for ring, turn in zip(rings, turns, strict=True) if turn < 0]
        if len(outer) > 1:
            raise InputError("a walk has two outer rings: rings cross or overlap")
        if outer:
            found.append(Component(outer[0], holes))
        elif holes:
            lone.append(holes)
    outside: list[list[Edge]] = []
    for rings in lone:
        middle = plane.middle(rings[0][0])
        around = [part for part in found if plane.holds(part.outer, middle)]
        if not around:
            outside += rings
            continue
        innermost = around[0]
        for part in around[1:]:
            if plane.holds(innermost.outer, plane.middle(part.outer[0])):
                innermost = part
        innermost.holes += rings
    return found, outside


def corners(ring: list[Edge]) -> list[Edge]:
    """The edges that leave the ring's true corners, from the least on; straight vertices are
    gone."""
    kept = [edge for index, edge in enumerate(ring) if ring[index - 1].d != edge.d]
    low = min(range(len(kept)), key=lambda i: kept[i].start)
    return kept[low:] + kept[:low]
