"""A result put into canonical form, and the exact difference of two of them."""

from __future__ import annotations

import json
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from minkref import _core
from minkref.exact import digest
from minkref.fuzz.geometry.plane import doubled_area
from minkref.fuzz.targets.number_text import GRAMMAR, is_number

Ring = list[list[str]]
Polygon = dict[str, Any]  # "outer": a ring, "holes": rings


@dataclass
class Region:
    """Canonical form of one result. `degenerate` is a vertex of a ring whose vertices
    lie on one line, `overlap` a point where the rings' winding number is neither 0 nor 1."""

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


def region_of_rings(rings: Any, turned: bool = False) -> Region:
    """The result of somebody else: any rings, in any order. Raises what `rings` raises, ValueError
    or KeyError where it is not in the form of a polygon set."""
    return region_of_polygons(plain_polygons(rings), turned)


def region_of_polygons(polygons: list[Polygon], turned: bool) -> Region:
    """The region of plain polygons. With `turned` outer rings are made to run counter-clockwise and
    holes clockwise; without, a ring that runs the wrong way counts as it runs."""
    flat: list[Ring] = []
    kept: list[Polygon] = []
    for polygon in _read_back(polygons, flat):
        outer = polygon["outer"]
        holes: list[Ring] = []
        for hole in polygon["holes"]:
            (flat if _is_flat(hole) else holes).append(hole)
        if _is_flat(outer):
            flat.append(outer)
        else:
            kept.append(_turned(outer, holes) if turned else {"outer": outer, "holes": holes})
    given = _core.PolygonSet.from_json(json.dumps({"polygons": kept}))
    canonical, components, holes_count, well_formed = _core.canonicalize(given)
    text = canonical.canonical_json()
    overlap = None if well_formed else _overlap(kept, json.loads(text)["polygons"])
    degenerate = (flat[0][0][0], flat[0][0][1]) if flat else None
    return Region(canonical, text, digest(text), components, holes_count, degenerate, overlap)


def plain_polygons(value: Any) -> list[Polygon]:
    """A copy in lists and texts of what somebody else made, which may raise anything."""
    return [
        {
            "outer": _plain_ring(polygon["outer"]),
            "holes": [_plain_ring(hole) for hole in polygon.get("holes", [])],
        }
        for polygon in value["polygons"]
    ]


def _plain_ring(ring: Any) -> Ring:
    if not isinstance(ring, list | tuple) or not ring:
        raise ValueError("a ring is not a list of points")
    return [_plain_point(point) for point in ring]


def _plain_point(point: Any) -> list[str]:
    if not isinstance(point, list | tuple) or len(point) != 2:
        raise ValueError("a point is not a pair of exact numbers")
    return [_plain_number(number) for number in point]


def _plain_number(number: Any) -> str:
    if isinstance(number, str):
        text = "".join(number)  # no text of a class of its own
        if not is_number(text):
            raise ValueError(f"{text[:40]!r} is not a number: {GRAMMAR}")
        return text
    if isinstance(number, int) and not isinstance(number, bool):
        return int.__repr__(number)
    raise ValueError("a point is not a pair of exact numbers")


def _read_back(polygons: list[Polygon], short: list[Ring]) -> list[Polygon]:
    """The polygons with numbers as the reference writes them, within its limits. Rings of fewer
    than three vertices, which it does not take, go to `short`."""
    taken = []
    for polygon in polygons:
        rings = [polygon["outer"], *polygon["holes"]]
        short += [ring for ring in rings if len(ring) < 3]
        if len(polygon["outer"]) >= 3:
            holes = [hole for hole in polygon["holes"] if len(hole) >= 3]
            taken.append({"outer": polygon["outer"], "holes": holes})
    text = _core.PolygonSet.from_json(json.dumps({"polygons": taken})).to_json()
    read: list[Polygon] = json.loads(text)["polygons"]
    return read


def _is_flat(ring: Ring) -> bool:
    """All vertices lie on one line."""
    (ax, ay), *others = ((Fraction(x), Fraction(y)) for x, y in ring)
    across = next(((x - ax, y - ay) for x, y in others if (x, y) != (ax, ay)), None)
    if across is None:
        return True
    return all(across[0] * (y - ay) == across[1] * (x - ax) for x, y in others)


def _turned(outer: Ring, holes: list[Ring]) -> Polygon:
    return {
        "outer": outer if _turns_left(outer) else outer[::-1],
        "holes": [hole[::-1] if _turns_left(hole) else hole for hole in holes],
    }


def _turns_left(ring: Ring) -> bool:
    return doubled_area([(Fraction(x), Fraction(y)) for x, y in ring]) > 0


def minus(first: str, second: str) -> _core.PolygonSet:
    """The closure of `first` without `second` (canonical JSON texts), canonical: where the winding
    number of the rings of `first` and the reversed rings of `second` is positive."""
    return _minus(json.loads(first)["polygons"], json.loads(second)["polygons"])


def _minus(first: list[dict[str, Any]], second: list[dict[str, Any]]) -> _core.PolygonSet:
    if not first:
        return _core.PolygonSet.from_json('{"polygons":[]}')
    removed: list[Ring] = [polygon["outer"][::-1] for polygon in second]
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
