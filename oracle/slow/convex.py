"""Pairs of convex pieces with integer coordinates: which pairs may meet, and the intersection.
Exact."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from .exact import InputError, Vector

Box = tuple[int, int, int, int]
Corners = list[Vector]
Common = list[tuple[Fraction, Fraction]]


def box(points: Corners) -> Box:
    xs, ys = [x for x, _ in points], [y for _, y in points]
    return min(xs), min(ys), max(xs), max(ys)


def boxes_that_meet(
    ours: list[Corners], theirs: list[Corners]
) -> Iterator[tuple[Corners, Corners]]:
    """Yield pairs with meeting boxes, by a sweep over the boxes' left sides."""
    items = [(box(p), 0, p) for p in ours] + [(box(p), 1, p) for p in theirs]
    items.sort(key=lambda item: item[0][0])
    live: tuple[list[tuple[Box, Corners]], list[tuple[Box, Corners]]] = ([], [])
    for (left, low, right, high), whose, points in items:
        others = [entry for entry in live[1 - whose] if entry[0][2] >= left]
        live[1 - whose][:] = others
        for (_, other_low, _, other_high), other in others:
            if other_low <= high and low <= other_high:
                yield (points, other) if whose == 0 else (other, points)
        live[whose].append(((left, low, right, high), points))


def sides_of(points: Corners) -> list[tuple[Vector, Vector]]:
    return list(zip(points, points[1:] + points[:1], strict=True)) if len(points) > 1 else []


def apart(a: Corners, b: Corners) -> bool:
    """Tell whether some side of the convex polygon `a` has all of `b` strictly to its right."""
    for (x0, y0), (x1, y1) in sides_of(a):
        dx, dy = x1 - x0, y1 - y0
        if all(dx * (y - y0) < dy * (x - x0) for x, y in b):
            return True
    return False


def clipped(a: Corners, b: Corners) -> Common:
    """Return corners of two convex pieces' intersection (perhaps repeated); empty without an
    intersection."""
    if len(a) < len(b):
        a, b = b, a
    if apart(a, b) or apart(b, a):
        return []
    rest: Common = [(Fraction(x), Fraction(y)) for x, y in b]
    if len(a) < 3:
        raise InputError("only one of the two operands may be a point or a segment")
    for (x0, y0), (x1, y1) in sides_of(a):
        dx, dy = x1 - x0, y1 - y0
        levels = [dx * (y - y0) - dy * (x - x0) for x, y in rest]
        kept: Common = []
        for i, point in enumerate(rest):
            here, before = levels[i], levels[i - 1]
            if here * before < 0:
                t = before / (before - here)
                (px, py), (qx, qy) = rest[i - 1], point
                kept.append((px + t * (qx - px), py + t * (qy - py)))
            if here >= 0:
                kept.append(point)
        rest = kept
    return rest


def centre(points: Common) -> tuple[Fraction, Fraction]:
    n = len(points)
    x = sum((p[0] for p in points), Fraction(0)) / n
    return x, sum((p[1] for p in points), Fraction(0)) / n
