"""Distances from a set in the plane: exact, with the nearest feature; doubles sort out the rest."""

from __future__ import annotations

import math
from dataclasses import dataclass
from fractions import Fraction
from typing import ClassVar

from minkref.fuzz.geometry.plane import Point, Shape, Vector, contains, dot, edges, minus

ROUNDED = 1e-11  # times the largest coordinate: more than doubles lose in a distance
INSIDE, OUTSIDE = ("inside",), ("outside",)
Spot = tuple[float, float]
Exact = Vector[Fraction]
ExactEdge = tuple[Exact, Exact]


@dataclass(frozen=True)
class Distance:
    """`nearest`: "inside", or "outside" of a region whose outside is meant; "vertex" and its
    coordinates; "edge" and those of both ends."""

    square: Fraction
    nearest: tuple[str, ...]


class Distances:
    """Distances from a set that is not empty, a region, a segment or a point."""

    def __init__(self, shape: Shape) -> None:
        self.shape = shape
        self.edges = list(dict.fromkeys(exact_edges(shape)))
        self.origin = self.edges[0][0]
        self.walls = [(self.spot(a), self.spot(b)) for a, b in self.edges]
        self.size = max(abs(x) for wall in self.walls for spot in wall for x in spot)

    inner: ClassVar[tuple[str, ...]] = INSIDE  # the nearest feature of a point of the set

    def has(self, point: Point) -> bool:
        """Whether the set has a point; either answer serves on the boundary."""
        return contains(self.shape, point)

    def seeds(self) -> list[Exact]:
        """Finds a point of each component."""
        return [exact(polygon[0][0]) for polygon in self.shape]

    def of(self, point: Point) -> Distance:
        """O(n) in doubles; exact for the edges that doubles leave open."""
        if self.has(point):
            return Distance(Fraction(0), self.inner)
        spot, place = self.spot(point), exact(point)
        rounded = [spot_distance(spot, *wall) for wall in self.walls]
        most = min(rounded) + ROUNDED * (self.size + abs(spot[0]) + abs(spot[1]))
        near = (edge for edge, off in zip(self.edges, rounded, strict=True) if off <= most)
        return min((from_edge(place, edge) for edge in near), key=lambda found: found.square)

    def place(self, spot: Spot) -> Exact:
        """The point of a spot, exactly."""
        return (self.origin[0] + Fraction(spot[0]), self.origin[1] + Fraction(spot[1]))

    def spot(self, point: Point) -> Spot:
        """The point from the origin of the set, rounded."""
        return (float(point[0] - self.origin[0]), float(point[1] - self.origin[1]))


class OutsideDistances(Distances):
    """Distances from the outside of a region: the closure of its complement. A region eroded by a
    disc has the points farther than the radius, and those just as far."""

    inner = OUTSIDE

    def has(self, point: Point) -> bool:
        return not contains(self.shape, point)

    def seeds(self) -> list[Exact]:
        """Finds a point of each hole; the component around all holds no result wholly."""
        return [exact(hole[0]) for polygon in self.shape for hole in polygon[1:]]


def exact(point: Point) -> Exact:
    return (Fraction(point[0]), Fraction(point[1]))


def exact_edges(shape: Shape) -> list[ExactEdge]:
    return [(exact(a), exact(b)) for a, b in edges(shape)]


def from_edge(point: Exact, edge: ExactEdge) -> Distance:
    a, b = edge
    along, way = minus(b, a), minus(point, a)
    length, part = dot(along, along), dot(along, way)
    if part <= 0 or part >= length:
        end = a if part <= 0 else b
        off = minus(point, end)
        return Distance(Fraction(dot(off, off)), ("vertex", *map(str, end)))
    over = along[0] * way[1] - along[1] * way[0]
    return Distance(Fraction(over * over) / length, ("edge", *map(str, (*a, *b))))


def spot_distance(spot: Spot, a: Spot, b: Spot) -> float:
    """From a segment, in doubles."""
    dx, dy = b[0] - a[0], b[1] - a[1]
    x, y = spot[0] - a[0], spot[1] - a[1]
    square = dx * dx + dy * dy
    t = min(max((x * dx + y * dy) / square, 0.0), 1.0) if square > 0 else 0.0
    return math.hypot(x - t * dx, y - t * dy)


def nearest_places(a: Exact, b: Exact, edge: ExactEdge) -> list[Exact]:
    """Points of the segment a b, one of which is nearest to the edge, if the two do not cross."""
    u = minus(b, a)
    square = Fraction(dot(u, u))
    found = [a, b]
    for end in edge:
        t = dot(minus(end, a), u) / square
        if 0 < t < 1:
            found.append((a[0] + t * u[0], a[1] + t * u[1]))
    return found
