"""A result put into canonical form, and the exact difference of two of them."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import Any

from minkref import _core
from minkref.exact import digest

Rings = list[list[list[str]]]


@dataclass
class Region:
    """Canonical form of one result. `degenerate` is a vertex of a ring of fewer than three
    vertices, `overlap` a point where the rings' winding number is neither 0 nor 1."""

    set: _core.PolygonSet
    json: str
    digest: str
    components: int
    holes: int
    degenerate: tuple[str, str] | None = None
    overlap: tuple[str, str] | None = None


def region_of_sum(answer: _core.Sum) -> Region:
    """The result of a reference route, canonical already."""
    text = answer.region.canonical_json()
    return Region(answer.region, text, digest(text), answer.components, answer.holes)


def region_of_rings(rings: dict[str, Any]) -> Region:
    """The result of somebody else: any rings, in any order. Raises ValueError or KeyError where
    it is not in the form of a polygon set."""
    degenerate: tuple[str, str] | None = None
    polygons = []
    for polygon in rings["polygons"]:
        outer, holes = polygon["outer"], polygon.get("holes", [])
        for ring in (outer, *holes):
            _check_form(ring)
            if len(ring) < 3:
                degenerate = (str(ring[0][0]), str(ring[0][1]))
        if len(outer) >= 3:
            polygons.append({"outer": outer, "holes": [hole for hole in holes if len(hole) >= 3]})
    given = _core.PolygonSet.from_json(json.dumps({"polygons": polygons}))
    canonical, components, holes_count, well_formed = _core.canonicalize(given)
    text = canonical.canonical_json()
    overlap = None if well_formed else _overlap(polygons, json.loads(text)["polygons"])
    return Region(canonical, text, digest(text), components, holes_count, degenerate, overlap)


def _check_form(ring: Any) -> None:
    """Refuses (ValueError) what is not a list of points with numbers as texts or integers."""
    if not isinstance(ring, list) or not ring:
        raise ValueError("a ring is not a list of points")
    for point in ring:
        if (
            not isinstance(point, list | tuple)
            or len(point) != 2
            or not all(isinstance(number, str | int) for number in point)
        ):
            raise ValueError("a point is not a pair of exact numbers")


def minus(first: str, second: str) -> _core.PolygonSet:
    """The closure of `first` without `second` (canonical JSON texts), canonical: where the winding
    number of the rings of `first` and the reversed rings of `second` is positive."""
    return _minus(json.loads(first)["polygons"], json.loads(second)["polygons"])


def _minus(first: list[dict[str, Any]], second: list[dict[str, Any]]) -> _core.PolygonSet:
    if not first:
        return _core.PolygonSet.from_json('{"polygons":[]}')
    removed: list[Rings] = [polygon["outer"][::-1] for polygon in second]
    given_back = [hole[::-1] for polygon in second for hole in polygon["holes"]]
    polygons = [dict(polygon) for polygon in first]
    polygons[0]["holes"] = [*polygons[0].get("holes", []), *removed]
    polygons += [{"outer": ring, "holes": []} for ring in given_back]
    text = json.dumps({"polygons": polygons})
    canonical: _core.PolygonSet = _core.canonicalize(_core.PolygonSet.from_json(text))[0]
    return canonical


def inner_point(region: _core.PolygonSet) -> tuple[str, str] | None:
    """A point in the interior of the set; None where it is empty."""
    found = _core.difference(region, _core.PolygonSet.from_json('{"polygons":[]}'))
    return (found["point"][0], found["point"][1]) if found else None


def _overlap(
    polygons: list[dict[str, Any]], canonical: list[dict[str, Any]]
) -> tuple[str, str] | None:
    """A point that the rings wind around twice or more, or less than zero times."""
    twice = inner_point(_minus(polygons, canonical))
    if twice is not None:
        return twice
    turned = [
        {"outer": ring[::-1], "holes": []}
        for polygon in polygons
        for ring in (polygon["outer"], *polygon["holes"])
    ]
    text = json.dumps({"polygons": turned})
    return inner_point(_core.canonicalize(_core.PolygonSet.from_json(text))[0])
