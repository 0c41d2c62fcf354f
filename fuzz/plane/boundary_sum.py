"""The sum of two polygon sets' boundaries, which some libraries compute under the name Minkowski
sum."""

from __future__ import annotations

from fractions import Fraction

from minkref import _core
from minkref.fuzz.geometry.plane import (
    Edge,
    Point,
    Shape,
    crossing,
    edges,
    in_box,
    read_shape,
    scale_factors,
    segments_meet,
    turn,
)
from minkref.fuzz.geometry.region import Region
from minkref.fuzz.plane.case import Case
from minkref.fuzz.plane.exact_shapes import set_of
from minkref.fuzz.verdicts.verdict import Witness

MOST_PAIRS = 10_000  # pairs of edges


def boundary_sum(case: Case) -> Region:
    """Unites the parallelograms of all pairs of edges, regularised: parallel edges contribute
    nothing. O(m n) parallelograms."""
    polygons: Shape = []
    second = edges(read_shape(case.Q_json))
    for a, b in edges(read_shape(case.scaled_P_json)):
        for c, d in second:
            u, v = (b[0] - a[0], b[1] - a[1]), (d[0] - c[0], d[1] - c[1])
            area = u[0] * v[1] - u[1] * v[0]
            if area == 0:
                continue
            ring = [_plus(a, c), _plus(b, c), _plus(b, d), _plus(a, d)]
            polygons.append([ring if area > 0 else ring[::-1]])
    return Region(*_core.canonicalize(set_of(polygons))[:3])


def decide_boundary(case: Case, point: tuple[str, str]) -> Witness:
    """Whether the point is p + q with p and q on the boundaries. O(mn) exact segment tests."""
    s, x = scale_factors(case.scale), (Fraction(point[0]), Fraction(point[1]))
    reflected = edges(read_shape(case.Q_json, Fraction(-1), x))
    for a, b in edges(read_shape(case.P_json, s)):
        for c, d in reflected:
            if segments_meet(a, b, c, d):
                z = _common((a, b), (c, d))
                p = (str(z[0] / s[0]), str(z[1] / s[1]))
                q = (str(x[0] - z[0]), str(x[1] - z[1]))
                return Witness(point, True, p, q, boundary=True)
    return Witness(point, False, boundary=True)


def _common(first: Edge, second: Edge) -> Point:
    """Returns a common point of two segments that meet."""
    (a, b), (c, d) = first, second
    for edge, ends in ((first, second), (second, first)):
        for end in ends:
            if turn(*edge, end) == 0 and in_box(*edge, end):
                return end
    return crossing(a, b, c, d)


def _plus(a: Point, b: Point) -> Point:
    return (a[0] + b[0], a[1] + b[1])
