"""Right implementations of the verb `offset`, from the page of the protocol alone, each with the
tolerance that it documents: polygons inside of arcs, around them, with corners elsewhere, rounded
to a grid, GEOS by Shapely with many segments, and sharp corners."""

from __future__ import annotations

import math
from typing import Any, ClassVar

from plain_offset import How, PlainOffset, Point, Ring, rings_of
from sharp_faults import PlainSharp


class Inside(PlainOffset):
    """Misses 1 - cos(pi / 64) of the radius."""

    tolerance: ClassVar[dict[str, str]] = {"relative": "1e-12", "radius": "0.00125"}


class Around(PlainOffset):
    """Exceeds the radius 1 / cos(pi / 64) times."""

    tolerance: ClassVar[dict[str, str]] = {"relative": "1e-12", "radius": "0.00125"}

    def disc(self, v: Point, r: float) -> Ring:
        return super().disc(v, r / math.cos(math.pi / self.corners))


class OtherCorners(PlainOffset):
    """Misses 1 - cos(pi / 37)."""

    corners, turn = 37, 0.2
    tolerance: ClassVar[dict[str, str]] = {"relative": "1e-12", "radius": "0.0037"}


class Rounded(PlainOffset):
    """Rounds the answer to multiples: the largest number times 2^-30."""

    tolerance: ClassVar[dict[str, str]] = {"relative": "1e-8", "radius": "0.00125"}

    def finished(self, rings: list[Ring], r: float) -> list[Ring]:
        size = max((abs(x) for ring in rings for p in ring for x in p), default=1.0) or 1.0
        unit = math.ldexp(1.0, math.frexp(size)[1] - 30)
        return super().finished(
            [[(unit * round(x / unit), unit * round(y / unit)) for x, y in ring] for ring in rings],
            r,
        )


class ByShapely(PlainOffset):
    """Its polygons for arcs miss 1 - cos(pi / 256); GEOS takes away shallow bends, up to a
    hundredth of the radius."""

    tolerance: ClassVar[dict[str, str]] = {"relative": "1e-7", "radius": "0.0125"}
    lacks = ("join-square",)

    def answer(self, P: dict[str, Any], radius: float, how: How) -> dict[str, Any]:
        import shapely  # type: ignore[import-not-found,import-untyped,unused-ignore]

        if "lines" in P:
            parts = [shapely.LineString(x) if x[1:] else shapely.Point(x[0]) for x in P["lines"]]
            given = shapely.GeometryCollection(parts)
        else:
            parts = [self._part(shapely, rings) for rings in rings_of(P)]
            areas = all(part.geom_type == "Polygon" for part in parts)
            given = shapely.MultiPolygon(parts) if areas else shapely.GeometryCollection(parts)
        found = given.buffer(
            radius, quad_segs=64, cap_style=how.get("cap", "round"),
            join_style=how.get("join", "round"), mitre_limit=how.get("limit", 5),
        )  # fmt: skip
        polygons = [g for g in getattr(found, "geoms", [found]) if g.geom_type == "Polygon"]
        return {
            "polygons": [
                {"outer": self._ring(g.exterior), "holes": [self._ring(h) for h in g.interiors]}
                for g in polygons
                if not g.is_empty
            ]
        }

    def _part(self, shapely: Any, rings: list[Ring]) -> Any:
        if len(rings[0]) < 3:
            return shapely.LineString(rings[0]) if rings[0][1:] else shapely.Point(rings[0][0])
        return shapely.Polygon(rings[0], rings[1:])

    def _ring(self, ring: Any) -> list[list[float]]:
        return [[x, y] for x, y in list(ring.coords)[:-1]]


RIGHT: dict[str, type[Any]] = {
    "inside": Inside, "around": Around, "other-corners": OtherCorners, "rounded": Rounded,
    "shapely": ByShapely, "sharp": PlainSharp,
}  # fmt: skip
