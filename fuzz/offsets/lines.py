"""Open lines: lists of points, each joined to the next. A line of one point is that point."""

from __future__ import annotations

import json
from collections.abc import Iterable, Sequence
from fractions import Fraction
from itertools import pairwise
from typing import Any

from minkref import _core
from minkref.errors import Refusal, refusing
from minkref.fuzz.geometry.number_text import number_of

Place = tuple[Fraction, Fraction]
Line = tuple[Place, ...]
MEND = 'write {"offset":{"lines":[[["0","0"],["4","0"],["4","3"]]]},"radius":"7/5"}'


def read_lines(value: Any, where: str) -> tuple[tuple[Line, ...], _core.PolygonSet]:
    """Reads lines, and the set of their segments. Refuses other values, and equal points in a
    row."""
    try:
        lines = tuple(
            tuple((number_of(str(x)), number_of(str(y))) for x, y in line) for line in value
        )
    except (TypeError, ValueError) as error:
        raise Refusal(f"these are not lines: {error}", where, MEND) from error
    if not lines or not all(lines):
        raise Refusal("there are no lines, or one without points", where, MEND)
    for k, line in enumerate(lines):
        if any(a == b for a, b in pairwise(line)):
            raise Refusal(f"line {k} has equal points in a row", where, "leave one out")
    segments: _core.PolygonSet = refusing(where, lambda: segments_of(lines))
    return lines, segments


def segments_of(lines: Iterable[Sequence[Place]]) -> _core.PolygonSet:
    """The set of the segments and points, each once."""
    pairs = dict.fromkeys(
        tuple(sorted(pair)) for line in lines for pair in (pairwise(line) if line[1:] else [line])
    )
    rings = [[[str(x), str(y)] for x, y in pair] for pair in pairs]
    value = {"polygons": [{"outer": ring, "holes": []} for ring in rings]}
    found = _core.PolygonSet.from_json(json.dumps(value))
    found.validate("lines", True)
    return found


def lines_value(lines: Iterable[Sequence[Place]]) -> dict[str, Any]:
    """The lines as a JSON value."""
    return {"lines": [[[str(x), str(y)] for x, y in line] for line in lines]}
