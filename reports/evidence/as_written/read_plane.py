"""Readers for polygon sets: WKT, GeoJSON, `.poly`, plain JSON. Coordinates stay texts.

Each reader knows only its format's rules, and raises ValueError for everything else.
"""

from __future__ import annotations

import json
import re
from typing import Any

Pair = tuple[str, str]
Polygons = list[list[list[Pair]]]  # each polygon's rings, the outer ring first

TOKEN = re.compile(r"\s*(?:([A-Za-z]+)|([-+0-9.][-+0-9.eE/]*)|([(),]))")


def wkt(text: str) -> Polygons:
    """Reads POLYGON and MULTIPOLYGON, also when empty; drops each ring's repeated vertex."""
    tokens = _tokens(text.strip())
    kind = next(tokens).upper()
    if kind not in ("POLYGON", "MULTIPOLYGON"):
        raise ValueError(f"{kind} is no polygon")
    rest = list(tokens)
    if [token.upper() for token in rest] == ["EMPTY"]:
        return []
    value, end = _nested(rest, 0)
    if end != len(rest):
        raise ValueError("more than one geometry")
    return [
        [_closed(ring) for ring in polygon] for polygon in ([value] if kind == "POLYGON" else value)
    ]


def _tokens(text: str) -> Any:
    at = 0
    while at < len(text):
        found = TOKEN.match(text, at)
        if not found:
            raise ValueError(f"no word of WKT at {text[at : at + 20]!r}")
        at = found.end()
        yield found[1] or found[2] or found[3]


def _nested(tokens: list[str], at: int) -> tuple[Any, int]:
    """A bracketed list, with lists or points inside."""
    if tokens[at] != "(":
        return _point(tokens, at)
    items, at = [], at + 1
    while True:
        item, at = _nested(tokens, at)
        items.append(item)
        if tokens[at] == ")":
            return items, at + 1
        if tokens[at] != ",":
            raise ValueError(f"{tokens[at]!r} in a list")
        at += 1


def _point(tokens: list[str], at: int) -> tuple[Pair, int]:
    if tokens[at + 2] not in (",", ")"):
        raise ValueError("a point of the plane has two numbers")
    return (tokens[at], tokens[at + 1]), at + 2


def _closed(ring: list[Pair]) -> list[Pair]:
    if len(ring) < 4 or ring[0] != ring[-1]:
        raise ValueError("a ring ends where it starts")
    return ring[:-1]


class _Text(str):
    """A JSON text's number, unchanged."""


def load(text: str) -> Any:
    """JSON whose numbers stay texts; refuses NaN and infinity."""

    def refuse(name: str) -> Any:
        raise ValueError(f"{name} is no number of JSON")

    return json.loads(text, parse_float=_Text, parse_int=_Text, parse_constant=refuse)


def geojson(text: str) -> Polygons:
    value = load(text)
    if value["type"] == "Feature":
        value = value["geometry"]
    if value["type"] not in ("Polygon", "MultiPolygon"):
        raise ValueError(f"{value['type']} is no polygon")
    at = value["coordinates"]
    polygons = [at] if value["type"] == "Polygon" and at else at
    return [[_closed([(x, y) for x, y in ring]) for ring in polygon] for polygon in polygons]


def plain_json(text: str) -> Polygons:
    return polygons_of(load(text))


def polygons_of(value: Any) -> Polygons:
    """The set that plain JSON describes."""
    return [
        [[(x, y) for x, y in ring] for ring in (one["outer"], *one["holes"])]
        for one in value["polygons"]
    ]


def poly(text: str) -> Polygons:
    """Rings in the file's order; a hole joins the outer ring before it."""
    words = [line.split("#")[0].split() for line in text.splitlines()]
    lines = iter([line for line in words if line])
    (count,) = next(lines)
    polygons: Polygons = []
    for _ in range(int(count)):
        size, kind = next(lines)
        ring = [(x, y) for x, y in (next(lines) for _ in range(int(size)))]
        order: list[int] = []
        while len(order) < int(size):
            order += map(int, next(lines))
        ring = [ring[k - 1] for k in order]
        if kind == "out":
            polygons.append([ring])
        elif kind == "in":
            polygons[-1].append(ring)
        else:
            raise ValueError(f"a ring is out or in, not {kind}")
    return polygons
