"""The edges of a convolution as documents and as GeoJSON, some thousand at a time."""

from __future__ import annotations

import json
from collections.abc import Iterator
from typing import Any

from minkref import _core
from minkref.plane.parents import parents

CHUNK = 4096  # edges in memory at a time


def edge_documents(found: _core.Convolution, count: int) -> Iterator[dict[str, Any]]:
    """The first `count` edges: parents, sign, and exact ends and direction."""
    for first, last in _chunks(count):
        for row, start, end, direction in found.rows(first, last):
            yield {
                **parents(row),
                "sign": row[1],
                "start": list(start),
                "end": list(end),
                "direction": list(direction),
            }


def geojson_pieces(found: _core.Convolution, count: int) -> Iterator[str]:
    """A FeatureCollection (RFC 7946), a LineString for each edge, one a line. Coordinates are
    decimals, rounded where there is none; the properties hold the exact numbers."""
    yield '{"type":"FeatureCollection","features":['
    edges = edge_documents(found, count)
    before = "\n"
    for first, last in _chunks(count):
        for start, end in found.decimals(first, last):
            line = f"[[{start[0]},{start[1]}],[{end[0]},{end[1]}]]"
            properties = json.dumps(next(edges), separators=(",", ":"))
            yield (
                f'{before}{{"type":"Feature","geometry":{{"type":"LineString","coordinates":{line}}}'
                f',"properties":{properties}}}'
            )
            before = ",\n"
    yield "\n]}\n" if count else "]}\n"


def refuse_unrepresentable(found: _core.Convolution, count: int) -> None:
    """Raises BadInput where a coordinate rounds to no double."""
    for first, last in _chunks(count):
        found.decimals(first, last)


def _chunks(count: int) -> Iterator[tuple[int, int]]:
    for first in range(0, count, CHUNK):
        yield first, min(first + CHUNK, count)
