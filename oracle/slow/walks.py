"""From directed boundary edges, with the set to their left, to components, rings and pinches.

docs/definitions.md, "Canonical form", states the rules: pair edges so that each pair bounds one
wedge of the interior, then split the closed walks at repeated vertices into simple rings. The same
edges, reversed, bound the complement, whose components come from the same code. An edge that runs
both ways (a slit) belongs to both sides and separates two components.

Only directions (integers) and the vertices' order decide anything here, so coordinates may have any
ordered kind of numbers; this code sees them only through `Plane`.
"""

from __future__ import annotations

from collections import defaultdict
from dataclasses import dataclass
from functools import cmp_to_key

from .exact import InputError, Vector, cross, dot
from .plane import Edge, Node, Plane


@dataclass
class Component:
    """A connected component of the open set to the left of the edges."""

    outer: list[Edge]
    holes: list[list[Edge]]


def leaving(d_in: Vector, out: list[Edge]) -> Edge:
    """Return the edge after an edge that arrives along `d_in`: the first clockwise from the way
    back."""
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
    """Walk along each edge once, wedge by wedge. Edges must already be cut at nodes inside them."""
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
    """Split a walk at repeated nodes. Walks do not cross themselves, so the rings are unique."""
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
    """Return 1 for a counter-clockwise simple ring, -1 for a clockwise ring, 0 for a slit there and
    back."""
    low = min(range(len(ring)), key=lambda i: ring[i].start)
    turn = cross(ring[low - 1].d, ring[low].d)
    return (turn > 0) - (turn < 0)


def components(plane: Plane, edges: list[Edge]) -> tuple[list[Component], list[list[Edge]]]:
    """Return the components of the set to the left of the edges, and the holes outside all
    components (which bound an unbounded component). Slits, there and back, bound nothing."""
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
    """List the edges that leave the ring's true corners, starting at the least corner, without
    straight vertices."""
    kept = [edge for index, edge in enumerate(ring) if ring[index - 1].d != edge.d]
    low = min(range(len(kept)), key=lambda i: kept[i].start)
    return kept[low:] + kept[:low]
