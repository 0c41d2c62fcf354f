"""A small picture of a polygon set for a terminal, in dots of Braille letters."""

from __future__ import annotations

import sys
from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import pairwise, product

import plotille
from minkref import _core
from minkref.errors import Refusal
from minkref.plane.exact_frame import (
    Frame,
    Polygons,
    Ring,
    box_of,
    box_text,
    exact_polygons,
    fitted,
)

COLUMNS, ROWS = 72, 24  # letters at most; one has 2 by 4 dots, which are as wide as high
OUTLINE, HOLE, PASSAGE = "green", "red", "yellow"
ARM = 2  # dots
Line = tuple[float, float, float, float]
Passages = Sequence[Sequence[Sequence[str]]]  # exact points for each passage


def check_drawable() -> None:
    """Refuses a standard output whose encoding has no Braille letters."""
    encoding = sys.stdout.encoding or "ascii"
    try:
        "\u2800".encode(encoding)
    except (UnicodeEncodeError, LookupError) as error:
        mend = "set PYTHONIOENCODING=utf-8, or write a picture with -o sum.svg"
        raise Refusal(f"{encoding} has no characters to draw with", "--plot", mend) from error


def terminal_picture(
    region: _core.PolygonSet, columns: int = COLUMNS, passages: Passages = ()
) -> str:
    """The set with its boundary in lines and every second dot of its inside, so that holes are
    blank; tight passages are lines with blank dots beside them, or small crosses. Below it the
    corners of its box. x and y have the same unit. A hole that is smaller than a dot is the dot, a
    line that encloses nothing is drawn. In colours on a terminal, where NO_COLOR is not set. Cost:
    linear in vertices times rows of dots."""
    exact = exact_polygons(region)
    box = box_of(exact)
    if box is None:
        return "(the empty set)\n"
    width, height = 2 * max(1, min(columns, COLUMNS)), 4 * ROWS
    frame = fitted(box, width - 1, height - 1)
    polygons = frame.polygons(exact)
    rows = _rows(polygons)
    canvas = plotille.Canvas(width // 2, rows, 0, 0, width, 4 * rows)
    lines = [line for points in passages for line in _lines(frame, points)]
    around = {dot for line in lines for dot in _beside(*line)}
    for x, y in _inside(polygons):
        if (x + y) % 2 == 0 and (x, y) not in around:
            canvas.point(x, y, color=OUTLINE)
    for polygon in polygons:
        for number, ring in enumerate(polygon):
            for (x0, y0), (x1, y1) in pairwise([*ring, ring[0]]):
                canvas.line(x0, y0, x1, y1, color=HOLE if number else OUTLINE)
    for x0, y0, x1, y1 in lines:
        canvas.line(x0, y0, x1, y1, color=PASSAGE)
    drawn = "\n".join(line.rstrip(" \u2800") for line in canvas.plot(linesep="\n").split("\n"))
    return f"{drawn}\n{box_text(box)}\n"


def _lines(frame: Frame, points: Sequence[Sequence[str]]) -> list[Line]:
    """The lines of a tight passage; two for a point."""
    places = frame.ring([(Fraction(x), Fraction(y)) for x, y in points])
    if len(places) == 1:
        x, y = places[0]
        return [(x - ARM, y, x + ARM, y), (x, y - ARM, x, y + ARM)]
    return [(*a, *b) for a, b in pairwise(places)]


def _beside(x0: float, y0: float, x1: float, y1: float) -> Iterator[tuple[int, int]]:
    """The dots next to a line, where the inside is left blank for it."""
    steps = round(max(abs(x1 - x0), abs(y1 - y0))) + 1
    for k in range(steps + 1):
        x, y = x0 + (x1 - x0) * k / steps, y0 + (y1 - y0) * k / steps
        yield from product(*(range(round(c) - ARM, round(c) + ARM + 1) for c in (x, y)))


def _rows(polygons: Polygons) -> int:
    """As many rows of letters as the highest point needs."""
    highest = max(y for polygon in polygons for ring in polygon for _, y in ring)
    return int(highest + 0.5) // 4 + 1


def _inside(polygons: Polygons) -> Iterator[tuple[int, int]]:
    """The dots strictly inside, row by row, by the parity of the edges to their left."""
    rings = [ring for polygon in polygons for ring in polygon]
    for y in range(4 * ROWS):
        crossings = sorted(x for ring in rings for x in _crossings(ring, y))
        for left, right in zip(crossings[::2], crossings[1::2], strict=True):
            for x in range(int(left) + 1, int(right) + 1):
                if x < right:
                    yield x, y


def _crossings(ring: Ring, y: int) -> Iterator[float]:
    """Where the ring meets the line at this height; a vertex on it counts as above."""
    for (x0, y0), (x1, y1) in pairwise([*ring, ring[0]]):
        if (y0 < y) != (y1 < y):
            yield x0 + (y - y0) / (y1 - y0) * (x1 - x0)
