"""A convolution edge's parents, as documents name them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import Any

EdgeRow = tuple[str, int, int, int, int, int]
#: Points, and for each segment between them the edges in contact.
PassageRows = list[tuple[list[tuple[str, str]], list[list[EdgeRow]]]]


def parents(row: tuple[str, int, int, int, int, int]) -> dict[str, Any]:
    """Name the parents in a row from the extension module: the edge's kind, ring and index of the
    parent edge (on P for S, on Q for T) and of the other operand's vertex."""
    kind, _, edge_ring, edge, vertex_ring, vertex = row
    return {"kind": kind, "edge": [edge_ring, edge], "vertex": [vertex_ring, vertex]}


def passages_of(rows: PassageRows) -> list[dict[str, Any]]:
    """List tight passages from the extension module's rows, as documents have them."""
    return _passages(rows, list)


def passage_values(rows: PassageRows) -> list[dict[str, Any]]:
    """List the same for Python: points are pairs of Fractions."""
    return _passages(rows, place_of)


def place_of(texts: Sequence[str]) -> tuple[Fraction, Fraction]:
    x, y = map(Fraction, texts)
    return x, y


def _passages(rows: PassageRows, place: Callable[[Sequence[str]], Any]) -> list[dict[str, Any]]:
    return [
        {
            "points": [place(point) for point in points],
            "contacts": [[parents(edge) for edge in edges] for edges in contacts],
        }
        for points, contacts in rows
    ]
