"""Converts Python's shapes to the parts of a set: coordinates in sequences and arrays, GeoJSON,
objects from other geometry libraries.

Every number counts by its exact value: an int, a Fraction, a Decimal, a float (0.1 is the double
next to a tenth), a NumPy scalar, a text (`"0.1"` is a tenth, `"7/5"`).
"""

from __future__ import annotations

import math
import struct
import warnings
from collections.abc import Mapping, Set
from decimal import Decimal
from fractions import Fraction
from numbers import Integral, Rational, Real
from typing import Any

from minkref import _core
from minkref.errors import Refusal
from minkref.exact import read_number
from minkref.plane.operand_text import source_of, text_and_form

Ring = list[tuple[str, str]]
#: The GeoJSON type, or RINGS, whose rings need not be closed; and the rings: after the first,
#: holes.
Part = tuple[str, list[Ring]]
RINGS = "rings"

ACCEPTED = (
    "give one point (x, y), a ring of points, a polygon (its outer ring, then its holes), a list "
    "of polygons, GeoJSON, or an object with __geo_interface__"
)
DEEPEST = 4  # levels of sequences: polygons, rings, points, coordinates
LARGEST_EXPONENT = 10_000  # for a Decimal
MOST_NESTED = 64  # collections within collections
_COLLECTIONS = {"FeatureCollection": "features", "GeometryCollection": "geometries"}
#: Geometries of several parts, and the type of a part.
_SEVERAL = {"MultiPoint": "Point", "MultiLineString": "LineString", "MultiPolygon": "Polygon"}
_GEOMETRIES = ("Point", "LineString", "Polygon", *_SEVERAL)
#: Levels of sequences above a geometry's points.
_POINTS_AT = {"Point": 0, "MultiPoint": 1, "LineString": 1, "MultiLineString": 2, "Polygon": 2,
              "MultiPolygon": 3}  # fmt: skip


def set_or_parts(shape: Any) -> _core.PolygonSet | list[Part]:
    """Prepare the argument of PolygonSet's constructor: a set stays, a text is read as by a command
    (WKT, GeoJSON, plain JSON), anything else gives parts. Raises BadInput."""
    if isinstance(shape, _core.PolygonSet):
        return shape
    if isinstance(shape, str):
        text, form = text_and_form(shape, inline=True)
        return _core.read_text(text, form, shape if shape == "-" else source_of(shape))
    return parts_of(shape)


def parts_of(shape: Any) -> list[Part]:
    """Split a shape into parts, with coordinates as exact texts, oriented as given. A sequence's
    depth decides: a point, a ring of points, a polygon, polygons; drops a first point repeated at
    the end of a ring. A mapping is GeoJSON, or the project's JSON; drops coordinates of GeoJSON
    beyond x and y, with a warning (UserWarning), as the file readers do. Does not check that the
    parts form a set: the file readers do. Linear. Raises Refusal for anything else, naming the
    place."""
    if not isinstance(shape, Mapping) and hasattr(shape, "__geo_interface__"):
        shape = shape.__geo_interface__
    if isinstance(shape, Mapping):
        dropped: list[int] = []
        parts = _of_mapping(shape, 0, dropped)
        if dropped:
            told = f"dropped: {sum(dropped):,} coordinates beyond x and y"
            warnings.warn(told, UserWarning, stacklevel=3)
        return parts
    levels = _depth(shape)
    if levels > DEEPEST or levels < 0:
        raise _no_shape(shape)
    return _of_sequences(shape, levels) if levels else []


def _of_mapping(shape: Mapping[str, Any], depth: int, dropped: list[int]) -> list[Part]:
    if depth > MOST_NESTED:
        what = f"collections are nested deeper than {MOST_NESTED}"
        raise Refusal(what, "PolygonSet", "flatten the collection", "too-deep")
    if "polygons" in shape:
        return [
            (RINGS, _rings([polygon["outer"], *polygon.get("holes", ())], f"polygon {k}, "))
            for k, polygon in enumerate(_members(shape, "polygons", ("outer",)))
        ]
    kind = shape.get("type")
    if kind == "Feature":
        geometry = shape.get("geometry")
        if geometry is None:  # the empty set
            return []
        return _of_mapping(_mapping(geometry, "the geometry of the Feature"), depth + 1, dropped)
    if kind in _COLLECTIONS:
        parts = _members(shape, _COLLECTIONS[kind], ())
        return [polygon for part in parts for polygon in _of_mapping(part, depth + 1, dropped)]
    if kind not in _GEOMETRIES:
        what = f"a mapping of the type {kind!r} is no set of polygons"
        mend = f"give a geometry of {', '.join(_GEOMETRIES)}"
        raise Refusal(what, "PolygonSet", mend, "no-shape")
    coordinates = _sequence(shape.get("coordinates"), f"the coordinates of the {kind}")
    if len(coordinates) == 0:
        return []
    coordinates = _flattened(coordinates, _POINTS_AT[kind], dropped)
    if kind in _SEVERAL:
        part = _SEVERAL[kind]
        named = enumerate(coordinates)
        return [_of_geometry(part, each, f"{part.lower()} {k}, ") for k, each in named]
    return [_of_geometry(kind, coordinates, "")]


def _flattened(given: Any, levels: int, dropped: list[int]) -> Any:
    """Cut the points of a geometry to x and y; lists how many coordinates each one loses."""
    if not _is_sequence(given):
        return given
    if levels:
        return [_flattened(each, levels - 1, dropped) for each in given]
    if len(given) > 2:
        dropped.append(len(given) - 2)
        return given[:2]
    return given


