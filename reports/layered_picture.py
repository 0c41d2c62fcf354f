"""The SVG of sets over each other in one frame, as a part at its place in a container."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from minkref import _core
from minkref.plane.exact_frame import Frame, box_of, box_text, exact_polygons
from minkref.reports.drawing import Layer, height_of
from minkref.reports.side_by_side import side_by_side
from minkref.reports.sum_picture import STYLE, Passages, common_frame, pane, passage_layers

WIDTH = 680
Exact = tuple[Fraction, Fraction]


def layered_picture(
    sets: Sequence[tuple[str, _core.PolygonSet]],
    caption: Sequence[str],
    marks: Sequence[Exact] = (),
    passages: Passages = (),
) -> str:
    """Draw sets, the lowest first, in styles of sum_picture ("first", "second", "sum"), with tight
    passages and marked points on top. The caption ends with the box around all sets. Numbers stay
    exact until the frame places them."""
    drawn = [(style, exact_polygons(each)) for style, each in sets]
    lines = [[(Fraction(x), Fraction(y)) for x, y in passage] for passage in passages]
    lone = [[ring] for ring in ([*marks], *lines) if ring]
    box = box_of([polygon for _, polygons in drawn for polygon in polygons] + lone)
    if box is None:
        return side_by_side([([*caption, "the empty set"], "")], STYLE, WIDTH, 0)
    factor, room = common_frame([box], WIDTH)
    frame = Frame(box[0], box[1], factor)
    layers = [Layer(style, frame.polygons(polygons)) for style, polygons in drawn]
    layers += passage_layers(passages, frame)
    layers += [Layer("tight", point=point) for point in frame.ring(marks)]
    picture = pane(layers, room, caption[0], WIDTH)
    height = round(height_of((0.0, 0.0, *room), WIDTH))
    return side_by_side([([*caption, box_text(box)], picture)], STYLE, WIDTH, height)
