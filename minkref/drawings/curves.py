"""Arcs and Bézier curves as polylines within a tolerance.

Corners lie on the curve to a hundredth of the tolerance: short decimals fit all formats, and keep
exact work fast. Given ends keep their coordinates.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import pairwise

Point = tuple[Fraction, Fraction]
REACH = Fraction(49, 50)  # of the tolerance; the rest is for rounding
BITS = 40  # of what is rounded: tangents of angles that have no rational one
DEEPEST = 24  # halvings of a curve
MOST_CORNERS = 100_000  # of a curve


class TooFine(ValueError):
    """A curve that would need more than MOST_CORNERS."""

    def __init__(self) -> None:
        super().__init__(f"a curve needs more than {MOST_CORNERS:,} corners for this tolerance")


def squared(ax: Fraction, ay: Fraction) -> Fraction:
    return ax * ax + ay * ay


def above_root(square: Fraction) -> Fraction:
    """Return a number at least as large as the square root, by less than a millionth more or so."""
    scale = 1 << 40
    return Fraction(math.isqrt(math.ceil(square * scale)) + 1, 1 << 20)


def unit_of(tolerance: Fraction) -> Fraction:
    """Return the largest power of ten up to a hundredth of the tolerance."""
    unit = Fraction(1)
    while unit * 100 > tolerance:
        unit /= 10
    while unit * 1000 <= tolerance:
        unit *= 10
    return unit


def rounded(point: Point, unit: Fraction) -> Point:
    return round(point[0] / unit) * unit, round(point[1] / unit) * unit


def tangent(degrees: Fraction) -> Fraction:
    """The tangent of an angle of at most 45 degrees in absolute value: exact at 0 and 45, else to
    BITS bits."""
    if abs(degrees) in (0, 45):
        return Fraction((degrees > 0) - (degrees < 0))
    return Fraction(round(math.tan(math.radians(float(degrees))) * (1 << BITS)), 1 << BITS)


def turned(degrees: Fraction) -> tuple[Fraction, Fraction]:
    """A rational point on the unit circle, the direction of an angle: exact for multiples of 90
    degrees, else to BITS bits. cos² + sin² is 1 exactly."""
    quarters = round(degrees / 90)
    t = tangent((degrees - 90 * quarters) / 2)
    c, s = (1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)
    for _ in range(quarters % 4):
        c, s = -s, c
    return c, s


def arc_by_bulge(p: Point, q: Point, bulge: Fraction, tolerance: Fraction) -> Iterator[Point]:
    """Yield corners of the arc from p to q, without p: `bulge`: tangent of a quarter of the
    angle, positive to the left."""
    if bulge == 0 or p == q:
        yield q
        return
    dx, dy = q[0] - p[0], q[1] - p[1]
    off = (1 - bulge**2) / (4 * bulge)
    center = ((p[0] + q[0]) / 2 - off * dy, (p[1] + q[1]) / 2 + off * dx)
    square = squared(p[0] - center[0], p[1] - center[1])
    # Half of the arc turns by 2 atan(bulge). A chord of 2 atan(t) is within radius t² / 2.
    unit, reach = unit_of(tolerance), tolerance * REACH
    least = above_root(above_root(square * bulge**4 / (4 * reach**2)))
    count = max(1, math.ceil(least))
    if 2 * count > MOST_CORNERS:
        raise TooFine
    middle = _rotated(p, center, bulge)
    for start in (p, middle):
        for k in range(1, count):
            yield rounded(_rotated(start, center, bulge * k / count), unit)
        yield rounded(middle, unit) if start is p else q


def _rotated(point: Point, center: Point, t: Fraction) -> Point:
    """Turn a point about a center by 2 atan(t)."""
    x, y = point[0] - center[0], point[1] - center[1]
    c, s = (1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)
    return center[0] + c * x - s * y, center[1] + s * x + c * y


def arc_by_angles(
    center: Point, radius: Fraction, first: Fraction, last: Fraction, tolerance: Fraction
) -> list[Point]:
    """Corners of the arc from one angle to another, in degrees, counter-clockwise, both ends too:
    exact at multiples of 90 degrees, else to BITS bits."""
    whole, tolerance = tolerance, tolerance * REACH
    span = (last - first) % 360 or Fraction(360)
    # A chord of an angle d is within radius d² / 8; a degree has less than 7/400.
    count = max(2, math.ceil(span * above_root(radius / (8 * tolerance)) * Fraction(7, 400)))
    while count <= MOST_CORNERS:
        points = []
        for k in range(count + 1):
            c, s = turned(first + span * k / count)
            points.append((center[0] + radius * c, center[1] + radius * s))
        # A chord of squared length d is within T of its arc if d is at most 4 (2 r T - T²).
        most = 4 * (2 * radius * tolerance - tolerance**2)
        chords = (squared(b[0] - a[0], b[1] - a[1]) for a, b in pairwise(points))
        if tolerance >= radius or all(chord <= most for chord in chords):
            unit = unit_of(whole)
            return [points[0], *(rounded(p, unit) for p in points[1:-1]), points[-1]]
        count += 1 + count // 50
    raise TooFine


def circle(center: Point, radius: Fraction, tolerance: Fraction) -> list[Point]:
    """Corners of a circle, counter-clockwise, two half circles from the right."""
    right, left = (center[0] + radius, center[1]), (center[0] - radius, center[1])
    one = Fraction(1)
    return [*arc_by_bulge(right, left, one, tolerance), *arc_by_bulge(left, right, one, tolerance)]


def bezier(points: Sequence[Point], tolerance: Fraction) -> Iterator[Point]:
    """Yield corners of a Bézier curve of any degree, without its first point. A piece is a segment
    once its control points are within the tolerance of it, and the curve is among them."""
    unit, reach = unit_of(tolerance), tolerance * REACH
    # So many equal pieces are enough: d (d - 1) / 8 second differences over the tolerance, rooted.
    bends = [
        squared(a[0] - 2 * b[0] + c[0], a[1] - 2 * b[1] + c[1])
        for a, b, c in zip(points, points[1:], points[2:], strict=False)
    ]
    degree = len(points) - 1
    if degree * (degree - 1) * above_root(max(bends)) > 8 * reach * MOST_CORNERS**2:
        raise TooFine
    pieces = [(list(points), 0)]
    while pieces:
        piece, depth = pieces.pop()
        inner = piece[1:-1]
        if depth == DEEPEST or all(_is_near(p, piece[0], piece[-1], reach) for p in inner):
            yield rounded(piece[-1], unit) if pieces else piece[-1]
            continue
        left, right = _halved(piece)
        pieces += [(right, depth + 1), (left, depth + 1)]


def _halved(points: list[Point]) -> tuple[list[Point], list[Point]]:
    left, right = [points[0]], [points[-1]]
    while len(points) > 1:
        points = [((a[0] + b[0]) / 2, (a[1] + b[1]) / 2) for a, b in pairwise(points)]
        left.append(points[0])
        right.append(points[-1])
    return left, right[::-1]


def _is_near(p: Point, a: Point, b: Point, tolerance: Fraction) -> bool:
    """Tell whether a point is within the tolerance of a segment."""
    dx, dy, x, y = b[0] - a[0], b[1] - a[1], p[0] - a[0], p[1] - a[1]
    length, along = squared(dx, dy), x * dx + y * dy
    if length == 0 or along <= 0:
        return squared(x, y) <= tolerance**2
    if along >= length:
        return squared(p[0] - b[0], p[1] - b[1]) <= tolerance**2
    return (x * dy - y * dx) ** 2 <= tolerance**2 * length
