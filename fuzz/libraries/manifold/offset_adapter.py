"""Manifold (the Python package manifold3d): CrossSection.offset with round joins, in the plane.

128 segments for a circle: the polygon of an arc is off by 1 - cos(pi / 128) = 0.0003 of the radius.
CrossSection calls Clipper2, on a grid with eight decimals (`precision_` in cross_section.cpp): four
units, as for Clipper2.
"""

from __future__ import annotations

from importlib.metadata import version
from typing import Any

import numpy as np
from adapter_protocol import Set, serve  # type: ignore[import-not-found,unused-ignore]
from manifold3d import CrossSection, FillRule, JoinType  # type: ignore[import-not-found,unused-ignore]

SEGMENTS = 128
HELLO = {
    "name": "manifold3d-offset",
    "version": version("manifold3d"),
    "language": "C++",
    "arithmetic": "integer-grid",
    "numbers": "double",
    "grid": {"unit": "1/100000000", "largest": "1e7"},  # beyond it doubles have fewer decimals
    "tolerance": {"absolute": "4e-8", "relative": "1e-12", "radius": "0.00031"},
    "sum": "none",
    "capabilities": [
        "plane",
        "non-convex",
        "holes",
        "components",
        "touching",
        "empty",
        "offset",
        "inset",
    ],
}


def grown(P: Set, radius: float) -> dict[str, Any]:
    rings = [r for polygon in P["polygons"] for r in (polygon["outer"], *polygon["holes"])]
    contours = [np.array(ring, dtype=np.float64) for ring in rings]
    section = CrossSection(contours, FillRule.Positive)
    found = section.offset(radius, JoinType.Round, 2.0, SEGMENTS)
    return {"rings": [contour.tolist() for contour in found.to_polygons()]}


if __name__ == "__main__":
    serve(HELLO, None, offset_of=grown)
