"""Polygon sets as JSON values, moved, scaled, turned, refined, and their hulls. Exact."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from minkref.fuzz.geometry.plane import ORIGIN, Point, hull

Polygons = list[dict[str, Any]]


def mapped(
    polygons: Polygons,
    factor: Fraction = Fraction(1),
    shift: Point = ORIGIN,
    quarter_turn: bool = False,
) -> Polygons:
    """Scaled by a positive factor or turned by 90 degrees about the origin, then moved."""

    def image(point: list[str]) -> list[str]:
        x, y = Fraction(point[0]), Fraction(point[1])
        if quarter_turn:
            x, y = -y, x
        return [str(factor * x + shift[0]), str(factor * y + shift[1])]

    return [
        {
            "outer": [image(point) for point in polygon["outer"]],
            "holes": [[image(point) for point in hole] for hole in polygon["holes"]],
        }
        for polygon in polygons
    ]


def without_holes(polygons: Polygons) -> Polygons:
    """The outer rings of a single polygon; of several, which may lie in holes of each other, all
    as they are."""
    if len(polygons) != 1:
        return polygons
    return [{"outer": polygons[0]["outer"], "holes": []}]


def refined(polygons: Polygons) -> Polygons:
    """A vertex at a third of every other edge of each ring of three or more."""
    return [
        {
            "outer": _refined(polygon["outer"]),
            "holes": [_refined(hole) for hole in polygon["holes"]],
        }
        for polygon in polygons
    ]


def _refined(ring: list[list[str]]) -> list[list[str]]:
    if len(ring) < 3:
        return ring
    made = []
    for k, point in enumerate(ring):
        made.append(point)
        if k % 2 == 0:
            following = ring[(k + 1) % len(ring)]
            made.append(
                [
                    str((2 * Fraction(a) + Fraction(b)) / 3)
                    for a, b in zip(point, following, strict=True)
                ]
            )
    return made


def hull_of(polygons: Polygons) -> Polygons:
    """The convex hull, counter-clockwise, without collinear vertices; nothing for nothing."""
    points = {(Fraction(x), Fraction(y)) for p in polygons for x, y in p["outer"]}
    if len(points) < 2:
        return polygons
    return [{"outer": [[str(x), str(y)] for x, y in hull(points)], "holes": []}]
