"""The format `.poly` (docs/formats.md): the ring count; for each ring a line with its vertex count
and `out` or `in`, one vertex per line, and perhaps the vertex order, by indices from 1."""

from __future__ import annotations

import re

from .exact import InputError, number
from .json_text import MOST_WORDS
from .operand import Operand, Ring, operand_of, twice_area
from .validity import containments

WORD = re.compile(r"[^ \t\r\v\f]+")
COMMENT = re.compile(r"(?:^|(?<=[ \t\r\v\f]))#.*")


class Lines:
    """The words of all nonempty lines, taken line by line."""

    def __init__(self, text: str) -> None:
        self.lines: list[tuple[int, list[str]]] = []
        self.at = 0
        count = 0
        for at, line in enumerate(text.split("\n"), start=1):
            words = [part for word in WORD.findall(COMMENT.sub("", line)) for part in split(word)]
            count += len(words)
            if count > MOST_WORDS:
                raise InputError(f"there are more than {MOST_WORDS} words and numbers")
            if words:
                self.lines.append((at, words))

    @property
    def next(self) -> list[str]:
        """Return the next line's words, none at the end."""
        return self.lines[self.at][1] if self.at < len(self.lines) else []

    def take(self, length: int, what: str) -> list[str]:
        words = self.next
        if len(words) != length:
            where = f"line {self.lines[self.at][0]}" if words else "the end"
            raise InputError(f"not the form of .poly: {what} is due at {where}")
        self.at += 1
        return words


def split(word: str) -> list[str]:
    """Split two numbers run together, such as 7.84688.042924."""
    if word.count(".") != 2:
        return [word]
    at = word.rindex(".")
    return [word[:at], word[at:]]


def of_poly(text: str) -> Operand:
    """Read rings in any order; a hole belongs to the smallest outer ring that contains the hole."""
    lines = Lines(text)
    outers: list[Ring] = []
    holes: list[Ring] = []
    for _ in range(count_of(lines.take(1, "the number of rings")[0])):
        size, role = lines.take(2, "the number of vertices and `out` or `in`")
        if role not in ("out", "in"):
            raise InputError(f"not the form of .poly: {role[:40]!r} is neither `out` nor `in`")
        (outers if role == "out" else holes).append(ring(lines, count_of(size)))
    if lines.next:
        raise InputError(f"text after the last ring: {lines.next[0][:40]!r}")
    found: list[tuple[Ring, list[Ring]]] = [(outer, []) for outer in outers]
    for hole in holes:
        holder = smallest_around(hole, outers)
        found[holder][1].append(hole)
    return operand_of(found)


def ring(lines: Lines, size: int) -> Ring:
    if size < 3:
        raise InputError("a ring has three vertices or more")
    points: Ring = []
    for _ in range(size):
        x, y = lines.take(2, "a vertex")
        points.append((number(x), number(y)))
    order: list[int] = []
    while len(order) < size and lines.next and lines.next[-1] not in ("out", "in"):
        order += map(count_of, lines.next)
        lines.at += 1
    if order and sorted(order) != list(range(1, size + 1)):
        raise InputError(f"not the form of .poly: the indices of a ring are 1 to {size}, each once")
    return [points[index - 1] for index in order] or points


def count_of(word: str) -> int:
    if not re.fullmatch("[0-9]{1,9}", word):
        raise InputError(f"not the form of .poly: {word[:40]!r} is no count")
    return int(word)


def smallest_around(hole: Ring, outers: list[Ring]) -> int:
    if len(outers) == 1:
        return 0
    names = ["a hole", "an outer ring"]
    around = [
        (abs(twice_area(outer)), at)
        for at, outer in enumerate(outers)
        if 1 in containments([hole, outer], names)[0]
    ]
    if not around:
        raise InputError("a hole lies in no outer ring")
    return min(around)[1]
