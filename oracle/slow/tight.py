"""Tight segments and points as pieces (docs/definitions.md, "Tight passages", "Pieces").

The definition gives the segments: no sum of two pieces' interiors covers them, but sums of closed
pieces cover both their sides. Here they join to maximal polylines.
"""

from __future__ import annotations

from collections import defaultdict

from .outline import Outline
from .plane import Edge, Node


def pieces(found: Outline) -> list[list[Node]]:
    """Return the pieces in canonical form and order. A polyline passes a node where exactly two
    segments meet.

    Cost: linear, plus sorting. Segments must already be cut at each other's ends and at boundary
    nodes, so crossing segments also meet at a node.
    """
    at: dict[Node, list[Edge]] = defaultdict(list)
    for edge in found.slits:
        at[edge.start].append(edge)
        at[edge.end].append(edge.reversed())
    lines: list[list[Edge]] = []
    used: set[tuple[Node, Node]] = set()

    def follow(edge: Edge) -> list[Edge]:
        line = [edge]
        used.update({(edge.start, edge.end), (edge.end, edge.start)})
        while len(at[line[-1].end]) == 2:
            here = line[-1]
            after = next((e for e in at[here.end] if e.end != here.start), None)
            if after is None or (after.start, after.end) in used:
                break
            line.append(after)
            used.update({(after.start, after.end), (after.end, after.start)})
        return line

    for node in sorted(at):
        if len(at[node]) != 2:
            lines += [follow(edge) for edge in at[node] if (edge.start, edge.end) not in used]
    for node in sorted(at):
        # The rest are closed polylines, each apart from all others.
        lines += [follow(edge) for edge in at[node][:1] if (edge.start, edge.end) not in used]
    found_pieces = [canonical(line) for line in lines]
    found_pieces += [[point] for point in found.points]
    return sorted(found_pieces)


def canonical(line: list[Edge]) -> list[Node]:
    """Drop straight vertices, and take the smaller of both directions."""
    bends = [edge.start for i, edge in enumerate(line) if i > 0 and line[i - 1].d != edge.d]
    nodes = [line[0].start, *bends, line[-1].end]
    return min(nodes, nodes[::-1])
