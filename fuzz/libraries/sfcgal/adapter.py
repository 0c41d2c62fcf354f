"""SFCGAL (the Python package PySFCGAL): the argument is plane, its minkowski_sum, or space.

Exact in and out: its WKT has fractions. In the plane the first operand may have several polygons,
but not the second ("the second argument must be a polygon"); so `components` is not declared. Both
operands accept holes silently, so `holes` is. In space the call goes to minkowski_sum_3d in the C
library, which the package binds and does not wrap: solids with a single shell (for more, its
validation says "not fully implemented"); so `holes` is not declared there.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Iterable
from importlib.metadata import version
from typing import Any

from adapter_protocol import Set, Skipped, serve  # type: ignore[import-not-found,unused-ignore]
from pysfcgal._sfcgal import lib  # type: ignore[import-not-found,unused-ignore]
from pysfcgal.geometry import Geometry  # type: ignore[import-not-found,unused-ignore]
from surfaces import triangles_of  # type: ignore[import-not-found,unused-ignore]

NUMBER = re.compile(r"-?\d+(?:/\d+)?")


def wkt_ring(ring: Iterable[Any]) -> str:
    points = [" ".join(str(x) for x in point) for point in ring]
    return f"({','.join([*points, points[0]])})"


def wkt_plane(polygons: list[dict[str, Any]]) -> str:
    """The polygons as WKT, a single one as POLYGON: a user would write it so."""
    texts = []
    for polygon in polygons:
        if len(polygon["outer"]) < 3:
            raise Skipped("no points or segments")
        texts.append(f"({','.join(wkt_ring(r) for r in (polygon['outer'], *polygon['holes']))})")
    if not texts:
        return "POLYGON EMPTY"
    return f"POLYGON {texts[0]}" if len(texts) == 1 else f"MULTIPOLYGON ({','.join(texts)})"


def wkt_space(mesh: Set) -> str:
    """One shell of triangles."""
    vertices = mesh["vertices"]
    faces = triangles_of(vertices, mesh["faces"])
    triangles = [f"({wkt_ring(vertices[i] for i in face)})" for face in faces]
    return f"SOLID Z (({','.join(triangles)}))"


def rings_of(wkt: str) -> list[list[list[str]]]:
    """The innermost parentheses of a WKT text, without the vertex that closes each."""
    rings = [
        [NUMBER.findall(point) for point in text.split(",")]
        for text in re.findall(r"\(([^()]+)\)", wkt)
    ]
    return [ring[:-1] for ring in rings]


def plane_sum(sP: Set, Q: Set) -> dict[str, Any]:
    first = Geometry.from_wkt(wkt_plane(sP["polygons"]))
    result = first.minkowski_sum(Geometry.from_wkt(wkt_plane(Q["polygons"])))
    if result is None:
        raise ValueError("no geometry came back (the log has SFCGAL's reason)")
    # Polygons of an area do not overlap, whatever way their rings run: counted by parity.
    return {"rings": rings_of(result.to_wkt()), "fill": "evenodd"}


def space_sum(sP: Set, Q: Set) -> dict[str, Any]:
    first, second = (Geometry.from_wkt(wkt_space(mesh)) for mesh in (sP, Q))
    handle = lib.sfcgal_geometry_minkowski_sum_3d(first._geom, second._geom)
    result = Geometry.from_sfcgal_geometry(handle)
    if result is None:
        raise ValueError("no geometry came back (the log has SFCGAL's reason)")
    numbers: dict[tuple[str, ...], int] = {}
    faces = [
        [numbers.setdefault(tuple(point), len(numbers)) for point in ring]
        for ring in rings_of(result.to_wkt())
    ]
    return {"vertices": [list(vertex) for vertex in numbers], "faces": faces}


def main(mode: str) -> None:
    capabilities = {
        "plane": ["plane", "non-convex", "holes", "rational"],
        "space": ["space", "non-convex", "rational", "non-uniform"],
    }
    hello = {
        "name": "pysfcgal" if mode == "plane" else "pysfcgal-space",
        "version": version("pysfcgal"),
        "language": "C++",
        "arithmetic": "exact",
        "numbers": "text",
        "sum": "region",
        "capabilities": capabilities[mode],
    }
    key = {"plane": "polygons", "space": "vertices"}[mode]
    compute = {"plane": plane_sum, "space": space_sum}[mode]

    def sum_of(sP: Set, Q: Set) -> dict[str, Any]:
        if key not in sP or key not in Q:
            raise Skipped("in the plane only" if mode == "plane" else "in space only")
        return compute(sP, Q)

    serve(hello, sum_of)


if __name__ == "__main__":
    main(sys.argv[1])
