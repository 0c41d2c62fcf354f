"""Files: plain JSON, cases (`file.json#P`, `file.json#Q`), well-known text, `.poly`.

The formats are those of docs/formats.md; GeoJSON is not read. Errors are `InputError`s that name
the file. Cost: linear in the text, for `.poly` also holes times vertices.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from fractions import Fraction
from pathlib import Path

from .exact import InputError, Point, number
from .operand import Operand, Ring, operand_from_json, operand_of, twice_area
from .place import inside

TOKEN = re.compile(r"\s*([A-Za-z]+|[(),]|[^\s(),]+)")
TWO_NUMBERS = re.compile(r"([+-]?\d*\.\d+)(\.\d+)")


def read_operand(name: str) -> Operand:
    """The operand in the file; `case.json#P` and `case.json#Q` are those of a case."""
    path, role = name, ""
    if name.endswith(("#P", "#Q")):
        path, role = name[:-2], name[-1]
    try:
        text = Path(path).read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        raise InputError(f"{path}: cannot be read: {error}") from error
    try:
        if path.endswith(".json"):
            return of_json(text, role)
        if path.endswith(".wkt"):
            return of_wkt(text)
        if path.endswith(".poly"):
            return of_poly(text)
    except InputError as error:
        raise InputError(f"{path}: {error}") from error
    raise InputError(f"{path}: the name ends in none of .json, .wkt, .poly")


def once(pairs: list[tuple[str, object]]) -> dict[str, object]:
    members = dict(pairs)
    if len(members) < len(pairs):
        raise InputError("a member is given twice")
    return members


def no_number(text: str) -> object:
    raise InputError(f"{text} is not a number")


def of_json(text: str, role: str) -> Operand:
    """A plain operand, or one of the two operands of a case."""
    try:
        value = json.loads(
            text,
            parse_float=number,
            parse_int=number,
            parse_constant=no_number,
            object_pairs_hook=once,
        )
    except (json.JSONDecodeError, RecursionError) as error:
        raise InputError(f"no JSON text: {error}") from error
    if isinstance(value, dict) and value.get("schema") == "case-v1":
        return operand_from_json(value.get(role or "P"), as_given=True)
    if role:
        raise InputError(f"#{role} names the operand of a case, and this is none")
    return operand_from_json(value)


class Words:
    """The tokens of a well-known text, taken one after another."""

    def __init__(self, text: str) -> None:
        self.tokens: Iterator[str] = iter(TOKEN.findall(text))
        self.next = ""
        self.take()

    def take(self, expected: str = "") -> str:
        token = self.next
        if expected and token != expected:
            raise InputError(f"{expected!r} was expected, not {token or 'the end'!r}")
        self.next = next(self.tokens, "")
        return token

    def empty(self) -> bool:
        if self.next.upper() == "EMPTY":
            self.take()
            return True
        return False


def list_of_points(words: Words) -> Ring:
    points: Ring = []
    words.take("(")
    while True:
        x = number(words.take())
        points.append((x, number(words.take())))
        if words.next != ",":
            words.take(")")
            return points
        words.take(",")


def closed_ring(words: Words) -> Ring:
    points = list_of_points(words)
    if len(points) < 2 or points[0] != points[-1]:
        raise InputError("a ring repeats its first vertex at its end")
    if len(points) < 4:
        raise InputError("a ring has three vertices or more")
    return points[:-1]


def polygon(words: Words) -> list[tuple[Ring, list[Ring]]]:
    if words.empty():
        return []
    words.take("(")
    rings = [closed_ring(words)]
    while words.next == ",":
        words.take()
        rings.append(closed_ring(words))
    words.take(")")
    return [(rings[0], rings[1:])]


def geometry(words: Words) -> list[tuple[Ring, list[Ring]]]:
    kind = words.take().upper()
    if kind == "POLYGON":
        return polygon(words)
    if kind in ("POINT", "LINESTRING"):
        if words.empty():
            return []
        points = list_of_points(words)
        if len(points) != (1 if kind == "POINT" else 2):
            raise InputError(f"{kind} of {len(points)} points is no operand")
        return [(points, [])]
    if kind not in ("MULTIPOLYGON", "GEOMETRYCOLLECTION"):
        raise InputError(f"{kind!r} is no geometry that is an operand")
    if words.empty():
        return []
    part = polygon if kind == "MULTIPOLYGON" else geometry
    words.take("(")
    parts = part(words)
    while words.next == ",":
        words.take()
        parts += part(words)
    words.take(")")
    return parts


def of_wkt(text: str) -> Operand:
    words = Words(text)
    parts = geometry(words)
    if words.next:
        raise InputError(f"text after the geometry: {words.next!r}")
    return operand_of(parts)


def of_poly(text: str) -> Operand:
    """Rings in any order; a hole belongs to the smallest outer ring that contains it."""
    tokens: list[str] = []
    for line in text.splitlines():
        for token in line.split("#")[0].split():
            two = TWO_NUMBERS.fullmatch(token)
            tokens += [two[1], two[2]] if two else [token]
    try:
        outers: list[tuple[Ring, list[Ring]]] = []
        holes: list[Ring] = []
        at = 0
        count = int(tokens[at])
        for _ in range(count):
            size, role = int(tokens[at + 1]), tokens[at + 2]
            values = [number(token) for token in tokens[at + 3 : at + 3 + 2 * size]]
            ring: Ring = list(zip(values[::2], values[1::2], strict=True))
            if len(ring) < max(size, 3) or role not in ("in", "out"):
                raise InputError("a ring has `out` or `in` and three vertices or more")
            at += 2 + 2 * size
            if tokens[at + 1 : at + 1 + size] == [str(i) for i in range(1, size + 1)]:
                at += size
            if role == "out":
                outers.append((ring, []))
            else:
                holes.append(ring)
    except (ValueError, IndexError) as error:
        raise InputError(f"not the form of .poly: {error}") from error
    if at + 1 != len(tokens):
        raise InputError(f"text after the last ring: {tokens[at + 1]!r}")
    for hole in holes:
        around = [part for part in outers if holds(part[0], hole)]
        if not around:
            raise InputError("a hole lies in no outer ring")
        min(around, key=lambda part: abs(twice_area(part[0])))[1].append(hole)
    return operand_of(outers)


def holds(outer: Ring, hole: Ring) -> bool:
    """Whether the middle of an edge of the hole, which may touch at vertices, is inside."""
    (x0, y0), (x1, y1) = hole[0], hole[1]
    middle: Point = ((x0 + x1) / Fraction(2), (y0 + y1) / Fraction(2))
    return inside([outer], middle)
