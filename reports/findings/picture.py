"""A small picture of a finding's case: the operands or sets, and the witness."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from itertools import pairwise
from typing import Any

from minkref.reports.drawing import Layer, Polygons, Segment, picture
from minkref.reports.findings.entry import Entry

WIDTH = 260
STYLES = ("first", "second", "third")
CSS = (
    "path{stroke-width:1.2;stroke-linejoin:round;fill-opacity:.6}"
    ".first{fill:#9cc3e6;stroke:#1f5f99}.second{fill:#f0c48a;stroke:#9c6412}"
    ".third{fill:#b9dcbb;stroke:#2a6e30}.witness{fill:#c9362b;stroke:#c9362b}"
)


def case_picture(entry: Entry) -> str | None:
    """An SVG document; None in space. Sums and paths have no witness beside
    the operands."""
    if any("vertices" in each for each in _sets(entry.case)):
        return None
    sets = list(_sets(entry.case))
    layers = [
        Layer(STYLES[k % len(STYLES)], polygons=_drawn(each), segments=_segments(each))
        for k, each in enumerate(sets)
    ]
    if entry.witness is not None and entry.verb not in ("sum", "path"):
        x, y = (float(Fraction(number)) for number in entry.witness["point"])
        layers.append(Layer("witness", point=(x, y)))
    text = picture(layers, entry.title, WIDTH)
    start = text.index(">") + 1
    head = text[:start].replace("<svg ", '<svg xmlns="http://www.w3.org/2000/svg" ', 1)
    return f"{head}<style>{CSS}</style>{text[start:]}\n"


def _sets(case: dict[str, Any]) -> Iterator[dict[str, Any]]:
    for name in ("P", "Q", "part", "obstacles", "offset"):
        if name in case:
            yield case[name]
    yield from case.get("sets", ())


def _drawn(value: dict[str, Any]) -> Polygons:
    return [
        [_points(polygon["outer"]), *map(_points, polygon.get("holes", ()))]
        for polygon in value.get("polygons", ())
        if len(polygon["outer"]) > 1
    ]


def _segments(value: dict[str, Any]) -> list[Segment]:
    lines = map(_points, value.get("lines", ()))
    return [(*a, *b) for line in lines for a, b in pairwise(line)]


def _points(given: Any) -> list[tuple[float, float]]:
    return [(float(Fraction(x)), float(Fraction(y))) for x, y in given]
