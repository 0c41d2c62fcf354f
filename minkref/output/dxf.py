"""DXF: sets as closed polylines, with a disc their arcs as bulges; bridges as lines."""

from __future__ import annotations

import io
import math
from collections.abc import Callable, Iterable
from fractions import Fraction
from typing import Any

from minkref import _core
from minkref.errors import Refusal

VERSION = "R2000"  # the first with polylines of one entity, which all programs read
LAYER = "SUM"
NO_UNIT = 0  # of $INSUNITS: a set has numbers, and no unit of length


def dxf_text(found: _core.Offset, where: str) -> str:
    """A polyline for each ring, outer ones counter-clockwise, holes clockwise. An arc is the bulge
    of the corner where it starts: the tangent of a quarter of its angle. Each number is the double
    nearest to the exact one. The same sum gives the same text. Refuses without ezdxf, and what is
    beyond doubles."""

    def draw(space: Any) -> None:
        for rings in found.drawn_rings():
            for ring in rings:
                corners = [(x, y, bulge) for _, x, y, _, _, _, _, bulge in ring]
                _check(corners, where)
                space.add_lwpolyline(corners, format="xyb", close=True, dxfattribs={"layer": LAYER})

    return _text(draw, LAYER, where)


def dxf_of_steps(rings: Iterable[Iterable[tuple[Any, ...]]], where: str) -> str:
    """A polyline for each ring of lines and counter-clockwise arcs of less than half a turn, given
    as (kind, x and y of the start, of the end, of an arc's centre). As dxf_text."""

    def draw(space: Any) -> None:
        for ring in rings:
            corners = [(x, y, _bulge(*step)) for step in ring for _, x, y, *_ in (step,)]
            _check(corners, where)
            space.add_lwpolyline(corners, format="xyb", close=True, dxfattribs={"layer": LAYER})

    return _text(draw, LAYER, where)


def _bulge(kind: str, x0: float, y0: float, x1: float, y1: float, cx: float, cy: float) -> float:
    """The tangent of a quarter of an arc's angle; 0 for a line."""
    if kind != "arc":
        return 0.0
    across = (x0 - cx) * (y1 - cy) - (y0 - cy) * (x1 - cx)
    along = (x0 - cx) * (x1 - cx) + (y0 - cy) * (y1 - cy)
    return math.tan(math.atan2(across, along) / 4)


Point = tuple[float, float]


def dxf_of_set(region: _core.PolygonSet, where: str) -> tuple[str, bool]:
    """A closed polyline for each ring, and whether the decimals written are the exact numbers.
    Refuses as dxf_text."""
    rings = [ring for polygon in region.approximate_rings() for ring in polygon]

    def draw(space: Any) -> None:
        for ring in rings:
            _check(ring, where)
            space.add_lwpolyline(ring, format="xy", close=True, dxfattribs={"layer": LAYER})

    exact = [ring for polygon in region.rings() for ring in polygon]
    points = zip((p for ring in rings for p in ring), (p for r in exact for p in r), strict=True)
    text = _text(draw, LAYER, where)
    return text, all(_is_exact(near, true) for near, true in points)


def _is_exact(near: Point, true: tuple[Fraction, Fraction]) -> bool:
    return all(Fraction(repr(x)) == y for x, y in zip(near, true, strict=True))


def dxf_of_lines(lines: Iterable[tuple[Point, Point]], layer: str, where: str) -> str:
    """A line for each pair of points. The same lines give the same text. Refuses as dxf_text."""

    def draw(space: Any) -> None:
        for line in lines:
            _check(line, where)
            space.add_line(*line, dxfattribs={"layer": layer})

    return _text(draw, layer, where)


def _check(points: Iterable[tuple[float, ...]], where: str) -> None:
    if not all(math.isfinite(x) for point in points for x in point):
        mend = "write the exact form: .json"
        raise Refusal("coordinates are beyond doubles", where, mend, "beyond-doubles")


def _text(draw: Callable[[Any], None], layer: str, where: str) -> str:
    try:
        from ezdxf import new, options  # type: ignore[attr-defined]  # not in its __all__
    except ImportError as error:
        raise Refusal(
            "DXF is written by ezdxf, which is not installed",
            where,
            "pip install 'minkref[dxf]', or name a .svg or .json file",
            "no-ezdxf",
        ) from error
    fixed = options.write_fixed_meta_data_for_testing
    options.write_fixed_meta_data_for_testing = True  # no time, no random number
    try:
        drawing = new(VERSION)
        drawing.header["$INSUNITS"] = NO_UNIT
        drawing.layers.add(layer)
        draw(drawing.modelspace())
        text = io.StringIO()
        drawing.write(text)
    finally:
        options.write_fixed_meta_data_for_testing = fixed
    return text.getvalue()
