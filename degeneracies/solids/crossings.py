"""Points where three facets of the convolution cross at scale 1, in whole numbers only."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from functools import cache

from minkref.degeneracies.solids.convolution import Convolution, ConvolutionFacet
from minkref.degeneracies.solids.overlaps import triangles_of
from minkref.fuzz.geometry.space import Whole, cross, dot, longest_axis

ONE = Fraction(1)
Three = tuple[ConvolutionFacet, ConvolutionFacet, ConvolutionFacet]


class _Seen:
    """A facet with whole corners, seen along an axis."""

    def __init__(self, convolution: Convolution, facet: ConvolutionFacet) -> None:
        self.facet = facet
        self.offset = int(facet.offset(ONE))
        self.axis = longest_axis(facet.normal)
        ring = convolution.corners(facet, ONE)
        self.corners: list[Whole] = [(int(x), int(y), int(z)) for x, y, z in ring]
        self.triangles = [
            [(int(x), int(y)) for x, y in triangle]
            for triangle in triangles_of(convolution, facet, ONE, self.axis)
        ]

    def is_on_both_sides_of(self, other: _Seen) -> bool:
        """Whether corners lie on both sides of the plane of `other`. If not, the plane holds no
        inner point of this facet, or all."""
        heights = [dot(other.facet.normal, corner) for corner in self.corners]
        return min(heights) < other.offset < max(heights)

    def has_inside(self, point: Whole, unit: int) -> bool:
        """Whether a triangle holds the point, divided by a positive number, in its interior."""
        x = point[(self.axis + 1) % 3], point[(self.axis + 2) % 3]
        return any(
            all(
                (b[0] - a[0]) * (x[1] - a[1] * unit) > (b[1] - a[1]) * (x[0] - a[0] * unit)
                for a, b in ((u, v), (v, w), (w, u))
            )
            for u, v, w in self.triangles
        )


def crossings(convolution: Convolution, facets: list[ConvolutionFacet]) -> Iterator[Three]:
    """Yields triples of facets with a common inner point, for a pair with whole coordinates, in the
    list's order. Exact. Quadratic, plus the triples any two of whose facets have corners on both
    sides of each other's plane."""
    seen = [_Seen(convolution, facet) for facet in facets]

    @cache
    def later(a: int) -> list[int]:
        return [
            b
            for b in range(a + 1, len(seen))
            if seen[a].is_on_both_sides_of(seen[b]) and seen[b].is_on_both_sides_of(seen[a])
        ]

    for a, one in enumerate(seen):
        with_one = set(later(a))
        for b in later(a):
            other = seen[b]
            across = cross(one.facet.normal, other.facet.normal)
            for c in later(b):
                third = seen[c]
                n = third.facet.normal
                unit = dot(n, across)
                if c not in with_one or unit == 0:
                    continue
                parts = (
                    (across, third.offset),
                    (cross(other.facet.normal, n), one.offset),
                    (cross(n, one.facet.normal), other.offset),
                )
                x, y, z = (sum(d * part[k] for part, d in parts) for k in range(3))
                point = (x, y, z) if unit > 0 else (-x, -y, -z)
                if all(each.has_inside(point, abs(unit)) for each in (one, other, third)):
                    yield one.facet, other.facet, third.facet
