"""Features of one polygon set, and the judge's document."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import Any

from .alive import Feature, features_at
from .graph import Graph, Incomplete
from .levels import Levels
from .notches import Notch, notches
from .number import Number
from .outline import Corner, Edge, Outline, Point, primitive
from .tiles import shape_counts
from .tracks import Track, tracks
from .tree import Node, Tree

Name = tuple[str, ...]
Polygons = Sequence[Sequence[Sequence[tuple[Any, Any]]]]


class Judge:
    """Reads polygons as lists of rings, outer ring first, numbers as rationals or texts. Exact.
    Some milliseconds for 20 vertices, a second for 50. Places and sites count from `origin`, a
    vertex of the set; names have the given coordinates."""

    def __init__(self, polygons: Polygons) -> None:
        given = [[[(Fraction(x), Fraction(y)) for x, y in ring] for ring in p] for p in polygons]
        self.origin: Point = given[0][0][0]
        x, y = self.origin
        moved = [[[(a - x, b - y) for a, b in ring] for ring in p] for p in given]
        self.outline = Outline(moved)
        try:
            self.graph = Graph(self.outline)
        except Incomplete:  # doubles were too coarse
            self.graph = Graph(self.outline, in_doubles=False)
        self.levels = Levels(self.graph)
        self.tree = Tree(self.levels)

    def squared_radius(self, level: int) -> Number | None:
        """None is infinity."""
        return None if level == self.levels.infinity else self.levels.squares[level]

    def bars(self) -> list[tuple[int, int]]:
        """Levels of birth and death."""
        return sorted((bar.birth, bar.death) for bar in self.tree.bars)

    def tracks(self) -> list[Track]:
        return tracks(self.levels)

    def alive(self, squared_radius: Fraction) -> list[Feature]:
        """Features at a squared radius above 0, one per bar around it."""
        found = features_at(self.tree, squared_radius)
        x, y = self.origin
        for feature in found:
            feature.bridges = [
                (part, ((a + x, b + y), (c + x, d + y)))
                for part, ((a, b), (c, d)) in feature.bridges
            ]
        return found

    def shape_counts(self, squared_radius: Fraction) -> tuple[int, int]:
        """Components and holes of the alpha-shape, a closed set."""
        return shape_counts(self.levels, squared_radius)

    def notches(
        self, alpha: Fraction, persistence: Fraction, alpha_to: Fraction | None = None
    ) -> list[Notch]:
        """Wedges to cut at, in the order of cuts; alpha is a diameter."""
        return notches(self.tree, alpha, persistence, alpha_to)

    def wedge_name(self, k: int) -> Name:
        """A vertex, and the primitive direction of an edge: it leaves the vertex, the wedge to its
        right."""
        wedge = self.outline.wedges[k]
        return "end", *map(str, self._placed(wedge.at)), *map(str, primitive(wedge.second.along))

    def site_name(self, k: int) -> Name:
        """("vertex", x, y), or ("line", dx, dy, c) as docs/disc.md names curves."""
        site = self.outline.sites[k]
        if isinstance(site, Corner):
            return "vertex", *map(str, self._placed(site.at))
        assert isinstance(site, Edge)
        dx, dy = primitive(site.along)
        x, y = self._placed(site.a)
        return "line", str(dx), str(dy), str(dy * x - dx * y)

    def place_name(self, k: int) -> list[Name]:
        return sorted(map(self.site_name, self.graph.places[k].sites))

    def place_near(self, k: int) -> tuple[float, float]:
        place = self.graph.places[k]
        return float(place.x + self.origin[0]), float(place.y + self.origin[1])

    def _placed(self, p: Point) -> Point:
        return p[0] + self.origin[0], p[1] + self.origin[1]

    def document(self) -> dict[str, Any]:
        levels, infinity = self.levels, self.levels.infinity
        leaves = [node for node in self.tree.nodes if node.kind != "node"]
        return {
            "squared_radii": [
                {"expression": str(square), "near": float(square)} for square in levels.squares
            ],
            "places": [
                {"near": self.place_near(k), "level": levels.of_place[k],
                 "feet": len(place.feet), "features": self.place_name(k)}
                for k, place in enumerate(self.graph.places)
            ],
            "leaves": [self._row(node) for node in leaves],
            "nodes": [self._row(node) for node in self.tree.nodes if node.kind == "node"],
            "roots": [self._row(node) for node in self.tree.roots],
            "bars": [
                {"birth": bar.birth, "death": None if bar.death == infinity else bar.death,
                 "essential": bar.is_essential, "leaf": leaves.index(bar.leaf)}
                for bar in sorted(self.tree.bars, key=lambda bar: (bar.birth, bar.death))
            ],
            "tracks": [[low, None if high == infinity else high] for low, high in self.tracks()],
        }  # fmt: skip

    def _row(self, node: Node) -> dict[str, Any]:
        level = None if node.level == self.levels.infinity else node.level
        row: dict[str, Any] = {"kind": node.kind, "level": level}
        if node.kind == "reflex":
            return {**row, "end": self.wedge_name(node.wedge)}
        row["places"] = node.groups
        if node.children:
            row |= {"degree": len(node.children), "tie": node.tie}
        return row
