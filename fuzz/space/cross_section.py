"""Horizontal cross-sections of a result, compared with a prism's region in the plane."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from itertools import pairwise

from minkref import _core
from minkref.fuzz.geometry.region import Region, region_of_polygons
from minkref.fuzz.geometry.space import Point
from minkref.fuzz.plane.tolerance import grown
from minkref.fuzz.space.membership import Surface
from minkref.fuzz.space.prism import Prism

MOST_LEVELS = 64
EMPTY = _core.PolygonSet()
Flat = tuple[Fraction, Fraction]
Sections = dict[Fraction, Region]


def differing_points(prism: Prism, sections: Sections, tolerance: Fraction) -> Iterator[Point]:
    """Yields a point that a cross-section has but the prism has not, and a point for the reverse.
    With a tolerance, also such points beyond a border as wide as the tolerance."""
    for z, section in sections.items():
        there, right = section.set, _at(prism, z)
        if there == right:
            continue
        found = [_core.inner_point(_core.minus(a, b)) for a, b in ((right, there), (there, right))]
        if tolerance:
            found += [
                _core.inner_point(_core.minus(a, grown(b, tolerance)))
                for a, b in ((right, there), (there, right))
            ]
        for flat in found:
            if flat is not None:
                yield (Fraction(flat[0]), Fraction(flat[1]), z)


def sections_agree(prism: Prism, sections: Sections) -> bool:
    """Whether all sections agree. If the result has only upright or level triangles, and no section
    was left out, the result then equals the prism."""
    return all(section.set == _at(prism, z) for z, section in sections.items())


def cross_sections(prism: Prism, surface: Surface) -> tuple[Sections, bool]:
    """Returns sections between consecutive heights of vertices from both, and whether they are
    complete; beyond MOST_LEVELS some are left out. Raises ValueError if the surface is not
    closed."""
    heights = {prism.low, prism.high}
    for triangle in surface.triangles:
        heights.update(Fraction(corner[2], surface.denominator) for corner in triangle)
    levels = [(a + b) / 2 for a, b in pairwise(sorted(heights))]
    chosen = levels[:: 1 + len(levels) // MOST_LEVELS]
    return {z: cross_section(surface, z) for z in chosen}, len(chosen) == len(levels)


def _at(prism: Prism, z: Fraction) -> _core.PolygonSet:
    return prism.region if prism.low < z < prism.high else EMPTY


def cross_section(surface: Surface, z: Fraction) -> Region:
    """Returns the points with positive winding number at this height, which no vertex has. Raises
    ValueError if the surface is not closed."""
    onward: dict[Flat, list[Flat]] = {}
    level = z * surface.denominator
    for triangle, n in zip(surface.triangles, surface.normals, strict=True):
        ends: list[Flat] = []
        for k in range(3):
            a, b = triangle[k - 1], triangle[k]
            if (a[2] > level) != (b[2] > level):
                t = (level - a[2]) / (b[2] - a[2])
                x, y = a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])
                ends.append((x / surface.denominator, y / surface.denominator))
        if len(ends) == 2:
            # The inside is on the left: along the normal turned by a right angle.
            (ax, ay), (bx, by) = ends
            if (bx - ax) * -n[1] + (by - ay) * n[0] < 0:
                ends.reverse()
            onward.setdefault(ends[0], []).append(ends[1])
    rings: list[list[Flat]] = []
    while onward:
        start = next(iter(onward))
        ring = [start]
        while True:
            following = onward.get(ring[-1])
            if not following:
                raise ValueError("the cross-section is not closed")
            there = following.pop()
            if not following:
                del onward[ring[-1]]
            if there == start:
                break
            ring.append(there)
        rings.append(ring)
    return region_of_polygons([[ring] for ring in rings if len(ring) > 2], turned=False)
