"""Sets of the plane on their way to a target and back, as its declaration says."""

from __future__ import annotations

import json
from dataclasses import replace
from typing import Any

from minkref.fuzz.geometry.region import TextRing, region_of_polygons
from minkref.fuzz.targets.answer import Answer, answered, no_set
from minkref.fuzz.targets.declaration import Declaration
from minkref.fuzz.targets.numbers import (
    MOST_VERTICES,
    Unreadable,
    double,
    list_in,
    received,
    sent_scale,
)
from minkref.fuzz.verdicts.verdict import Verdict


def sent_set(text: str, declaration: Declaration) -> Any:
    """The JSON value of a set in the target's form. OverflowError beyond the range of doubles."""
    value = json.loads(text)
    if declaration.numbers == "text":
        return value
    return {"polygons": [_doubles(polygon) for polygon in value["polygons"]]}


def _doubles(polygon: dict[str, Any]) -> dict[str, Any]:
    def ring(points: list[list[str]]) -> list[list[float]]:
        return [[double(number) for number in point] for point in points]

    return {"outer": ring(polygon["outer"]), "holes": [ring(hole) for hole in polygon["holes"]]}


def plane_answer(value: dict[str, Any], declaration: Declaration, seconds: float) -> Answer:
    """Returns the region given by `polygons` or `rings` in an answer. Raises Unreadable. Rings may
    overlap: their winding number tells the set. Polygons that are points and segments have no
    interior."""
    by_winding = "rings" in value
    if by_winding and "polygons" in value:
        raise Unreadable("it has both polygons and rings")
    polygons: list[list[TextRing]]
    if by_winding:
        polygons = [[_ring(ring, declaration)] for ring in list_in(value, "rings")]
    else:
        given = [_polygon(polygon, declaration) for polygon in list_in(value, "polygons")]
        polygons = [each for each in given if len(each) > 1 or len(each[0]) > 2]
    count = sum(len(ring) for rings in polygons for ring in rings)
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


class PlaneExchange:
    """Sends cases in the plane, and reads answers."""

    answer_is_no = "not a polygon set"

    def taken(self, case: Any, declaration: Declaration) -> Any:
        """Every target of the plane takes a factor for each axis: the case says how. Cases of paths
        and of invalid operands have one scale."""
        return case.taken_by(declaration.capabilities) if hasattr(case, "taken_by") else case

    def sent(self, text: str, declaration: Declaration) -> Any:
        return sent_set(text, declaration)

    def sent_scale(self, text: str) -> str | list[str]:
        return sent_scale(text)

    def received(self, value: dict[str, Any], declaration: Declaration, seconds: float) -> Answer:
        return plane_answer(value, declaration, seconds)

    def received_of_function(
        self, value: dict[str, Any], declaration: Declaration, seconds: float
    ) -> Answer:
        """Reads a function's answer, whose rings may run either way."""
        if declaration.numbers != "text":
            return plane_answer(value, declaration, seconds)
        answer = answered(value, seconds, turned=True)
        answer.declaration = declaration
        return answer


IN_THE_PLANE = PlaneExchange()


def _polygon(polygon: Any, declaration: Declaration) -> list[TextRing]:
    if not isinstance(polygon, dict) or "outer" not in polygon:
        raise Unreadable("a polygon has no outer ring")
    holes = polygon.get("holes", [])
    if not isinstance(holes, list):
        raise Unreadable("holes is not a list")
    return [_ring(ring, declaration) for ring in (polygon["outer"], *holes)]


def _ring(ring: Any, declaration: Declaration) -> TextRing:
    if not isinstance(ring, list) or not ring:
        raise Unreadable("a ring is not a list of points")
    points = []
    for point in ring:
        if not isinstance(point, list) or len(point) != 2:
            raise Unreadable("a point is not a pair of numbers")
        points.append([received(number, declaration) for number in point])
    return points
