"""Clipper2 by the Python package pyclipr: offsets of doubles by `scaleFactor`, joins and ends as
asked.

The package multiplies by the factor and rounds to integers. The factor is chosen for each call, a
power of two, so that sizes have 30 bits: numbers on that grid are not rounded. Arcs: the tolerance
is a thousandth of the radius. Four units besides, as for Clipper2.
"""

from __future__ import annotations

import math
from importlib.metadata import version
from typing import Any

import numpy as np
import pyclipr  # type: ignore[import-not-found,unused-ignore]
from adapter_protocol import Set, Skipped, serve  # type: ignore[import-not-found,unused-ignore]

BITS = 30
JOINS = {
    "round": pyclipr.JoinType.Round,
    "mitre": pyclipr.JoinType.Miter,
    "square": pyclipr.JoinType.Square,
}
ENDS = {
    "round": pyclipr.EndType.Round,
    "flat": pyclipr.EndType.Butt,
    "square": pyclipr.EndType.Square,
}
HELLO = {
    "name": "pyclipr-inflate",
    "version": f"{version('pyclipr')} (Clipper2 {pyclipr.clipperVersion})",
    "language": "C++",
    "arithmetic": "integer-grid",
    "numbers": "double",
    "grid": {"bits": BITS - 2},
    "tolerance": {"absolute": "0", "relative": "1/134217728", "radius": "0.001"},
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
        "line-offset",
        "join-mitre",
        "join-square",
        "cap-flat",
        "cap-square",
    ],
}


def offset_of(P: Set, radius: float, how: dict[str, Any] | None = None) -> dict[str, Any]:
    how = how or {}
    rings, end = P.get("lines"), ENDS[how.get("cap", "round")]
    if rings is None:
        rings = [
            ring for polygon in P["polygons"] for ring in (polygon["outer"], *polygon["holes"])
        ]
        end = pyclipr.EndType.Polygon
        if any(len(ring) < 3 for ring in rings):
            raise Skipped("no points or segments")
    if not rings:
        return {"rings": []}
    size = max(abs(number) for ring in rings for point in ring for number in point) + abs(radius)
    if not math.isfinite(size):
        raise Skipped("coordinates exceed the doubles")
    factor = math.ldexp(1.0, BITS - math.frexp(size)[1])
    one = pyclipr.ClipperOffset()
    one.scaleFactor = factor
    one.arcTolerance = abs(radius) * factor / 1000
    one.miterLimit = how.get("limit", 2.0)
    one.addPaths([np.array(ring) for ring in rings], JOINS[how.get("join", "round")], end)
    return {"rings": [np.asarray(path)[:, :2].tolist() for path in one.execute(radius)]}


if __name__ == "__main__":
    serve(HELLO, None, offset_of=offset_of)
