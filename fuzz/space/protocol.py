"""Sets of space on their way to a target and back, as its declaration says."""

from __future__ import annotations

import json
from fractions import Fraction
from typing import Any

from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.targets.answer import Answer
from minkref.fuzz.targets.declaration import Declaration
from minkref.fuzz.targets.numbers import (
    MOST_VERTICES,
    Unreadable,
    double,
    list_in,
    received,
    sent_scale,
)


def sent_solid(text: str, declaration: Declaration) -> Any:
    """The JSON value of a set in the target's form. OverflowError beyond the range of doubles."""
    value = json.loads(text)
    if declaration.numbers == "text":
        return value
    vertices = [[double(number) for number in vertex] for vertex in value["vertices"]]
    return {"vertices": vertices, "faces": value["faces"]}


def solid_answer(value: dict[str, Any], declaration: Declaration, seconds: float) -> Answer:
    """Returns the polyhedron given by an answer's `vertices` and `faces`. Raises Unreadable."""
    vertices = []
    for vertex in list_in(value, "vertices"):
        if not isinstance(vertex, list) or len(vertex) != 3:
            raise Unreadable("a vertex is not a list of three numbers")
        x, y, z = (Fraction(received(number, declaration)) for number in vertex)
        vertices.append((x, y, z))
    if len(vertices) > MOST_VERTICES:
        raise Unreadable(f"{len(vertices):,} vertices, more than {MOST_VERTICES:,}")
    faces = []
    for face in list_in(value, "faces"):
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


class SpaceExchange:
    """Sends cases in space, and reads answers."""

    answer_is_no = "not a polyhedron"

    def taken(self, case: Any, declaration: Declaration) -> Any:
        return case

    def sent(self, text: str, declaration: Declaration) -> Any:
        return sent_solid(text, declaration)

    def sent_scale(self, text: str) -> str | list[str]:
        return sent_scale(text)

    def received(self, value: dict[str, Any], declaration: Declaration, seconds: float) -> Answer:
        return solid_answer(value, declaration, seconds)

    received_of_function = received


IN_SPACE = SpaceExchange()
