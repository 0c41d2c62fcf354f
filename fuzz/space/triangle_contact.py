"""Exact tests of two triangles: a common point, a proper crossing, a distance."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from minkref.fuzz.geometry.space import Point, Whole, cross, dot, flattened, longest_axis, minus

Triangle = tuple[Whole, Whole, Whole]
Contact = tuple[Whole, int]  # the point `first / second`


def contact(s: Triangle, n: Whole, t: Triangle, m: Whole) -> tuple[Contact, bool] | None:
    """Returns a common point of two closed triangles with normals `n`, `m`, and whether an edge of
    one passes properly through the other's inside. None for disjoint triangles."""
    # Each corner's side with respect to the other plane.
    above_s = [dot(n, minus(corner, s[0])) for corner in t]
    if min(above_s) > 0 or max(above_s) < 0:
        return None
    above_t = [dot(m, minus(corner, t[0])) for corner in s]
    if min(above_t) > 0 or max(above_t) < 0:
        return None
    found: Contact | None = None
    for first, second, m2, above in ((s, t, m, above_t), (t, s, n, above_s)):
        for k in range(3):
            met = _segment(first[k - 1], first[k], above[k - 1], above[k], second, m2)
            if met is not None:
                if met[1]:
                    return met
                found = found or met[0]
    return None if found is None else (found, False)


def _segment(
    a: Whole, b: Whole, above_a: int, above_b: int, t: Triangle, m: Whole
) -> tuple[Contact, bool] | None:
    """Returns a common point of segment and triangle, and whether the segment crosses the inside
    properly."""
    if (above_a > 0 and above_b > 0) or (above_a < 0 and above_b < 0):
        return None
    if above_a == 0 and above_b == 0:
        point = _in_plane(a, b, t, m)
        return None if point is None else (point, False)
    direction = minus(b, a)
    u, v, w = (minus(corner, a) for corner in t)
    turns = (dot(direction, cross(u, v)), dot(direction, cross(v, w)), dot(direction, cross(w, u)))
    if min(turns) < 0 < max(turns):
        return None
    weight = above_b - above_a
    x, y, z = (above_b * a[k] - above_a * b[k] for k in range(3))
    if weight < 0:
        x, y, z, weight = -x, -y, -z, -weight
    return ((x, y, z), weight), above_a != 0 != above_b and 0 not in turns


def _in_plane(a: Whole, b: Whole, t: Triangle, m: Whole) -> Contact | None:
    """Returns a common point of a coplanar segment and triangle."""
    axis = longest_axis(m)
    sign = 1 if m[axis] > 0 else -1
    corners = [flattened(corner, axis) for corner in t]
    p, q = flattened(a, axis), flattened(b, axis)
    # The segment's part [low, high] on the inner side of every edge.
    low, high = Fraction(0), Fraction(1)
    for k in range(3):
        (ux, uy), (vx, vy) = corners[k - 1], corners[k]
        at_p = sign * ((vx - ux) * (p[1] - uy) - (vy - uy) * (p[0] - ux))
        at_q = sign * ((vx - ux) * (q[1] - uy) - (vy - uy) * (q[0] - ux))
        if at_p < 0 and at_q < 0:
            return None
        if at_p < 0:
            low = max(low, Fraction(at_p, at_p - at_q))
        elif at_q < 0:
            high = min(high, Fraction(at_p, at_p - at_q))
    if low > high:
        return None
    up, down = low.numerator, low.denominator
    x, y, z = (a[k] * (down - up) + b[k] * up for k in range(3))
    return (x, y, z), down


def farther_than(s: Triangle, t: Triangle, distance: int) -> bool:
    """Whether no point of the closed triangle `s` and no point of `t` differ by at most `distance`
    in every coordinate. Exact: the sum of `s`, `-t` and a cube does not contain the origin, so a
    facet normal separates them. The cube needs a positive size."""
    return any(_apart(axis, s, t, distance) for axis in _facet_normals(s, t))


def _facet_normals(s: Triangle, t: Triangle) -> Iterator[Whole]:
    axes: list[Whole] = [(1, 0, 0), (0, 1, 0), (0, 0, 1)]
    yield from axes
    edges_s = [minus(s[k], s[k - 1]) for k in range(3)]
    edges_t = [minus(t[k], t[k - 1]) for k in range(3)]
    yield cross(edges_s[0], edges_s[1])
    yield cross(edges_t[0], edges_t[1])
    for e in edges_s + edges_t:
        for axis in axes:
            yield cross(e, axis)
    for e in edges_s:
        for f in edges_t:
            yield cross(e, f)


def _apart(axis: Whole, s: Triangle, t: Triangle, distance: int) -> bool:
    x, y, z = axis
    of_s = [x * p[0] + y * p[1] + z * p[2] for p in s]
    of_t = [x * p[0] + y * p[1] + z * p[2] for p in t]
    reach = distance * (abs(x) + abs(y) + abs(z))
    return min(of_s) - max(of_t) > reach or min(of_t) - max(of_s) > reach


def as_point(found: Contact, denominator: int) -> Point:
    (x, y, z), weight = found
    down = weight * denominator
    return (Fraction(x, down), Fraction(y, down), Fraction(z, down))
