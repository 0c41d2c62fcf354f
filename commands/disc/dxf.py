"""Sums with a disc as DXF: closed polylines, whose arcs are bulges."""

from __future__ import annotations

import io
import math

from minkref import _core
from minkref.errors import Refusal

VERSION = "R2000"  # the first with polylines of one entity, which all programs read
LAYER = "SUM"
Piece = tuple[str, float, float, float, float, float, float]


def dxf_text(found: _core.Offset, where: str) -> str:
    """A polyline for each ring, outer ones counter-clockwise, holes clockwise. An arc is the bulge
    of the corner where it starts: the tangent of a quarter of its angle. Coordinates are rounded to
    doubles. The same sum gives the same text. Refuses without ezdxf, and what is beyond doubles."""
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
        drawing.layers.add(LAYER)
        space = drawing.modelspace()
        for rings in found.drawn_rings():
            for ring in rings:
                corners = [(piece[1], piece[2], bulge(piece)) for piece in ring]
                if not all(math.isfinite(x) for corner in corners for x in corner):
                    mend = "write the exact form: .json"
                    raise Refusal("coordinates are beyond doubles", where, mend, "beyond-doubles")
                space.add_lwpolyline(corners, format="xyb", close=True, dxfattribs={"layer": LAYER})
        text = io.StringIO()
        drawing.write(text)
    finally:
        options.write_fixed_meta_data_for_testing = fixed
    return text.getvalue()


def bulge(piece: Piece) -> float:
    """Of an arc, which runs counter-clockwise, the tangent of a quarter of its angle: from its ends
    and its centre."""
    kind, x0, y0, x1, y1, cx, cy = piece
    if kind != "arc":
        return 0.0
    ax, ay, bx, by = x0 - cx, y0 - cy, x1 - cx, y1 - cy
    return math.tan(math.atan2(ax * by - ay * bx, ax * bx + ay * by) / 4)
