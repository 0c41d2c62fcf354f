"""The SVG of a decomposition: pieces in a few colours, cuts, and the notches."""

from __future__ import annotations

from minkref.disc.decomposition import Decomposition
from minkref.output.terminal import counted
from minkref.plane.exact_frame import Frame, box_of, box_text, exact_polygons, fitted
from minkref.plane.operand import Operand
from minkref.reports.drawing import Layer, bounds, height_of, picture
from minkref.reports.side_by_side import side_by_side
from minkref.reports.sum_picture import short_name

WIDTH = 900
COLOURS = ("#b9dcbb", "#9cc3e6", "#f2c18d", "#d9c2e6", "#e6d98f", "#b5d6d6")
STYLE = (
    "".join(f".piece{k}{{fill:{colour};stroke:none}}" for k, colour in enumerate(COLOURS))
    + ".shape{fill:none;stroke:#333}.cut{fill:none;stroke:#c9362b;stroke-width:1.5}"
    "path{stroke-width:1;stroke-linejoin:round}text{font:13px sans-serif;fill:#333}"
)


def decomposition_picture(operand: Operand, found: Decomposition) -> str:
    """An SVG document. Numbers stay exact until the frame places them."""
    shape = exact_polygons(operand.set)
    box = box_of(shape)
    title = f"{short_name(operand.name)}: {counted(len(found.pieces), 'piece')}, "
    title += counted(len(found.cuts), "cut")
    layers: list[Layer] = []
    if box is not None:
        frame = Frame(box[0], box[1], fitted(box, WIDTH, WIDTH).factor)
        layers = [
            Layer(f"piece{k}", frame.polygons(
                [polygon for piece in found.pieces[k :: len(COLOURS)]
                 for polygon in exact_polygons(piece.region)]
            ))
            for k in range(len(COLOURS))
        ]  # fmt: skip
        layers.append(Layer("shape", frame.polygons(shape)))
        ends = [frame.ring([cut.start, cut.end]) for cut in found.cuts]
        layers.append(Layer("cut", segments=[(*start, *end) for start, end in ends]))
    drawn = picture(layers, title, WIDTH)
    caption = [title, "the empty set" if box is None else box_text(box)]
    return side_by_side([(caption, drawn)], STYLE, WIDTH, round(height_of(bounds(layers), WIDTH)))
