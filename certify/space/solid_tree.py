"""Each plane of a sum cut until every part is known (docs/certificates-solids.md, "Trees")."""

from __future__ import annotations

from collections.abc import Iterable
from math import gcd
from typing import Any

from minkref.certify.space.rough_area import (
    RoughHalf,
    rough_area,
    rough_half,
    rough_polygon,
    taken_off,
)
from minkref.certify.space.solid_pieces import Hull, ScaledTiling, Whole, outer, primitive
from minkref.certify.space.solid_planes import Plane

Corner = tuple[int, int, int, int]  # (x / w, y / w, z / w), w > 0
Polygon = list[Corner]
HalfSpace = tuple[Whole, int]  # n * x <= height
Pair = tuple[int, int]
Section = tuple[Pair, Polygon]  # the intersection of a polygon with the sum of two pieces
Entry = list[Any]


class TooLarge(Exception):
    """More entries than allowed."""


class Trees:
    """Makes the trees for one sum. `entries` counts the entries written so far."""

    def __init__(self, P: ScaledTiling, Q: ScaledTiling, unit: int, most_entries: int) -> None:
        self.P, self.Q, self.unit = P.hulls, Q.hulls, unit
        self.entries, self.most_entries = 0, most_entries
        self._bounds: dict[Pair, list[HalfSpace]] = {}
        self._rough_halves: dict[HalfSpace, RoughHalf] = {}

    def tree(self, plane: Plane, corners: list[Whole]) -> list[Entry]:
        """Cuts the polygon with these corners along sections' sides. Raises TooLarge. Exact."""
        normal, level = plane
        down = (-normal[0], -normal[1], -normal[2])
        tops = [[hull.support(normal) for hull in of] for of in (self.P, self.Q)]
        lows = [[-hull.support(down) for hull in of] for of in (self.P, self.Q)]
        whole: Polygon = [(x, y, z, 1) for x, y, z in corners]
        above: list[Section] = []
        beneath: list[Section] = []
        for i in range(len(self.P)):
            for j in range(len(self.Q)):
                top, low = tops[0][i] + tops[1][j], lows[0][i] + lows[1][j]
                if not low <= level <= top:
                    continue
                section = cut(whole, self.bounds((i, j)))
                if section and top > level:
                    above.append(((i, j), section))
                if section and low < level:
                    beneath.append(((i, j), section))
        return self._tree(whole, above, beneath)

    def _tree(self, whole: Polygon, above: list[Section], beneath: list[Section]) -> list[Entry]:
        found: list[Entry] = []
        stack = [(whole, above, beneath)]
        while stack:
            self.entries += 1
            if self.entries > self.most_entries:
                raise TooLarge
            polygon, above, beneath = stack.pop()
            over, under = covering(polygon, above), covering(polygon, beneath)
            if over:
                found.append(["above", *over])
            elif not beneath:
                found.append(["none"])
            elif under and not above:
                found.append(["face", *under])
            else:
                half = self._best_cut(polygon, above or beneath)
                found.append(["cut", *self._in_units(half)])
                for side in (opposite(half), half):
                    part = below(polygon, side)
                    stack.append((part, cut_all(above, side), cut_all(beneath, side)))
        return found

    def _best_cut(self, polygon: Polygon, sections: list[Section]) -> HalfSpace:
        """The half-space along the largest section that takes most off. Section and half-space are
        chosen in floating point: any choice would do."""
        seen = rough_polygon(polygon, self.unit)
        sizes = [rough_area(rough_polygon(section, self.unit)) for _, section in sections]
        pair, _ = sections[sizes.index(max(sizes))]
        halves = [half for half in self.bounds(pair) if rises_above(polygon, half)]
        return max(halves, key=lambda half: taken_off(seen, self._rough(half)))

    def _rough(self, half: HalfSpace) -> RoughHalf:
        if half not in self._rough_halves:
            self._rough_halves[half] = rough_half(half, self.unit)
        return self._rough_halves[half]

    def _in_units(self, half: HalfSpace) -> list[int]:
        """Returns the half-space for points without units."""
        (a, b, c), height = half
        common = gcd(self.unit, height)
        k = self.unit // common
        return [a * k, b * k, c * k, height // common]

    def bounds(self, pair: Pair) -> list[HalfSpace]:
        if pair not in self._bounds:
            self._bounds[pair] = half_spaces(self.P[pair[0]], self.Q[pair[1]])
        return self._bounds[pair]


def half_spaces(A: Hull, B: Hull) -> list[HalfSpace]:
    """Half-spaces whose intersection equals the sum of two convex pieces."""
    normals = dict.fromkeys([*A.facets, *B.facets])
    for e in A.ways:
        for f in B.ways:
            x, y, z = n = primitive(outer(e, f))
            if n != (0, 0, 0):
                normals[n] = normals[(-x, -y, -z)] = None
    return [(n, A.support(n) + B.support(n)) for n in normals]


def opposite(half: HalfSpace) -> HalfSpace:
    (a, b, c), height = half
    return (-a, -b, -c), -height


def rises_above(polygon: Polygon, half: HalfSpace) -> bool:
    (a, b, c), height = half
    return any(a * x + b * y + c * z > height * w for x, y, z, w in polygon)


def below(polygon: Polygon, half: HalfSpace) -> Polygon:
    """The part of a convex polygon below a plane; nothing if the part has no area; the polygon
    itself if it is not cut, or lies in the plane."""
    (a, b, c), height = half
    levels = [a * x + b * y + c * z - height * w for x, y, z, w in polygon]
    if max(levels) <= 0:
        return polygon
    if min(levels) >= 0:
        return []
    kept: Polygon = []
    for k, q in enumerate(polygon):
        p, at_p, at_q = polygon[k - 1], levels[k - 1], levels[k]
        if at_p * at_q < 0:
            x, y, z, w = (abs(at_q) * s + abs(at_p) * t for s, t in zip(p, q, strict=True))
            d = gcd(x, y, z, w)
            kept.append((x // d, y // d, z // d, w // d))
        if at_q <= 0:
            kept.append(q)
    return kept


def cut(polygon: Polygon, halves: Iterable[HalfSpace]) -> Polygon:
    for half in halves:
        if polygon:
            polygon = below(polygon, half)
    return polygon


def cut_all(sections: list[Section], half: HalfSpace) -> list[Section]:
    parts = ((pair, below(polygon, half)) for pair, polygon in sections)
    return [(pair, polygon) for pair, polygon in parts if polygon]


def covering(polygon: Polygon, sections: list[Section]) -> Pair | None:
    """A pair whose section covers the whole polygon, or None. The pair (0, 0) is a result, too."""
    corners = set(polygon)
    return next((pair for pair, section in sections if corners <= set(section)), None)
