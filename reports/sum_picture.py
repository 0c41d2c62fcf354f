"""The SVG of a sum: the scaled P, Q and the sum side by side, drawn to one scale."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from itertools import pairwise

from minkref import _core
from minkref.output.terminal import counted
from minkref.plane.exact_frame import ExactBox, Frame, box_of, box_text, exact_polygons, fitted
from minkref.plane.operand import Operand
from minkref.reports.drawing import Box, Layer, bounds, height_of, picture
from minkref.reports.side_by_side import side_by_side

PANE = 340
LONGEST_NAME = 40  # shown letters of an operand
SPECK = 3.0  # sets smaller than this both ways get a mark
Passages = Sequence[Sequence[Sequence[str]]]  # exact points for each passage
OPERANDS = ".first{fill:#9cc3e6;stroke:#1f5f99}.second{fill:#f2c18d;stroke:#9a5410}"
STYLE = (
    OPERANDS + ".sum{fill:#b9dcbb;stroke:#2a6e30}.lost{fill:#e58a8a;stroke:#a11d1d}"
    ".added{fill:#c9a6e0;stroke:#66308f}.tight{fill:none;stroke:#c9362b;stroke-width:2}"
    "path{stroke-width:1;stroke-linejoin:round}"
    "text{font:13px sans-serif;fill:#333}"
)


def sum_picture(
    P: Operand,
    Q: Operand,
    scale: str,
    region: _core.PolygonSet,
    components: int,
    holes: int,
    exact: _core.PolygonSet | None = None,
    passages: Passages = (),
    words: tuple[str, str] = ("sum", "tight passage"),
    beneath: _core.PolygonSet | None = None,
) -> str:
    """An SVG document. P arrives unscaled. All sets are drawn to one scale, each with its position
    above. Numbers stay exact until the frame places them, so that sets of any size can be drawn. An
    `exact` sum beside a possibly wrong answer is drawn too, with the answer's lost and added parts.
    Tight passages appear on the sum: lines, and a ring around a point. `words`: what the result is,
    and what its passages are called; `beneath`: a set around the result, drawn under it."""
    first = f"P: {short_name(P.name)}" + ("" if scale == "1" else f", scaled by {scale}")
    counts = f"{counted(components, 'component')}, {counted(holes, 'hole')}"
    if passages:
        counts += f", {counted(len(passages), words[1])}"
    panes = [
        ("first", first, exact_polygons(P.set.scaled(scale))),
        ("second", f"Q: {short_name(Q.name)}", exact_polygons(Q.set)),
        ("sum", f"{words[0]}: {counts}", exact_polygons(region)),
    ]
    if exact is not None:
        panes += [
            ("sum", "the exact sum", exact_polygons(exact)),
            ("lost", "lost", exact_polygons(_core.minus(exact, region))),
            ("added", "added", exact_polygons(_core.minus(region, exact))),
        ]
    boxes = [box_of(polygons) for *_, polygons in panes]
    under = exact_polygons(beneath) if beneath is not None else []
    boxes[2] = box_of(under) or boxes[2]
    factor, room = common_frame(boxes)
    drawn = []
    for (style, title, polygons), box in zip(panes, boxes, strict=True):
        layers = []
        if box is not None:
            frame = Frame(box[0], box[1], factor)
            if polygons is panes[2][2] and under:
                layers.append(Layer("first", frame.polygons(under)))
            layers.append(Layer(style, frame.polygons(polygons)))
            if polygons is panes[2][2]:
                layers += passage_layers(passages, frame)
        caption = [title, "the empty set" if box is None else box_text(box)]
        drawn.append((caption, pane(layers, room, title)))
    return side_by_side(drawn, STYLE, PANE, round(height_of((0.0, 0.0, *room), PANE)))


def passage_layers(passages: Passages, frame: Frame) -> list[Layer]:
    """Tight passages as lines, and marked points."""
    layers = []
    for points in passages:
        places = frame.ring([(Fraction(x), Fraction(y)) for x, y in points])
        if len(places) == 1:
            layers.append(Layer("tight", point=places[0]))
        layers.append(Layer("tight", segments=[(*a, *b) for a, b in pairwise(places)]))
    return layers


def common_frame(
    boxes: Sequence[ExactBox | None], width: int = PANE
) -> tuple[Fraction, tuple[float, float]]:
    """The factor by which sets with these boxes fit their panes, and the room for the largest."""
    sides = [(box[2] - box[0], box[3] - box[1]) for box in boxes if box is not None]
    wide, high = (max((side[k] for side in sides), default=Fraction(0)) for k in (0, 1))
    factor = fitted((Fraction(0), Fraction(0), wide, high), width, width).factor
    return factor, (float(wide * factor), float(high * factor))


def pane(layers: list[Layer], room: tuple[float, float], caption: str, width: int = PANE) -> str:
    """A picture of the layers in the middle of the room; a speck gets a mark."""
    left, bottom, right, top = bounds(layers)
    x, y = (left + right) / 2, (bottom + top) / 2
    if layers and max(right - left, top - bottom) < SPECK:
        layers = [*layers, Layer(layers[0].style, point=(x, y))]
    box: Box = (x - room[0] / 2, y - room[1] / 2, x + room[0] / 2, y + room[1] / 2)
    return picture(layers, caption, width, box)


def short_name(name: str) -> str:
    return name if len(name) <= LONGEST_NAME else f"{name[: LONGEST_NAME - 3]}..."
