"""Sums with a disc as DXF: closed polylines, whose arcs are bulges."""

from __future__ import annotations

import io
import math

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
        drawing.layers.add(LAYER)
        space = drawing.modelspace()
        for rings in found.drawn_rings():
            for ring in rings:
                corners = [(x, y, bulge) for _, x, y, _, _, _, _, bulge in ring]
                if not all(math.isfinite(x) for corner in corners for x in corner):
                    mend = "write the exact form: .json"
                    raise Refusal("coordinates are beyond doubles", where, mend, "beyond-doubles")
                space.add_lwpolyline(corners, format="xyb", close=True, dxfattribs={"layer": LAYER})
        text = io.StringIO()
        drawing.write(text)
    finally:
        options.write_fixed_meta_data_for_testing = fixed
    return text.getvalue()
