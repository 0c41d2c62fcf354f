"""The polygons of a set from what Python programs hold: coordinates in sequences and arrays,
GeoJSON, objects of other geometry libraries.

Every number counts by its exact value: an int, a Fraction, a Decimal, a float (0.1 is the double
next to a tenth), a scalar of NumPy, a text (`"0.1"` is a tenth, `"7/5"`).
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Set
from decimal import Decimal
from fractions import Fraction
from numbers import Integral, Rational, Real
from typing import Any

from minkref import _core
from minkref.errors import Refusal
from minkref.exact import read_number
from minkref.operand_text import source_of, text_and_form

Ring = list[tuple[str, str]]
Polygon = list[Ring]  # the outer ring, then its holes

ACCEPTED = (
    "give one point (x, y), a ring of points, a polygon (its outer ring, then its holes), a list "
    "of polygons, GeoJSON, or an object with __geo_interface__"
)
DEEPEST = 4  # levels of sequences: polygons, rings, points, coordinates
_COLLECTIONS = {"FeatureCollection": "features", "GeometryCollection": "geometries"}
_GEOMETRIES = {"Point": 1, "LineString": 2, "Polygon": 3, "MultiPolygon": 4}


def set_or_polygons(shape: Any) -> _core.PolygonSet | list[Polygon]:
    """What the constructor of PolygonSet makes its set of: a set as it is, that of a text as a
    command reads it (WKT, GeoJSON, plain JSON), or polygons. Raises BadInput, Refusal."""
    if isinstance(shape, _core.PolygonSet):
        return shape
    if isinstance(shape, str):
        text, form = text_and_form(shape, inline=True)
        return _core.read_text(text, form, shape if shape == "-" else source_of(shape))
    return polygons_of(shape)


def polygons_of(shape: Any) -> list[Polygon]:
    """The rings of a shape with coordinates as exact texts, turned as they are given; a first
    point that is repeated at the end of a ring is left out. None stands for the empty set.
    Sequences count by their depth: a point, a ring of points, a polygon, polygons, as the
    coordinates of GeoJSON. Linear. Raises Refusal for anything else, naming the place."""
    if shape is None:
        return []
    if not isinstance(shape, Mapping) and hasattr(shape, "__geo_interface__"):
        shape = shape.__geo_interface__
    if isinstance(shape, Mapping):
        return _of_mapping(shape)
    levels = _depth(shape)
    if levels > DEEPEST or levels < 0:
        raise _no_shape(shape)
    return _of_coordinates(shape, levels) if levels else []


def _of_mapping(shape: Mapping[str, Any]) -> list[Polygon]:
    if "polygons" in shape:
        return [
            _polygon([polygon["outer"], *polygon.get("holes", ())], f"polygon {k}, ")
            for k, polygon in enumerate(_members(shape, "polygons", ("outer",)))
        ]
    kind = shape.get("type")
    if kind == "Feature":
        return polygons_of(shape.get("geometry"))
    if kind in _COLLECTIONS:
        parts = _members(shape, _COLLECTIONS[kind], ())
        return [polygon for part in parts for polygon in _of_mapping(part)]
    if kind not in _GEOMETRIES:
        what = f"a mapping of the type {kind!r} is no set of polygons"
        mend = f"give a geometry of {', '.join(_GEOMETRIES)}"
        raise Refusal(what, "PolygonSet", mend, "no-shape")
    coordinates = _sequence(shape.get("coordinates"), f"the coordinates of the {kind}")
    return _of_coordinates(coordinates, _GEOMETRIES[kind]) if len(coordinates) else []


def _members(shape: Mapping[str, Any], name: str, needed: tuple[str, ...]) -> list[Any]:
    """A list of mappings that have what is needed."""
    members = _sequence(shape.get(name), f'"{name}"')
    for number, member in enumerate(members):
        if not isinstance(member, Mapping) or any(part not in member for part in needed):
            what = f"this is no mapping{''.join(f' with {part!r}' for part in needed)}"
            raise Refusal(what, f'"{name}", number {number}', ACCEPTED, "no-shape")
    return list(members)


def _depth(shape: Any) -> int:
    """Levels of sequences, looking at the first of each; 0 of an empty one, -1 of a number."""
    levels = 0
    while _is_sequence(shape):
        levels += 1
        if levels > DEEPEST:
            return levels
        if len(shape) == 0:
            return 0 if levels == 1 else levels
        shape = shape[0]
    return levels or -1


def _of_coordinates(shape: Any, levels: int) -> list[Polygon]:
    if levels == 1:
        return [[[_point(shape, "the point")]]]
    if levels == 2:
        return [[_ring(shape, "the ring")]]
    if levels == 3:
        return [_polygon(shape, "")]
    return [_polygon(polygon, f"polygon {k}, ") for k, polygon in enumerate(shape)]


def _polygon(rings: Any, where: str) -> Polygon:
    return [
        _ring(ring, f"{where}{'the outer ring' if r == 0 else f'hole {r}'}")
        for r, ring in enumerate(_sequence(rings, f"{where}its rings"))
    ]


def _ring(points: Any, where: str) -> Ring:
    ring = [_point(p, f"{where}, point {i}") for i, p in enumerate(_sequence(points, where))]
    return ring[:-1] if len(ring) > 1 and ring[0] == ring[-1] else ring


def _point(given: Any, where: str) -> tuple[str, str]:
    coordinates = _sequence(given, where)
    if len(coordinates) != 2:
        what = f"a point of the plane has two coordinates, not {len(coordinates)}"
        raise Refusal(what, where, "give x and y", "no-shape")
    x, y = (number_text(c, f"{where}, {name}") for c, name in zip(coordinates, "xy", strict=True))
    return x, y


def _sequence(given: Any, where: str) -> Any:
    if not _is_sequence(given):
        what = f"there is {_a(given)} where a sequence is expected"
        raise Refusal(what, where, ACCEPTED, "no-shape")
    return given


def _is_sequence(given: Any) -> bool:
    """Also an array, but one without dimensions."""
    if isinstance(given, (str, bytes, bytearray, Mapping, Set)) or getattr(given, "ndim", 1) == 0:
        return False
    return hasattr(given, "__len__") and hasattr(given, "__getitem__")


def _a(given: Any) -> str:
    return f"an object of type {type(given).__name__}"


def number_text(value: Any, where: str) -> str:
    """`n` or `n/d`, the exact value of a number. Raises Refusal for what is none."""
    if isinstance(value, str):
        mend = "give a number, as 7/5 or 0.1"
        return _fraction(read_number(value.strip(), "coordinate", where, mend))
    if isinstance(value, Integral) and not isinstance(value, bool):
        return _digits(int(value))
    if isinstance(value, Rational) and not isinstance(value, bool):
        return _fraction(Fraction(int(value.numerator), int(value.denominator)))
    if isinstance(value, (Real, Decimal)) and not isinstance(value, bool):
        if not math.isfinite(value):
            what = f"the coordinate is {value}"
            raise Refusal(what, where, "give finite numbers", "coordinate-not-a-number")
        return _fraction(Fraction(value if isinstance(value, Decimal) else float(value)))
    what = f"the coordinate is {_a(value)}"
    mend = "give an int, a Fraction, a float or a text as '7/5'"
    raise Refusal(what, where, mend, "coordinate-not-a-number")


def _fraction(value: Fraction) -> str:
    numerator = _digits(value.numerator)
    return numerator if value.denominator == 1 else f"{numerator}/{_digits(value.denominator)}"


def _digits(value: int) -> str:
    """Of a number of any length: `str` refuses what has over 4,300 digits."""
    return str(value) if value.bit_length() < 14_000 else format(Decimal(value), "f")


def _no_shape(shape: Any) -> Refusal:
    return Refusal(f"{_a(shape)} is no set of polygons", "PolygonSet", ACCEPTED, "no-shape")
