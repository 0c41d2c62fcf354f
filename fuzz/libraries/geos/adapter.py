"""GEOS (the Python package Shapely): union_all, that is, unary union by OverlayNG, in doubles, and
buffer. The argument is floating, grid or buffer. It has no sums.

floating: intersections are computed in double-doubles and rounded to doubles. If that fails, GEOS
snaps vertices and edges together that are closer than 1e-12 times the largest coordinate, and tries
up to five times with ten times as much each time: in all less than 1e-7.

grid: the same snap-rounded to a grid of 2^-40 times the largest coordinate, by which vertices and
edges move at most a unit or two.

buffer: 16 segments for a quarter of a circle; joins and caps as asked. Before, GEOS takes shallow
bends away, up to a hundredth of the radius (BufferParameters: "provides an accuracy of about 1%"),
and joins vertices closer than a thousandth. Polygons for arcs miss 1 - cos(pi / 64) = 0.0012.
Together less than 0.0125 of the radius. If that fails, GEOS rounds to 12 digits, then to fewer.
"""

from __future__ import annotations

import math
import sys
from importlib.metadata import version
from typing import Any

import shapely  # type: ignore[import-untyped,unused-ignore]
from adapter_protocol import Set, Skipped, serve  # type: ignore[import-not-found,unused-ignore]

BITS = 40
QUARTER = 16  # segments
OF_RADIUS = "0.0125"
TOLERANCES = {"floating": "1e-7", "grid": f"1/{1 << (BITS - 2)}", "buffer": "1e-7"}
BUFFER = (
    "offset", "inset", "line-offset", "join-mitre", "join-bevel", "cap-flat", "cap-square",
)  # fmt: skip
NAMES = {"floating": "geos", "grid": "geos-grid", "buffer": "geos-buffer"}


def area(polygons: list[dict[str, Any]]) -> Any:
    if any(len(polygon["outer"]) < 3 for polygon in polygons):
        raise Skipped("no points or segments")
    return shapely.MultiPolygon([(each["outer"], each["holes"]) for each in polygons])


def shape(polygons: list[dict[str, Any]]) -> Any:
    """Also a point or a line."""
    ring = polygons[0]["outer"] if polygons else []
    if len(ring) in (1, 2):
        return shapely.Point(ring[0]) if len(ring) == 1 else shapely.LineString(ring)
    return area(polygons)


def lines_of(lines: list[list[list[float]]]) -> Any:
    """A line, or several, perhaps with points."""
    parts = [shapely.LineString(line) if line[1:] else shapely.Point(line[0]) for line in lines]
    if len(parts) == 1:
        return parts[0]
    if all(part.geom_type == "LineString" for part in parts):
        return shapely.MultiLineString(parts)
    return shapely.GeometryCollection(parts)


def grown(P: Set, radius: float, how: dict[str, Any] | None = None) -> dict[str, Any]:
    given = lines_of(P["lines"]) if "lines" in P else shape(P["polygons"])
    how = how or {}
    found = given.buffer(
        radius, quad_segs=QUARTER, cap_style=how.get("cap", "round"),
        join_style=how.get("join", "round"), mitre_limit=how.get("limit", 5.0),
    )  # fmt: skip
    return {"polygons": polygons_of(found)}


def unit(sets: list[Set]) -> float:
    rings = [r for each in sets for p in each["polygons"] for r in (p["outer"], *p["holes"])]
    size = max((abs(number) for ring in rings for point in ring for number in point), default=0.0)
    return math.ldexp(1.0, math.frexp(size)[1] - BITS) if size else 1.0


def polygons_of(found: Any) -> list[dict[str, Any]]:
    """The polygons of any geometry: lines and points have no interior."""
    parts = [part for part in getattr(found, "geoms", [found]) if part.geom_type == "Polygon"]
    return [
        {"outer": _ring(part.exterior), "holes": [_ring(hole) for hole in part.interiors]}
        for part in parts
        if not part.is_empty
    ]


def _ring(ring: Any) -> list[list[float]]:
    return [[x, y] for x, y in list(ring.coords)[:-1]]


def main(mode: str) -> None:
    hello: dict[str, Any] = {
        "name": NAMES[mode],
        "version": f"{shapely.geos_version_string} (Shapely {version('shapely')})",
        "language": "C++",
        "arithmetic": "float64",
        "numbers": "double",
        "tolerance": {"absolute": "0", "relative": TOLERANCES[mode]},
        "sum": "none",
        "capabilities": [
            "plane",
            "non-convex",
            "holes",
            "components",
            "touching",
            "empty",
            *(("point", "segment", *BUFFER) if mode == "buffer" else ("union",)),
        ],
    }
    if mode == "buffer":
        hello["tolerance"] = {"relative": TOLERANCES[mode], "radius": OF_RADIUS}
        serve(hello, None, offset_of=grown)
        return

    def union_of(sets: list[Set]) -> dict[str, Any]:
        areas = [area(each["polygons"]) for each in sets]
        found = shapely.union_all(areas, grid_size=unit(sets) if mode == "grid" else None)
        return {"polygons": polygons_of(found)}

    serve(hello, None, union_of=union_of)


if __name__ == "__main__":
    main(sys.argv[1])
