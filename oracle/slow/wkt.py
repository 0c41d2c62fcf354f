"""Well-known text (docs/formats.md)."""

from __future__ import annotations

import re
from collections.abc import Callable
from itertools import islice

from .exact import InputError, number
from .json_text import DEEPEST, MOST_WORDS
from .operand import Operand, Ring, operand_of

TOKEN = re.compile(r"[ \t\r\n]*([A-Za-z]+|[(),]|[^ \t\r\n(),]+)")

Parts = list[tuple[Ring, list[Ring]]]


class Words:
    """A well-known text's tokens, taken one after another."""

    def __init__(self, text: str) -> None:
        tokens = [match[1] for match in islice(TOKEN.finditer(text), MOST_WORDS + 1)]
        if len(tokens) > MOST_WORDS:
            raise InputError(f"there are more than {MOST_WORDS} words, numbers and marks")
        self.tokens = iter(tokens)
        self.next = ""
        self.take()

    def take(self, expected: str = "") -> str:
        token = self.next
        if expected and token != expected:
            raise InputError(f"{expected!r} was expected, not {token[:40] or 'the end'!r}")
        self.next = next(self.tokens, "")
        return token

    def empty(self) -> bool:
        if self.next.upper() == "EMPTY":
            self.take()
            return True
        return False


def of_wkt(text: str) -> Operand:
    words = Words(text)
    found = geometry(words, 0)
    if words.next:
        raise InputError(f"text after the geometry: {words.next[:40]!r}")
    return operand_of(found)


def geometry(words: Words, depth: int) -> Parts:
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
    if kind == "MULTIPOLYGON":
        return collection(words, polygon)
    if kind == "GEOMETRYCOLLECTION":
        if depth >= DEEPEST:
            raise InputError(f"collections are nested deeper than {DEEPEST}")
        return collection(words, lambda words: geometry(words, depth + 1))
    raise InputError(f"{kind[:40]!r} is no geometry that is an operand")


def collection(words: Words, part: Callable[[Words], Parts]) -> Parts:
    if words.empty():
        return []
    words.take("(")
    found = part(words)
    while words.next == ",":
        words.take()
        found += part(words)
    words.take(")")
    return found


def polygon(words: Words) -> Parts:
    if words.empty():
        return []
    words.take("(")
    rings = [closed_ring(words)]
    while words.next == ",":
        words.take()
        rings.append(closed_ring(words))
    words.take(")")
    return [(rings[0], rings[1:])]


def closed_ring(words: Words) -> Ring:
    points = list_of_points(words)
    if len(points) < 2 or points[0] != points[-1]:
        raise InputError("a ring repeats its first vertex at its end")
    if len(points) < 4:
        raise InputError("a ring has three vertices or more")
    return points[:-1]


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
