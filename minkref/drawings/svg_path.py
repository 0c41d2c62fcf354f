"""The data of an SVG path: subpaths as polylines."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from fractions import Fraction

from minkref.drawings.affine import Affine, rotation
from minkref.drawings.curves import Point, arc_by_bulge, bezier, squared

_NUMBER = re.compile(r"[\s,]*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)")
_LETTER = re.compile(r"[\s,]*([a-zA-Z])")
_FLAG = re.compile(r"[\s,]*([01])")
COUNTS = {"M": 2, "L": 2, "H": 1, "V": 1, "C": 6, "S": 4, "Q": 4, "T": 2, "A": 7, "Z": 0}
CURVES = frozenset("CSQTA")


class PathReader:
    """Reads path data. `tolerance()` is asked when a curve comes."""

    def __init__(
        self, text: str, number: Callable[[str], Fraction], tolerance: Callable[[], Fraction]
    ) -> None:
        self._text, self._at = text, 0
        self._number, self._tolerance = number, tolerance
        self._subpaths: list[list[Point]] = []
        self._control: Point | None = None  # the last one, for S and T
        self._degrees = ""  # letters of the curves that go on with it
        self._point: Point = (Fraction(0), Fraction(0))

    def subpaths(self) -> list[list[Point]]:
        """Return corners for each subpath, without repeating the first. Raises
        ValueError for other text."""
        letter = ""
        while self._text[self._at :].strip(" \t\r\n\f,"):
            found = _LETTER.match(self._text, self._at)
            if found is not None:
                letter = found[1]
                self._at = found.end()
            elif letter in "Zz":
                raise self._fault()
            if letter.upper() not in COUNTS or (not self._subpaths and letter not in "Mm"):
                raise self._fault()
            self._step(letter.upper(), letter.islower())
            letter = {"M": "L", "m": "l"}.get(letter, letter)
        return self._subpaths

    def _fault(self) -> ValueError:
        return ValueError(f"this is no path data: {self._text[self._at : self._at + 30]!r}")

    def _take(self, pattern: re.Pattern[str]) -> str:
        found = pattern.match(self._text, self._at)
        if found is None:
            raise self._fault()
        self._at = found.end()
        return found[1]

    def _numbers(self, letter: str) -> list[Fraction]:
        patterns = [_NUMBER] * COUNTS[letter]
        if letter == "A":
            patterns[3:5] = [_FLAG, _FLAG]
        return [self._number(self._take(pattern)) for pattern in patterns]

    def _step(self, letter: str, is_relative: bool) -> None:
        x, y = self._point
        numbers = self._numbers(letter)
        dx, dy = (x, y) if is_relative else (Fraction(0), Fraction(0))
        if letter == "Z":
            self._point = self._subpaths[-1][0]
            self._control = None
            return
        if letter == "H":
            numbers, dy = [numbers[0], y], Fraction(0)
        elif letter == "V":
            numbers, dx = [x, numbers[0]], Fraction(0)
        if letter == "M":
            self._subpaths.append([(numbers[0] + dx, numbers[1] + dy)])
            self._point, self._control = self._subpaths[-1][0], None
            return
        if self._subpaths[-1][-1] != self._point:  # after Z
            self._subpaths.append([self._point])
        if letter == "A":
            end = (numbers[5] + dx, numbers[6] + dy)
            self._subpaths[-1] += arc(self._point, end, numbers[:5], self._tolerance())
            self._control = None
        else:
            points = [(a + dx, b + dy) for a, b in zip(numbers[::2], numbers[1::2], strict=True)]
            self._curve(letter, points)
        self._point = self._subpaths[-1][-1]

    def _curve(self, letter: str, points: list[Point]) -> None:
        if letter in "ST":
            x, y = self._point
            is_smooth = self._control is not None and letter in self._degrees
            a, b = self._control if is_smooth and self._control else self._point
            points = [(2 * x - a, 2 * y - b), *points]
        if letter not in CURVES:
            self._control = None
            self._subpaths[-1].append(points[0])
            return
        self._control, self._degrees = points[-2], "CS" if letter in "CS" else "QT"
        self._subpaths[-1] += bezier([self._point, *points], self._tolerance())


def arc(p: Point, q: Point, numbers: list[Fraction], tolerance: Fraction) -> list[Point]:
    """Corners of an elliptical arc, without the start. The map to a circle stays exact for axes
    turned by multiples of 90 degrees; both ends stay exact, the radius has double precision."""
    rx, ry, angle, is_large, is_left = abs(numbers[0]), abs(numbers[1]), *numbers[2:5]
    if rx == 0 or ry == 0 or p == q:
        return [q]
    from_circle = rotation(angle) @ Affine(d=ry / rx)
    to_circle = Affine(d=rx / ry) @ rotation(-angle)
    a, b = to_circle(p), to_circle(q)
    square = squared(b[0] - a[0], b[1] - a[1]) / (4 * rx * rx)
    bulge = Fraction(1)  # for ends too far apart, as SVG has it: a half circle
    if square < 1:
        bulge = Fraction(math.sqrt(square) / (1 + math.sqrt(1 - square)))
        if is_large and bulge == 0:
            raise ValueError("the ends of a large arc are too near for its radii")
        bulge = 1 / bulge if is_large else bulge
    found = arc_by_bulge(a, b, bulge if is_left else -bulge, tolerance / from_circle.stretch)
    corners = [from_circle(point) for point in found]
    return [*corners[:-1], q]
