"""Numbers and sets on their way to a target and back, as its declaration says."""

from __future__ import annotations

import json
import math
from dataclasses import replace
from fractions import Fraction
from typing import Any

from minkref.fuzz.space.polyhedron import Polyhedron
from minkref.fuzz.targets.answer import Answer, no_set
from minkref.fuzz.targets.declaration import Declaration
from minkref.fuzz.targets.number_text import GRAMMAR, LONGEST_NUMBER, is_number
from minkref.fuzz.verdicts.region import region_of_polygons
from minkref.fuzz.verdicts.verdict import Verdict

MOST_VERTICES = 400_000  # of an answer: what can be compared in time


class Unreadable(ValueError):
    """An answer that is none; says what is wrong with it."""


def sent_set(text: str, declaration: Declaration) -> Any:
    """The JSON value of a set as the target wants it. OverflowError beyond the range of doubles."""
    value = json.loads(text)
    if declaration.numbers == "text":
        return value
    return {"polygons": [_doubles(polygon) for polygon in value["polygons"]]}


def _doubles(polygon: dict[str, Any]) -> dict[str, Any]:
    def ring(points: list[list[str]]) -> list[list[float]]:
        return [[double(number) for number in point] for point in points]

    return {"outer": ring(polygon["outer"]), "holes": [ring(hole) for hole in polygon["holes"]]}


def double(text: str) -> float:
    """The nearest double. OverflowError where there is none, also where it would be zero and the
    number is not."""
    exact = Fraction(text)
    value = float(exact)
    if math.isinf(value) or (value == 0 and exact != 0):
        raise OverflowError(text[:40])
    return value


def received(number: Any, declaration: Declaration) -> str:
    """A number of an answer as `n` or `n/d`."""
    if isinstance(number, bool) or not isinstance(number, int | float | str):
        raise Unreadable(f"{json.dumps(number)[:40]} is no number")
    if isinstance(number, float):
        if declaration.numbers == "text":
            what = "numbers are texts n or n/d and JSON integers, unless `double` is declared"
            raise Unreadable(f"{number!r}: {what}")
        if not math.isfinite(number):
            raise Unreadable("a number is not finite")
        return str(Fraction(number))
    if isinstance(number, int):
        if declaration.numbers == "double":
            try:
                return str(Fraction(float(number)))
            except OverflowError as error:
                raise Unreadable("a number is beyond the range of doubles") from error
        return str(number)
    if declaration.numbers == "double":
        raise Unreadable(f"{number[:40]!r}: numbers are JSON numbers where `double` is declared")
    if len(number) > LONGEST_NUMBER:
        raise Unreadable(f"a number has more than {LONGEST_NUMBER:,} characters")
    if not is_number(number):
        raise Unreadable(f"{number[:40]!r} is not a number: {GRAMMAR}")
    return number


def plane_answer(value: dict[str, Any], declaration: Declaration, seconds: float) -> Answer:
    """The region that `polygons` or `rings` of an answer give. Raises Unreadable. Rings may
    overlap: their winding number tells the set. Polygons that are points and segments have no
    interior."""
    by_winding = "rings" in value
    if by_winding and "polygons" in value:
        raise Unreadable("it has both polygons and rings")
    polygons: list[dict[str, Any]]
    if by_winding:
        polygons = [
            {"outer": _ring(ring, declaration), "holes": []} for ring in _list(value, "rings")
        ]
    else:
        given = [_polygon(polygon, declaration) for polygon in _list(value, "polygons")]
        polygons = [each for each in given if len(each["outer"]) > 2 or each["holes"]]
    count = sum(len(ring) for each in polygons for ring in (each["outer"], *each["holes"]))
    if count > MOST_VERTICES:
        raise Unreadable(f"{count:,} vertices, more than {MOST_VERTICES:,}")
    try:
        region = region_of_polygons(polygons, turned=not by_winding)
        if by_winding:
            region = replace(region, degenerate=None, overlap=None)
        return Answer(region, seconds=seconds, declaration=declaration)
    except MemoryError:
        verdict, message = Verdict.OUT_OF_MEMORY, "while its answer was read"
        return Answer(verdict=verdict, message=message, declaration=declaration)
    except ValueError as error:
        answer = no_set(error, seconds)
        answer.declaration = declaration
        return answer


def _list(value: dict[str, Any], field: str) -> list[Any]:
    found = value.get(field)
    if not isinstance(found, list):
        raise Unreadable(f"{field} is not a list")
    return found


def _polygon(polygon: Any, declaration: Declaration) -> dict[str, Any]:
    if not isinstance(polygon, dict) or "outer" not in polygon:
        raise Unreadable("a polygon has no outer ring")
    holes = polygon.get("holes", [])
    if not isinstance(holes, list):
        raise Unreadable("holes is not a list")
    return {
        "outer": _ring(polygon["outer"], declaration),
        "holes": [_ring(hole, declaration) for hole in holes],
    }


def _ring(ring: Any, declaration: Declaration) -> list[list[str]]:
    if not isinstance(ring, list) or not ring:
        raise Unreadable("a ring is not a list of points")
    points = []
    for point in ring:
        if not isinstance(point, list) or len(point) != 2:
            raise Unreadable("a point is not a pair of numbers")
        points.append([received(number, declaration) for number in point])
    return points


def sent_solid(text: str, declaration: Declaration) -> Any:
    """As sent_set, of a set in space."""
    value = json.loads(text)
    if declaration.numbers == "text":
        return value
    vertices = [[double(number) for number in vertex] for vertex in value["vertices"]]
    return {"vertices": vertices, "faces": value["faces"]}


def sent_scale(text: str) -> str | list[str]:
    """A scale as a text; a non-uniform one as a list of three."""
    parts = text.split(",")
    return text if len(parts) == 1 else parts


def solid_answer(value: dict[str, Any], declaration: Declaration, seconds: float) -> Answer:
    """The polyhedron that `vertices` and `faces` of an answer give. Raises Unreadable."""
    vertices = []
    for vertex in _list(value, "vertices"):
        if not isinstance(vertex, list) or len(vertex) != 3:
            raise Unreadable("a vertex is not a list of three numbers")
        x, y, z = (Fraction(received(number, declaration)) for number in vertex)
        vertices.append((x, y, z))
    if len(vertices) > MOST_VERTICES:
        raise Unreadable(f"{len(vertices):,} vertices, more than {MOST_VERTICES:,}")
    faces = []
    for face in _list(value, "faces"):
        if not isinstance(face, list) or len(face) < 3:
            raise Unreadable("a face is not a list of three indices or more")
        for index in face:
            if isinstance(index, bool) or not isinstance(index, int):
                raise Unreadable("an index of a face is no integer")
            if not 0 <= index < len(vertices):
                raise Unreadable(f"a face names vertex {index} of {len(vertices)}")
        faces.append(tuple(face))
    solid = Polyhedron(tuple(vertices), tuple(faces))
    return Answer(solid=solid, seconds=seconds, declaration=declaration)
