"""Ends of parts of the medial axis: as far from three nearest sites, or right between two."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import cmp_to_key
from math import atan2, isfinite, sqrt
from typing import Any

from .equidistant import Line, Spot, places
from .equidistant import Place as Told
from .number import Number, number, root
from .outline import Corner, Edge, Outline, cross, dot, minus

CLOSE = 1e-9  # of size and radius: what doubles do not tell
ROUGH = 1e-6  # the same of a place found in doubles
Exact = tuple[Number, Number]
Rounded = tuple[float, float, float, float, float, int]  # start, way, squared length, number


@dataclass(eq=False)
class Foot:
    """A nearest point, seen from its place along `way`. Sites right and left of the way differ
    right before an edge's end."""

    right: int
    left: int
    way: tuple[Any, Any]

    @property
    def angle(self) -> float:
        return atan2(float(self.way[1]), float(self.way[0]))


@dataclass(eq=False)
class Place:
    """A place equally far from its nearest `sites`; feet run counter-clockwise."""

    x: Number
    y: Number
    square: Number
    sites: frozenset[int]
    feet: list[Foot] = field(default_factory=list)

    def __post_init__(self) -> None:
        self.near = float(self.x), float(self.y), sqrt(max(float(self.square), 0.0))

    def turn(self, k: int) -> int:
        """How the distance changes along the part between foot k and the next: -1 falls, 1 grows, 0
        neither to the first order."""
        (a, b), (c, d) = self.feet[k].way, self.feet[(k + 1) % len(self.feet)].way
        return -number(a * d - b * c).sign()


