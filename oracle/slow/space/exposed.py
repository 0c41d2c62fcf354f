"""A polyhedral set as the exposed region in each oriented plane, and its canonical form
(docs/definitions.md, "Canonical form"): from faces with disjoint interiors, from text, to text.

Within its plane a face equals a sum of directed segments. Segments that run both ways cancel, and
`walks.py` joins the rest to rings.
"""

from __future__ import annotations

import json
from collections import defaultdict
from collections.abc import Iterable
from dataclasses import dataclass
from fractions import Fraction
from itertools import pairwise
from math import lcm
from typing import Any

from ..canonical import document
from ..exact import InputError, Point, Vector, number, primitive
from ..operand import Polygon
from ..plane import Edge, Plane
from ..walks import components, corners
from .solid import Place, Whole, height, inner, outer, plane_of
from .solid_pieces import Plane as SpacePlane

Segment = tuple[Point, Point]


@dataclass(frozen=True)
class Exposed:
    """The exposed polygons for each plane, by primitive normal and offset, seen along the first
    axis with a nonzero normal component."""

    planes: dict[SpacePlane, list[Polygon]]

    def text(self) -> str:
        """Write canonical JSON, provided that the polygons are canonical."""
        rows = []
        for (normal, offset), polygons in sorted(self.planes.items()):
            row = {"normal": [str(n) for n in normal], "offset": str(offset)}
            rows.append({**row, "region": document(polygons)})
        return json.dumps({"planes": rows}, separators=(",", ":"))

    def recast(self) -> Exposed:
        """Return the same set in canonical form. InputError if regions overlap."""
        return exposed(
            (plane, segments)
            for plane, polygons in self.planes.items()
            for segments in ([edge for ring in rings_of(polygons) for edge in sides(ring)],)
        )

    def mapped(self, rows: tuple[Whole, Whole, Whole], shift: Place) -> Exposed:
        """Map the set by a non-singular integer matrix and a translation; canonical again.
        Exact."""
        mirrors = inner(rows[0], outer(rows[1], rows[2])) < 0

        def image(ring: list[Point], plane: SpacePlane) -> list[Place]:
            found = []
            for point in ring if is_mirrored(plane[0]) == mirrors else ring[::-1]:
                place = lifted(point, plane)
                x, y, z = (height(row, place) + s for row, s in zip(rows, shift, strict=True))
                found.append((x, y, z))
            return found

        def images() -> Iterable[tuple[SpacePlane, list[Segment]]]:
            for plane, polygons in self.planes.items():
                for part in polygons:
                    there = plane_of(image(part.outer, plane))
                    axis = viewing_axis(there[0])
                    for ring in rings_of([part]):
                        flat = [seen(point, axis) for point in image(ring, plane)]
                        yield there, sides(flat[::-1] if is_mirrored(there[0]) else flat)

        return exposed(images())

    def volume(self) -> Fraction:
        """Sum the cones from the origin."""
        triple = Fraction(0)
        for (normal, offset), polygons in self.planes.items():
            seen = sum((twice_area(ring) for ring in rings_of(polygons)), Fraction(0)) / 2
            triple += offset * seen / abs(normal[viewing_axis(normal)])
        return triple / 3


def of_faces(faces: Iterable[list[Place]]) -> Exposed:
    """Make the set bounded by planar faces, counter-clockwise seen from outside. InputError if the
    faces in an oriented plane do not have disjoint interiors."""

    def rows() -> Iterable[tuple[SpacePlane, list[Segment]]]:
        for face in faces:
            plane = plane_of(face)
            ring = [seen(point, viewing_axis(plane[0])) for point in face]
            yield plane, sides(ring if twice_area(ring) > 0 else ring[::-1])

    return exposed(rows())


def exposed(rows: Iterable[tuple[SpacePlane, list[Segment]]]) -> Exposed:
    """Make the set from directed boundaries, seen in their planes, with the set to the left."""
    segments: dict[SpacePlane, list[Segment]] = defaultdict(list)
    for plane, edges in rows:
        segments[plane] += edges
    planes = {plane: polygons_of(edges) for plane, edges in segments.items()}
    return Exposed({plane: polygons for plane, polygons in planes.items() if polygons})


