"""Points for comparing a result with the sum, if nothing better is known."""

from __future__ import annotations

import random
from collections.abc import Iterator, Sequence
from fractions import Fraction
from math import lcm
from typing import TypeVar

from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.geometry.space import Point, Whole, dot, middle
from minkref.fuzz.space.meeting import cube_inside
from minkref.fuzz.space.membership import Surface, in_triangle
from minkref.fuzz.space.pair import SpacePair, Truth
from minkref.fuzz.space.sides import both_sides

T = TypeVar("T")
FACES = 60
SUMS = 400
IN_BOX = 80
FINENESS = 1 << 20  # a random number between 0 and 1 is a multiple of 1 / FINENESS


def sums_of_points(pair: SpacePair, distance: Fraction) -> Iterator[tuple[Point, Point]]:
    """p and q of the operands, first their vertices, then points inside; the cube around scale p
    of half side `distance` lies in sP."""
    dice = random.Random(f"sums {pair.family} {len(pair.P.vertices)} {len(pair.Q.vertices)}")
    scaled, s = pair.meeting.sP, pair.meeting.scale
    if distance == 0:
        for p in _some(pair.P.vertices, 20, dice):
            for q in _some(pair.Q.vertices, 20, dice):
                yield p, q
    inner: list[Point] = []
    for n, place in _on_faces(pair.meeting.in_sP, FACES, dice):
        _, deep = both_sides(pair.meeting.in_sP, place, n)
        for x in (deep, _mean(deep, dice.choice(scaled.vertices), dice)):
            if pair.meeting.in_sP.contains(x) and cube_inside(pair.meeting.in_sP, x, distance):
                inner.append((x[0] / s[0], x[1] / s[1], x[2] / s[2]))
    outer = list(pair.Q.vertices) + [
        place for _, place in _on_faces(pair.meeting.in_Q, FACES, dice)
    ]
    if inner and outer:
        for _ in range(SUMS):
            yield dice.choice(inner), dice.choice(outer)


def points_near(
    pair: SpacePair, result: Polyhedron, surface: Surface, distance: Fraction
) -> Iterator[Point]:
    """Yields points in the operands' gaps, beside the result's faces, at distances from `distance`
    on, and in the box of both."""
    yield from _in_gaps(pair)
    dice = random.Random(f"points {pair.family} {len(result.vertices)} {len(result.faces)}")
    size = _size(result)
    steps = [size / 4096, size / 64]
    if distance:
        steps = [2 * distance, 16 * distance, *steps]
    for n, place in _on_faces(surface, FACES, dice):
        if distance == 0:
            yield from both_sides(surface, place, n)
        length = max(abs(number) for number in n)
        for step in steps if distance else steps[:1]:
            t = step / length
            for sign in (1, -1):
                yield (
                    place[0] + sign * t * n[0],
                    place[1] + sign * t * n[1],
                    place[2] + sign * t * n[2],
                )
    if pair.truth is Truth.HULL:
        yield from _into_hull(pair.hull)
    low, high = _joint_box(pair, result)
    for _ in range(IN_BOX):
        x, y, z = (
            low[k] + (high[k] - low[k]) * Fraction(dice.randint(0, FINENESS), FINENESS)
            for k in range(3)
        )
        yield (x, y, z)


def _in_gaps(pair: SpacePair) -> Iterator[Point]:
    """Yields places likely inside cavities, tunnels and dents of the sum: halfway between two faces
    of one operand with a free space between, beside the middle of the other."""
    dice = random.Random(f"gaps {pair.family} {len(pair.P.vertices)} {len(pair.Q.vertices)}")
    meeting = pair.meeting
    for surface, other in ((meeting.in_sP, pair.Q), (meeting.in_Q, meeting.sP)):
        low, high = other.box
        for n, place in _on_faces(surface, FACES, dice):
            across = _gap(surface, place, n)
            if across is not None:
                x, y, z = (place[k] + across / 2 * n[k] + (low[k] + high[k]) / 2 for k in range(3))
                yield (x, y, z)


def _gap(surface: Surface, place: Point, n: Whole) -> Fraction | None:
    """The distance from a face to the next face along its outer normal, in lengths of `n`; None
    without a next face."""
    unit = surface.denominator
    start = (place[0] * unit, place[1] * unit, place[2] * unit)
    nearest: Fraction | None = None
    for corners, m in zip(surface.triangles, surface.normals, strict=True):
        along = dot(m, n)
        if along >= 0:  # not seen from outside
            continue
        height = sum((m[k] * (corners[0][k] - start[k]) for k in range(3)), Fraction(0))
        t = height / along
        if t <= 0 or (nearest is not None and t >= nearest):
            continue
        x, y, z = (start[k] + t * n[k] for k in range(3))
        w = lcm(x.denominator, y.denominator, z.denominator)
        if in_triangle((int(x * w), int(y * w), int(z * w)), w, corners, m):
            nearest = t
    return None if nearest is None else nearest / unit


def _into_hull(hull: Polyhedron) -> Iterator[Point]:
    """From each vertex towards the middle."""
    centre = middle(hull.vertices)
    for vertex in hull.vertices:
        for share in (3, 8, 14, 20, 30):
            t = Fraction(1, 1 << share)
            x, y, z = (vertex[k] + t * (centre[k] - vertex[k]) for k in range(3))
            yield (x, y, z)


def _on_faces(surface: Surface, most: int, dice: random.Random) -> Iterator[tuple[Whole, Point]]:
    """The normal of some triangles, each with its middle and with a point near a corner."""
    numbers = range(len(surface.triangles))
    for number in _some(numbers, most, dice):
        corners: list[Point] = []
        for x, y, z in surface.triangles[number]:
            unit = surface.denominator
            corners.append((Fraction(x, unit), Fraction(y, unit), Fraction(z, unit)))
        centre = middle(corners)
        corner = dice.choice(corners)
        yield surface.normals[number], centre
        yield (surface.normals[number], middle([*([corner] * 12), centre, *corners]))


def _some(values: Sequence[T], most: int, dice: random.Random) -> list[T]:
    return list(values) if len(values) <= most else dice.sample(values, most)


def _mean(a: Point, b: Point, dice: random.Random) -> Point:
    t = Fraction(dice.randint(0, FINENESS), FINENESS)
    return (a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2]))


def _size(polyhedron: Polyhedron) -> Fraction:
    if not polyhedron.vertices:
        return Fraction(1)
    low, high = polyhedron.box
    return max(high[k] - low[k] for k in range(3)) or Fraction(1)


def _joint_box(pair: SpacePair, result: Polyhedron) -> tuple[list[Fraction], list[Fraction]]:
    """A box of the sum and the result, a little larger."""
    (p0, p1), (q0, q1) = pair.meeting.sP.box, pair.Q.box
    low, high = [p0[k] + q0[k] for k in range(3)], [p1[k] + q1[k] for k in range(3)]
    if result.vertices:
        r0, r1 = result.box
        low = [min(low[k], r0[k]) for k in range(3)]
        high = [max(high[k], r1[k]) for k in range(3)]
    margin = [(high[k] - low[k]) / 64 for k in range(3)]
    return [low[k] - margin[k] for k in range(3)], [high[k] + margin[k] for k in range(3)]
