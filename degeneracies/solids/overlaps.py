"""Whether facets of the convolution have more in common than a tie: an area, or a point."""

from __future__ import annotations

from fractions import Fraction
from itertools import product

from minkref.degeneracies.solids.convolution import Convolution, ConvolutionFacet
from minkref.fuzz.geometry.face_triangles import face_triangles
from minkref.fuzz.geometry.plane import turn
from minkref.fuzz.geometry.space import Point, Whole, denominator_of, longest_axis, whole

Flat = tuple[Fraction, Fraction]
Triangle = tuple[Flat, Flat, Flat]


def share_area(
    convolution: Convolution, one: ConvolutionFacet, other: ConvolutionFacet, s: Fraction
) -> bool:
    """Whether two facets in one plane share an open part of the plane. Exact."""
    axis = longest_axis(one.normal)
    first, second = (triangles_of(convolution, facet, s, axis) for facet in (one, other))
    return any(_meet(a, b) for a, b in product(first, second))


def has_point(
    convolution: Convolution, facet: ConvolutionFacet, x: Point, s: Fraction, inside: bool = False
) -> bool:
    """Whether a facet holds a point of its plane, on the rim or inside; with `inside`, whether the
    point lies inside a triangle of the facet."""
    axis = longest_axis(facet.normal)
    point = _flat(x, axis)
    for a, b, c in triangles_of(convolution, facet, s, axis):
        least = min(turn(u, v, point) for u, v in ((a, b), (b, c), (c, a)))
        if least > 0 or (least == 0 and not inside):
            return True
    return False


def overlapping(
    convolution: Convolution, group: list[ConvolutionFacet], s: Fraction, least: int
) -> list[ConvolutionFacet]:
    """Returns at least so many facets from one plane, each sharing an area with the first; or
    none."""
    for first in group:
        found = [f for f in group if f is not first and share_area(convolution, first, f, s)]
        if len(found) + 1 >= least:
            return [first, *found]
    return []


def triangles_of(
    convolution: Convolution, facet: ConvolutionFacet, s: Fraction, axis: int
) -> list[Triangle]:
    """Counter-clockwise triangles, without one coordinate."""
    ring = convolution.corners(facet, s)
    wholes: list[Whole] = [whole(point, denominator_of(ring)) for point in ring]
    found = []
    for triple in face_triangles(wholes):
        a, b, c = (_flat(ring[k], axis) for k in triple)
        found.append((a, b, c) if turn(a, b, c) > 0 else (a, c, b))
    return found


def _flat(point: Point, axis: int) -> Flat:
    return point[(axis + 1) % 3], point[(axis + 2) % 3]


def _meet(one: Triangle, other: Triangle) -> bool:
    """Whether two open triangles meet: no side of either parts them."""
    return not any(_parted(a, b) for a, b in ((one, other), (other, one)))


def _parted(one: Triangle, other: Triangle) -> bool:
    sides = zip(one, (*one[1:], one[0]), strict=True)
    return any(all(turn(u, v, w) <= 0 for w in other) for u, v in sides)