def exposed_from_json(value: Any) -> Exposed:
    """Read the JSON form; InputError for other forms. Rings may be anything."""
    try:
        planes: dict[SpacePlane, list[Polygon]] = {}
        for row in value["planes"]:
            a, b, c = (int(text) for text in row["normal"])
            plane = (a, b, c), number(row["offset"])
            if plane in planes:
                raise InputError("a plane is there twice")
            planes[plane] = [
                Polygon(_ring(part["outer"]), [_ring(hole) for hole in part["holes"]])
                for part in row["region"]["polygons"]
            ]
    except (KeyError, TypeError, ValueError) as error:
        raise InputError(f"no polyhedral set: {error}") from error
    return Exposed(planes)


def _ring(rows: list[list[str]]) -> list[Point]:
    return [(number(x), number(y)) for x, y in rows]


def viewing_axis(normal: Whole) -> int:
    return next(k for k in range(3) if normal[k])


def beside(axis: int) -> tuple[int, int]:
    """Return the two other axes, ascending."""
    return (1 if axis == 0 else 0), (1 if axis == 2 else 2)


def seen(point: Place, axis: int) -> Point:
    u, v = beside(axis)
    return point[u], point[v]


def lifted(point: Point, plane: SpacePlane) -> Place:
    """Return the plane's point above a projected point."""
    normal, offset = plane
    axis = viewing_axis(normal)
    u, v = beside(axis)
    place = [Fraction(0)] * 3
    place[u], place[v] = point
    place[axis] = (offset - height(normal, (place[0], place[1], place[2]))) / normal[axis]
    return place[0], place[1], place[2]


def is_mirrored(normal: Whole) -> bool:
    """Tell whether rings counter-clockwise from outside appear clockwise in the projection."""
    axis = viewing_axis(normal)
    return (normal[axis] > 0) == (axis == 1)


def rings_of(polygons: list[Polygon]) -> Iterable[list[Point]]:
    for part in polygons:
        yield part.outer
        yield from part.holes


def sides(ring: list[Point]) -> list[Segment]:
    return list(zip(ring, ring[1:] + ring[:1], strict=True))


def twice_area(ring: list[Point]) -> Fraction:
    return sum((a[0] * b[1] - b[0] * a[1] for a, b in sides(ring)), Fraction(0))


def polygons_of(segments: list[Segment]) -> list[Polygon]:
    """Return the set to the left of the segments, in canonical form. InputError if they bound no
    set."""
    plane, edges = Plane(), []
    for d, stops in summed(segments).items():
        for a, b, runs in stops:
            if runs not in (-1, 1):
                raise InputError("faces in one plane overlap")
            start, end, way = (a, b, d[0]) if runs > 0 else (b, a, (-d[0][0], -d[0][1]))
            edges.append(Edge(start, end, way, runs * d[1]))
            for x, y in (a, b):
                plane.points[x, y] = (x, y, 1)
    found, lone = components(plane, plane.split(edges))
    if lone:
        raise InputError("the exposed part of a plane is not bounded")
    parts = []
    for part in found:
        holes = sorted([edge.start for edge in corners(hole)] for hole in part.holes)
        parts.append(Polygon([edge.start for edge in corners(part.outer)], holes))
    return sorted(parts, key=lambda part: part.outer)


def summed(
    segments: list[Segment],
) -> dict[tuple[Vector, Fraction], list[tuple[Point, Point, int]]]:
    """For each line, directed to the right or upwards, return its pieces between segments' ends,
    with the number of segments forwards minus backwards; pieces with none are left out."""
    steps: dict[tuple[Vector, Fraction], dict[Point, int]] = defaultdict(lambda: defaultdict(int))
    for a, b in segments:
        low, high = min(a, b), max(a, b)
        unit = lcm(*(value.denominator for value in (*low, *high)))
        d = primitive(int((high[0] - low[0]) * unit), int((high[1] - low[1]) * unit))
        line = steps[d, d[0] * low[1] - d[1] * low[0]]
        sign = 1 if a == low else -1
        line[low] += sign
        line[high] -= sign
    found: dict[tuple[Vector, Fraction], list[tuple[Point, Point, int]]] = {}
    for key, line in steps.items():
        stops = sorted(point for point, step in line.items() if step)
        runs = 0
        for a, b in pairwise(stops):
            runs += line[a]
            if runs:
                found.setdefault(key, []).append((a, b, runs))
    return found