def _of_geometry(kind: str, coordinates: Any, where: str) -> Part:
    if kind == "Point":
        return (kind, [[_point(coordinates, f"{where}the point")]])
    if kind == "LineString":
        return (kind, [_points(coordinates, f"{where}the line")])
    return (kind, _rings(coordinates, where))


def _mapping(given: Any, where: str) -> Mapping[str, Any]:
    found = getattr(given, "__geo_interface__", given)
    if not isinstance(found, Mapping):
        what = f"there is {_a(given)} where a mapping is expected"
        raise Refusal(what, where, ACCEPTED, "no-shape")
    return found


def _members(shape: Mapping[str, Any], name: str, needed: tuple[str, ...]) -> list[Any]:
    """Return a list of mappings with all needed members."""
    members = _sequence(shape.get(name), f'"{name}"')
    for number, member in enumerate(members):
        if not isinstance(member, Mapping) or any(part not in member for part in needed):
            what = f"this is no mapping{''.join(f' with {part!r}' for part in needed)}"
            raise Refusal(what, f'"{name}", number {number}', ACCEPTED, "no-shape")
    return list(members)


def _depth(shape: Any) -> int:
    """Count levels of sequences along first members; 0 for an empty sequence, -1 for a number."""
    levels = 0
    while _is_sequence(shape):
        levels += 1
        if levels > DEEPEST:
            return levels
        if len(shape) == 0:
            return 0 if levels == 1 else levels
        shape = shape[0]
    return levels or -1


def _of_sequences(shape: Any, levels: int) -> list[Part]:
    if levels == 1:
        return [(RINGS, [[_point(shape, "the point")]])]
    if levels == 2:
        return [(RINGS, [_opened(_points(shape, "the ring"))])]
    polygons = (
        [("", shape)] if levels == 3 else [(f"polygon {k}, ", p) for k, p in enumerate(shape)]
    )
    return [(RINGS, [_opened(ring) for ring in _rings(rings, where)]) for where, rings in polygons]


def _rings(rings: Any, where: str) -> list[Ring]:
    """Read the outer ring and the holes as given."""
    return [
        _points(ring, f"{where}{'the outer ring' if r == 0 else f'hole {r}'}")
        for r, ring in enumerate(_sequence(rings, f"{where}its rings"))
    ]


def _points(points: Any, where: str) -> Ring:
    return [_point(p, f"{where}, point {i}") for i, p in enumerate(_sequence(points, where))]


def _opened(ring: Ring) -> Ring:
    """Drop a repeated first point, if three other points remain."""
    return ring[:-1] if len(ring) > 3 and ring[0] == ring[-1] else ring


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
    """Tell whether an object is a sequence or an array with dimensions."""
    if isinstance(given, (str, bytes, bytearray, Mapping, Set)) or getattr(given, "ndim", 1) == 0:
        return False
    return hasattr(given, "__len__") and hasattr(given, "__getitem__")


def _a(given: Any) -> str:
    return f"an object of type {type(given).__name__}"


def number_text(value: Any, where: str) -> str:
    """Write a number's exact value as `n` or `n/d`. Raises Refusal for anything else."""
    if isinstance(value, str):
        mend = "give a number, as 7/5 or 0.1"
        return _fraction(read_number(value.strip(), "coordinate", where, mend))
    if isinstance(value, Integral) and not isinstance(value, bool):
        return _digits(int(value))
    if isinstance(value, Rational) and not isinstance(value, bool):
        return _fraction(Fraction(int(value.numerator), int(value.denominator)))
    if isinstance(value, (Real, Decimal)) and not isinstance(value, bool):
        is_finite = value.is_finite() if isinstance(value, Decimal) else math.isfinite(value)
        if not is_finite:
            what = f"the coordinate is {value}"
            raise Refusal(what, where, "give finite numbers", "coordinate-not-a-number")
        if isinstance(value, Decimal) and abs(value.adjusted()) > LARGEST_EXPONENT:
            what = f"the exponent is beyond {LARGEST_EXPONENT:,}"
            raise Refusal(what, where, "give a smaller number", "limit")
        if isinstance(value, float):
            return _fraction(_of_bits(value))
        exact = getattr(value, "as_integer_ratio", None)
        return _fraction(_of_bits(float(value)) if exact is None else Fraction(*exact()))
    what = f"the coordinate is {_a(value)}"
    mend = "give an int, a Fraction, a float or a text as '7/5'"
    raise Refusal(what, where, mend, "coordinate-not-a-number")


def _of_bits(double: float) -> Fraction:
    """Read a finite double's exact value from its bits: a process that flushes subnormal numbers
    would compute 0."""
    (bits,) = struct.unpack("<q", struct.pack("<d", double))
    exponent, fraction = bits >> 52 & 0x7FF, bits & (1 << 52) - 1
    magnitude = fraction | (1 << 52 if exponent else 0)
    shift = max(exponent, 1) - 1075
    value = Fraction(magnitude << shift) if shift > 0 else Fraction(magnitude, 1 << -shift)
    return -value if bits < 0 else value


def _fraction(value: Fraction) -> str:
    numerator = _digits(value.numerator)
    return numerator if value.denominator == 1 else f"{numerator}/{_digits(value.denominator)}"


def _digits(value: int) -> str:
    """Write a number of any length: `str` refuses more than 4,300 digits."""
    return str(value) if value.bit_length() < 14_000 else format(Decimal(value), "f")


def _no_shape(shape: Any) -> Refusal:
    return Refusal(f"{_a(shape)} is no set of polygons", "PolygonSet", ACCEPTED, "no-shape")
