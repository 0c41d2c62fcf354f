"""The parents of a convolution edge, as documents name them."""

from __future__ import annotations

from typing import Any

EdgeRow = tuple[str, int, int, int, int, int]
#: Points, and for each segment between them the edges in contact.
PassageRows = list[tuple[list[tuple[str, str]], list[list[EdgeRow]]]]


def parents(row: tuple[str, int, int, int, int, int]) -> dict[str, Any]:
    """A row of the extension module: the kind of the edge, ring and index of the edge (of P for S,
    of Q for T) and of the vertex of the other operand."""
    kind, _, edge_ring, edge, vertex_ring, vertex = row
    return {"kind": kind, "edge": [edge_ring, edge], "vertex": [vertex_ring, vertex]}


def passages_of(rows: PassageRows) -> list[dict[str, Any]]:
    """Tight passages, from the rows of the extension module."""
    return [
        {
            "points": [list(point) for point in points],
            "contacts": [[parents(edge) for edge in edges] for edges in contacts],
        }
        for points, contacts in rows
    ]
