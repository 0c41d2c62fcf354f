"""The SVG of a convolution: the scaled P, Q and the convolution beside each other, drawn to one
scale."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from fractions import Fraction
from math import hypot
from typing import Any

from minkref.plane.exact_frame import Exact, ExactPolygons, Frame, box_of, box_text, exact_polygons
from minkref.plane.operand import Operand
from minkref.reports.drawing import Layer, Segment, height_of
from minkref.reports.side_by_side import side_by_side
from minkref.reports.sum_picture import OPERANDS, PANE, common_frame, pane, short_name

ARROW = 6.0  # length of a head
SHORTEST = 12.0  # edge with a head
STYLE = (
    OPERANDS + ".S,.T{fill:none}.S{stroke:#1f5f99}.T{stroke:#9a5410;stroke-dasharray:5 3}"
    ".head{stroke-dasharray:none}.negative{stroke:#b8292f}"
    "path{stroke-width:1;stroke-linejoin:round}text{font:13px sans-serif;fill:#333}"
)


def convolution_picture(
    P: Operand, Q: Operand, scale: str, edges: Iterable[dict[str, Any]], full: bool
) -> str:
    """An SVG document. P arrives unscaled. S-edges are solid, T-edges dashed, edges with sign -1
    red; an arrowhead at an edge's middle shows its direction. `edges`: documents of any size, moved
    and scaled exactly."""
    classes: dict[tuple[str, int], list[list[Exact]]] = {}
    for edge in edges:
        ends = [_point(edge["start"]), _point(edge["end"])]
        classes.setdefault((edge["kind"], edge["sign"]), []).append(ends)
    counts = {kind: sum(len(classes.get((kind, s), ())) for s in (1, -1)) for kind in "ST"}
    first = f"P: {short_name(P.name)}" + ("" if scale == "1" else f", scaled by {scale}")
    named = f"{'full' if full else 'reduced'} convolution"
    legend = f"S-edges, solid: {counts['S']:,}; T-edges, dashed: {counts['T']:,}"
    lines: ExactPolygons = [[ends] for group in classes.values() for ends in group]
    sets = [exact_polygons(P.set.scaled(scale)), exact_polygons(Q.set), lines]
    boxes = [box_of(exact) for exact in sets]
    factor, room = common_frame(boxes)
    drawn = []
    for style, title, exact, box in zip(
        ("first", "second", None), (first, f"Q: {short_name(Q.name)}", named), sets, boxes,
        strict=True,
    ):  # fmt: skip
        frame = None if box is None else Frame(box[0], box[1], factor)
        if style is not None:
            layers = [Layer(style, frame.polygons(exact))] if frame is not None else []
            caption = [title]
        else:
            layers = list(_layers(classes, frame)) if frame is not None else []
            negative = sum(len(group) for (_, sign), group in classes.items() if sign < 0)
            caption = [title, legend, *([f"sign -1, red: {negative:,}"] if full else [])]
        caption.append("the empty set" if box is None else box_text(box))
        drawn.append((caption, pane(layers, room, title)))
    return side_by_side(drawn, STYLE, PANE, round(height_of((0.0, 0.0, *room), PANE)))


def _point(texts: list[str]) -> Exact:
    x, y = map(Fraction, texts)
    return x, y


def _layers(classes: dict[tuple[str, int], list[list[Exact]]], frame: Frame) -> Iterator[Layer]:
    for (kind, sign), group in sorted(classes.items()):
        style = f"{kind} negative" if sign < 0 else kind
        segments = [(*start, *end) for start, end in map(frame.ring, group)]
        yield Layer(style, segments=segments)
        heads = [half for segment in segments for half in _head(segment)]
        yield Layer(f"{style} head", segments=heads)


def _head(segment: Segment) -> Iterator[Segment]:
    """Two strokes that meet at an edge's middle, if the edge is long enough."""
    x0, y0, x1, y1 = segment
    length = hypot(x1 - x0, y1 - y0)
    if length < SHORTEST:
        return
    x, y = (x0 + x1) / 2, (y0 + y1) / 2
    along = ((x1 - x0) / length * ARROW, (y1 - y0) / length * ARROW)
    for side in (0.4, -0.4):
        yield (x - along[0] - side * along[1], y - along[1] + side * along[0], x, y)
