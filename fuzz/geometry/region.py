"""A result put into canonical form."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from minkref import _core
from minkref.exact import digest
from minkref.fuzz.geometry.number_text import GRAMMAR, is_number

TextRing = list[list[str]]


@dataclass
class Region:
    """A result's canonical form. `degenerate` is a vertex on a ring with collinear vertices,
    `overlap` a point where the rings' winding number is neither 0 nor 1."""

    set: _core.PolygonSet
    components: int
    holes: int
    degenerate: tuple[str, str] | None = None
    overlap: tuple[str, str] | None = None

    @cached_property
    def json(self) -> str:
        return self.set.canonical_json()

    @cached_property
    def digest(self) -> str:
        return digest(self.json)


def region_of_sum(answer: _core.Sum) -> Region:
    """The result of a reference route, canonical already."""
    return Region(answer.region, answer.components, answer.holes)


def region_of_rings(rings: Any, turned: bool = False) -> Region:
    """Reads a foreign result: any rings, in any order. Raises the exceptions of `rings`, ValueError
    or KeyError if `rings` does not have the form of a polygon set."""
    return region_of_polygons(plain_polygons(rings), turned)


def region_of_polygons(polygons: Sequence[Sequence[Any]], turned: bool) -> Region:
    """Returns the region of polygons: each a list of rings, outer ring first, with exact numbers or
    their texts as coordinates. `turned` makes outer rings counter-clockwise and holes clockwise;
    without `turned`, a ring in the wrong direction counts as given."""
    return Region(*_core.region_of_rings(polygons, turned))


def plain_polygons(value: Any) -> list[list[TextRing]]:
    """Copies a foreign value, which may raise anything, into lists and texts."""
    return [
        [_plain_ring(ring) for ring in (polygon["outer"], *polygon.get("holes", []))]
        for polygon in value["polygons"]
    ]


def _plain_ring(ring: Any) -> TextRing:
    if not isinstance(ring, list | tuple) or not ring:
        raise ValueError("a ring is not a list of points")
    return [_plain_point(point) for point in ring]


def _plain_point(point: Any) -> list[str]:
    if not isinstance(point, list | tuple) or len(point) != 2:
        raise ValueError("a point is not a pair of exact numbers")
    return [_plain_number(number) for number in point]


def _plain_number(number: Any) -> str:
    if isinstance(number, str):
        text = "".join(number)  # a plain text, not a subclass
        if not is_number(text):
            raise ValueError(f"{text[:40]!r} is not a number: {GRAMMAR}")
        return text
    if isinstance(number, int) and not isinstance(number, bool):
        return int.__repr__(number)
    raise ValueError("a point is not a pair of exact numbers")
