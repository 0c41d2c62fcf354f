"""Values drawn by the strategies: plain JSON (docs/formats.md), numbers as texts `n` or `n/d`."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Sequence
from fractions import Fraction
from typing import Any, TypedDict, TypeVar

from minkref import _core
from minkref.fuzz.geometry.plane import Point, Ring, Shape, doubled_area

T = TypeVar("T")


class PolygonData(TypedDict):
    """A polygon with rings of [x, y]; the outer ring counter-clockwise, holes clockwise."""

    outer: list[list[str]]
    holes: list[list[list[str]]]


class SetData(TypedDict):
    """A polygon set."""

    polygons: list[PolygonData]


class ScaledPair(TypedDict):
    """Operands and a scale: the sum is scale P + Q."""

    P: SetData
    Q: SetData
    scale: str


class DegeneratePair(ScaledPair):
    """A scaled pair, and its degenerate family."""

    family: str


def to_set(data: SetData) -> _core.PolygonSet:
    """Convert to the exact set that functions of `minkref` take. Not validated. Linear. Raises
    BadInput."""
    return _core.PolygonSet.from_json(json.dumps(data))


def to_fractions(data: SetData) -> dict[str, Any]:
    """Convert points to (x, y) of Fractions in the same dictionary form. Exact. Linear."""
    return _mapped(data, lambda x, y: (Fraction(x), Fraction(y)))


def to_data(polygons: dict[str, Any]) -> SetData:
    """Convert back: numbers that print exactly (int, Fraction, str) become texts. Raises TypeError
    for others, such as floats. Linear."""
    made: Any = _mapped(polygons, lambda x, y: [_text(x), _text(y)])
    return {"polygons": made["polygons"]}


def _text(number: object) -> str:
    if not isinstance(number, int | Fraction | str):
        raise TypeError(f"{number!r} is not an int, a Fraction or a str: give Fraction({number!r})")
    return str(number)


def _mapped(data: Any, point: Callable[[Any, Any], T]) -> dict[str, Any]:
    def ring(points: Iterable[Sequence[Any]]) -> list[T]:
        return [point(x, y) for x, y in points]

    return {
        "polygons": [
            {
                "outer": ring(polygon["outer"]),
                "holes": [ring(hole) for hole in polygon.get("holes", [])],
            }
            for polygon in data["polygons"]
        ]
    }


def data_of(shape: Shape, unit: int = 1) -> SetData:
    """Divide a shape by `unit`, with rings turned as their role demands."""

    def ring(points: Ring, sign: int) -> list[list[str]]:
        right = points if doubled_area(points) * sign >= 0 else [points[0], *points[:0:-1]]
        return [[str(Fraction(c, unit)) for c in point] for point in right]

    return {
        "polygons": [
            {"outer": ring(polygon[0], 1), "holes": [ring(hole, -1) for hole in polygon[1:]]}
            for polygon in shape
        ]
    }


def points_of(shape: Shape) -> list[Point]:
    """List all vertices in the shape's order."""
    return [point for polygon in shape for ring in polygon for point in ring]