class Finder:
    """Finds all places. `in_doubles` drops candidates by doubles first; without, each candidate is
    made exactly, a hundred times slower."""

    def __init__(self, outline: Outline, in_doubles: bool = True) -> None:
        self.outline, self.in_doubles = outline, in_doubles
        self.sites = outline.sites
        edges = outline.edges
        self.corner_at = {c.at: k for k, c in enumerate(outline.corners, len(edges))}
        self.exact = [_told(site) for site in self.sites]
        self.rounded = [tuple(map(float, told)) for told in self.exact]
        self.near_edges: list[Rounded] = [_rounded(edge, k) for k, edge in enumerate(edges)]
        self.parallel = {
            (i, j)
            for i, edge in enumerate(edges)
            for j, other in enumerate(edges)
            if cross(edge.along, other.along) == 0
        }
        self.blockers = list(self.near_edges)
        self.size = max((max(abs(a), abs(b)) for a, b, *_ in self.near_edges), default=0.0)
        self.found: list[Place] = []
        self.beside: list[list[Place]] = [[] for _ in self.sites]

    def places(self) -> list[Place]:
        beside = [
            {j for j in range(i + 1, len(self.sites)) if self._may_face(i, j)}
            for i in range(len(self.sites))
        ]
        for i, others in enumerate(beside):
            for j in others:
                self._add_middle(i, j)
                for k in others & beside[j]:
                    self._add_equidistant((i, j, k))
        return self.found

    def _may_face(self, i: int, j: int) -> bool:
        """Whether each site reaches in front of the second. Edges come before corners."""
        a, b = self.sites[i], self.sites[j]
        if isinstance(a, Corner):
            return True
        if isinstance(b, Corner):
            return b.at in (a.a, a.b) or a.over(b.at) > 0
        if cross(a.along, b.along) == 0 and dot(a.along, b.along) > 0:
            return False
        return max(a.over(b.a), a.over(b.b)) > 0 and max(b.over(a.a), b.over(a.b)) > 0

    def _add_middle(self, i: int, j: int) -> None:
        """The place right between a corner and a corner or edge."""
        a, b = self.sites[i], self.sites[j]
        if not isinstance(b, Corner):
            return
        if isinstance(a, Corner):
            foot = a.at
        else:
            if b.at in (a.a, a.b) or not 0 < dot(a.along, minus(b.at, a.a)) < a.square:
                return
            part = a.over(b.at) / a.square
            foot = b.at[0] - part * a.normal[0], b.at[1] - part * a.normal[1]
        (x, y), (u, v) = foot, b.at
        square = ((x - u) ** 2 + (y - v) ** 2) / 4
        self._add((x + u) / 2, (y + v) / 2, square, {i, j})

    def _add_equidistant(self, triple: tuple[int, int, int]) -> None:
        own = set()
        lines = [k for k in triple if k < len(self.outline.edges)]
        spots = [k for k in triple if k >= len(self.outline.edges)]
        for i, line in enumerate(lines):
            for j, spot in enumerate(spots):
                edge, corner = self.sites[line], self.sites[spot]
                assert isinstance(edge, Edge) and isinstance(corner, Corner)
                if corner.at in (edge.a, edge.b):
                    own.add((i, j))

        def solved(told: list[Any], take_root: Any) -> list[Told]:
            of_lines: list[Line] = [told[k] for k in lines]
            of_spots: list[Spot] = [told[k] for k in spots]
            are_parallel = len(lines) == 2 and (lines[0], lines[1]) in self.parallel
            return places(of_lines, of_spots, own, are_parallel, take_root)

        if self.in_doubles:
            try:
                candidates = solved(self.rounded, _rounded_root)
            except ZeroDivisionError:
                candidates = []
            if not any(self._may_be_new(triple, *told) for told in candidates):
                return
        for x, y, square in solved(self.exact, root):
            self._add(x, y, square, set(triple))

    def _may_be_new(self, triple: tuple[int, ...], x: float, y: float, square: float) -> bool:
        if not (isfinite(x) and isfinite(y) and 0 < square < 1e200):
            return False
        radius = sqrt(square)
        slack = ROUGH * (radius + self.size)
        near = (radius - slack) ** 2 if radius > slack else 0.0
        far = (radius + slack) ** 2
        for k in triple:
            if k < len(self.near_edges) and _squared_distance(self.near_edges[k], x, y) > far:
                return False
        blockers = self.blockers
        for rank, edge in enumerate(blockers):
            if _squared_distance(edge, x, y) < near:
                if rank:  # the next candidate is often near the same edge
                    blockers.insert(0, blockers.pop(rank))
                return False
        small = CLOSE * (radius + self.size)
        return not any(
            abs(place.near[0] - x) + abs(place.near[1] - y) < small
            and place.sites.issuperset(triple)
            for place in self.beside[triple[0]]
        )

    def _add(self, x: Any, y: Any, square: Any, members: set[int]) -> None:
        place = Place(number(x), number(y), number(square), frozenset(members))
        if place.square.sign() <= 0:
            return
        sites = self._nearest(place, members)
        if sites is None or not members <= sites:
            return
        place.sites = frozenset(sites)
        small = CLOSE * (place.near[2] + self.size)
        for other in self.beside[min(sites)]:
            close = all(abs(a - b) < small for a, b in zip(place.near, other.near, strict=True))
            if close and other.sites == place.sites and _is_same(place, other):
                return
        place.feet = self._feet(place)
        self.found.append(place)
        for k in place.sites:
            self.beside[k].append(place)

    def _nearest(self, place: Place, members: set[int]) -> set[int] | None:
        """The nearest sites, or None if something is nearer than the place's own radius."""
        x, y, radius = place.near
        slack = CLOSE * (radius + self.size)
        found: set[int] = set()
        for told in self.near_edges:
            far = sqrt(_squared_distance(told, x, y))
            if far > radius + slack:
                continue
            if far < radius - slack:
                return None
            for k, square in self._feet_on(told[5], place):
                if k is None:
                    return None
                if k not in members:
                    sign = number(square - place.square).sign()
                    if sign < 0:
                        return None
                    if sign > 0:
                        continue
                found.add(k)
        return found

    def _feet_on(self, k: int, place: Place) -> Iterator[tuple[int | None, Any]]:
        """Sites of a closed edge near a place, with squared distances; None for a reflex vertex, or
        from behind."""
        edge = self.sites[k]
        assert isinstance(edge, Edge)
        dx, dy = edge.along
        nx, ny = edge.normal
        after = [
            number(dx * (place.x - p[0]) + dy * (place.y - p[1])).sign() for p in (edge.a, edge.b)
        ]
        over = place.x * nx + place.y * ny - edge.height
        if after[0] >= 0 and after[1] <= 0:
            yield (k if over.sign() > 0 else None), over * over / edge.square
        for p, is_there in ((edge.a, after[0] <= 0), (edge.b, after[1] >= 0)):
            if is_there:
                x, y = place.x - p[0], place.y - p[1]
                yield self.corner_at.get(p), x * x + y * y

    def _feet(self, place: Place) -> list[Foot]:
        found = []
        taken = set()
        edges = [k for k in place.sites if k < len(self.outline.edges)]
        for k in place.sites - set(edges):
            corner = self.sites[k]
            assert isinstance(corner, Corner)
            foot = Foot(k, k, (corner.at[0] - place.x, corner.at[1] - place.y))
            for e in edges:
                edge = self.sites[e]
                assert isinstance(edge, Edge)
                if corner.at == edge.a:
                    foot.right = e
                    taken.add(e)
                if corner.at == edge.b:
                    foot.left = e
                    taken.add(e)
            found.append(foot)
        for e in edges:
            if e not in taken:
                edge = self.sites[e]
                assert isinstance(edge, Edge)
                found.append(Foot(e, e, (-edge.normal[0], -edge.normal[1])))
        return sorted(found, key=cmp_to_key(_before))


def _before(a: Foot, b: Foot) -> int:
    apart = a.angle - b.angle
    if abs(apart) > CLOSE:
        return 1 if apart > 0 else -1
    return -number(a.way[0] * b.way[1] - a.way[1] * b.way[0]).sign()


def _is_same(a: Place, b: Place) -> bool:
    return (a.x - b.x).sign() == 0 and (a.y - b.y).sign() == 0


def _told(site: Edge | Corner) -> tuple[Any, ...]:
    if isinstance(site, Corner):
        return site.at
    return (*site.normal, site.height, site.square, *site.along)


def _rounded_root(value: float) -> float:
    return sqrt(value) if value > 0 else 0.0


def _rounded(edge: Edge, k: int) -> Rounded:
    (x, y), (dx, dy) = edge.a, edge.along
    return float(x), float(y), float(dx), float(dy), float(edge.square), k


def _squared_distance(edge: Rounded, x: float, y: float) -> float:
    ax, ay, dx, dy, square, _ = edge
    x -= ax
    y -= ay
    t = (x * dx + y * dy) / square
    if t > 0:
        if t > 1:
            t = 1.0
        x -= t * dx
        y -= t * dy
    return x * x + y * y
