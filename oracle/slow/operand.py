"""Operands: a polygon set, a segment, a point or the empty set; reads them from JSON.

Checked here: numbers, structure, vertex counts, edges with length zero, rings with area zero, and
that a segment or point stands alone. When reading files, validity.py also checks that rings are
simple and nest correctly; `operand_from_json` trusts its caller.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

from .exact import InputError, Point, number

Ring = list[Point]
__all__ = ["InputError", "Operand", "Polygon", "Ring", "operand_from_json"]


@dataclass(frozen=True)
class Polygon:
    """A polygon: outer ring counter-clockwise, holes clockwise; no vertex repeated at the end."""

    outer: Ring
    holes: list[Ring]


@dataclass(frozen=True)
class Operand:
    """An operand: `polygons`, or one or two `ends` for a point or segment; the empty set has
    neither."""

    polygons: list[Polygon]
    ends: list[Point]

    @property
    def is_empty(self) -> bool:
        return not self.polygons and not self.ends

    def rings(self) -> list[Ring]:
        return [ring for part in self.polygons for ring in (part.outer, *part.holes)]

    def points(self) -> list[Point]:
        return [*self.ends, *(point for ring in self.rings() for point in ring)]


def twice_area(ring: Ring) -> Fraction:
    total = Fraction(0)
    for (x0, y0), (x1, y1) in zip(ring, [*ring[1:], ring[0]], strict=True):
        total += x0 * y1 - x1 * y0
    return total


def turned(ring: Ring, sign: int, where: str, as_given: bool) -> Ring:
    """Turn a ring counter-clockwise for sign 1, clockwise for -1."""
    if len(ring) < 3:
        raise InputError(f"{where}: a ring has three vertices or more")
    for index, point in enumerate(ring):
        if point == ring[index - 1]:
            raise InputError(f"{where}: vertex {index} repeats the one before it")
    area = twice_area(ring) * sign
    if area == 0:
        raise InputError(f"{where}: the area of the ring is zero")
    if area < 0 and as_given:
        raise InputError(f"{where}: the ring runs the wrong way")
    return ring if area > 0 else ring[::-1]


def operand_of(parts: list[tuple[Ring, list[Ring]]], as_given: bool = False) -> Operand:
    """Make an operand from polygons (outer ring, holes); an outer ring with one or two vertices
    gives a point or a segment. Turns rings as their role demands, or refuses wrong turns if
    `as_given`."""
    if any(len(outer) < 3 for outer, _ in parts):
        (outer, holes), *more = parts
        if more or holes:
            raise InputError("a point or a segment stands alone, without holes")
        if len(outer) == 0 or len(set(outer)) < len(outer):
            raise InputError("a segment has two different ends")
        return Operand([], outer)
    polygons = []
    for index, (outer, holes) in enumerate(parts):
        where = f"polygon {index}"
        polygons.append(
            Polygon(
                turned(outer, 1, f"{where}, outer ring", as_given),
                [turned(h, -1, f"{where}, hole {i}", as_given) for i, h in enumerate(holes)],
            )
        )
    return Operand(polygons, [])


def coordinate(value: object) -> Fraction:
    if isinstance(value, Fraction):
        return value
    if isinstance(value, str):
        return number(value)
    if isinstance(value, int) and not isinstance(value, bool):
        return Fraction(value)
    raise InputError(f"a coordinate is a number or a string, not {value!r}")


def ring_from_json(value: object) -> Ring:
    if not isinstance(value, Sequence) or isinstance(value, str):
        raise InputError("a ring is a list of vertices")
    ring: Ring = []
    for vertex in value:
        if not isinstance(vertex, Sequence) or isinstance(vertex, str) or len(vertex) != 2:
            raise InputError(f"a vertex is a list of two coordinates, not {vertex!r}")
        ring.append((coordinate(vertex[0]), coordinate(vertex[1])))
    return ring


def operand_from_json(value: object, as_given: bool = False) -> Operand:
    """Read `{"polygons": [{"outer": ring, "holes": [ring, ...]}, ...]}`. Coordinates may be
    strings, integers or fractions; floats are refused, since a float may differ from the intended
    number."""
    if not isinstance(value, Mapping) or "polygons" not in value:
        raise InputError("an operand is an object with the member polygons")
    check_members(value, {"polygons"})
    if not isinstance(value["polygons"], Sequence) or isinstance(value["polygons"], str):
        raise InputError("polygons is a list")
    parts: list[tuple[Ring, list[Ring]]] = []
    for part in value["polygons"]:
        if not isinstance(part, Mapping) or "outer" not in part:
            raise InputError("a polygon is an object with the member outer")
        check_members(part, {"outer", "holes"})
        holes = part.get("holes", [])
        if not isinstance(holes, Sequence) or isinstance(holes, str):
            raise InputError("holes is a list of rings")
        parts.append((ring_from_json(part["outer"]), [ring_from_json(hole) for hole in holes]))
    return operand_of(parts, as_given)


def check_members(value: Mapping[str, object], known: set[str]) -> None:
    for name in value:
        if name not in known:
            raise InputError(f"unknown member {name!r}")
