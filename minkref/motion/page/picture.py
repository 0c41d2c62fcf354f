"""The page of a path as the JSON document that its scripts read."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from minkref import _core
from minkref.errors import Refusal
from minkref.motion.commands.path_rows import contact_document, range_documents
from minkref.motion.path_text import ExactPoint
from minkref.plane.page.boundary import NARROWEST, Window, rings_of
from minkref.plane.page.linear import double, out_of_range

MOST_POLYGONS = 100_000  # a page of some 15 MB
MOST_BOUNDS = 10_000
AROUND = Fraction(3, 2)  # how far the window goes beyond the last bound
WITHOUT_BOUNDS = Fraction(2)  # its end where there is none


@dataclass(frozen=True)
class PathQuestion:
    """The question about a path: for which scales the part passes."""

    part: _core.PolygonSet
    obstacles: _core.PolygonSet
    path: Sequence[ExactPoint]
    contact: str

    def valid(self) -> tuple[list[Any], list[Any]]:
        """Ranges and bounds of all scales, as rows."""
        ranges, bounds, _ = _core.valid_scales(
            self.part, self.obstacles, self.path, self.contact, None, None, "pieces"
        )
        return ranges, bounds

    def drawing(self, window: Window) -> tuple[Any, Any, Any]:
        """Pieces of the part, of the obstacles, and bad polygons between two scales, in doubles."""
        first = None if Fraction(window.first) == 0 else window.first
        try:
            return _core.path_drawing(
                self.part, self.obstacles, self.path, self.contact, first, window.last,
                MOST_POLYGONS,
            )  # fmt: skip
        except _core.LimitExceeded as error:
            mend = "give a --to that is smaller, or a shorter path"
            raise Refusal(error.problem, "view", mend, "limit") from error


def window_around(bounds: Sequence[Any], first: str | None, last: str | None) -> Window:
    """From 0, or the scale given, to beyond the last bound, as a short number."""
    begin = Fraction(first) if first is not None else Fraction(0)
    if last is not None:
        return Window(str(begin), last)
    top = max((Fraction(row[0]) for row in bounds), default=WITHOUT_BOUNDS) * AROUND
    end = Fraction(f"{double(top, 'a scale'):.2g}")
    return Window(str(begin), str(max(end, 2 * begin)))


def picture(
    question: PathQuestion, ranges: Sequence[Any], bounds: Sequence[Any], window: Window
) -> dict[str, Any]:
    """The fields of the page's data: docs/command-line.md, "minkref view with a path". Scales and
    bounds are exact; places and polygons are doubles. Refuses what is too large for a page, or for
    doubles."""
    first, last = (double(Fraction(end), "a scale") for end in (window.first, window.last))
    if last <= first * (1 + NARROWEST) or last == 0:
        raise Refusal(
            "the window is too narrow for doubles", "--from, --to", "take a wider one", "limit"
        )
    if len(bounds) > MOST_BOUNDS:
        what = f"the path has {len(bounds):,} bounds, and a page holds {MOST_BOUNDS:,}"
        raise Refusal(what, "view", "see `minkref path --json`", "limit")
    part_pieces, obstacle_pieces, polygons = question.drawing(window)
    drawn = [
        [segment, part, obstacle, *(number for corner in corners for number in corner)]
        for segment, part, obstacle, corners in polygons
    ]
    if not all(math.isfinite(number) for polygon in drawn for number in polygon):
        raise out_of_range("a corner of a bad polygon")
    return {
        "contact": question.contact,
        "window": [[window.first, first], [window.last, last]],
        "part": rings_of(question.part),
        "obstacles": rings_of(question.obstacles),
        "path": [_double(axis) for point in question.path for axis in point],
        "valid": [_range(one) for one in range_documents(ranges)],
        "bounds": [_bound(row) for row in bounds],
        "pieces": {"part": _flat(part_pieces), "obstacles": _flat(obstacle_pieces)},
        "polygons": drawn,
    }


def held_picture(question: PathQuestion, way: Any, held: Any, window: Window) -> dict[str, Any]:
    """The picture of a way, with the held scales. `way`, `held`: rows of `_core.held_scales`."""
    ranges, bounds, _ = way
    data = picture(question, ranges, bounds, window)
    return {**data, "held": [_range(one) for one in range_documents([row[0] for row in held])]}


def _double(number: str) -> float:
    return double(Fraction(number), "a coordinate")


def _flat(pieces: Sequence[Sequence[tuple[float, float]]]) -> list[list[float]]:
    return [[axis for corner in piece for axis in corner] for piece in pieces]


def _range(one: dict[str, Any]) -> dict[str, Any]:
    ends = (one["from"], one["to"])
    return {**one, "about": [None if end is None else _double(end) for end in ends]}


def _bound(row: Any) -> dict[str, Any]:
    """The exact contact, with its position also as doubles."""
    told = contact_document(row)
    return {
        **told,
        "about": {
            "scale": _double(told["scale"]),
            "t": _double(told["at"]["t"]),
            "point": [_double(axis) for axis in told["at"]["point"]],
            "touching": [_double(axis) for axis in told["touching"]],
        },
    }
