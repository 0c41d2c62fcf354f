"""The exact winding number of a closed surface of triangles around a point."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from functools import cached_property
from math import ceil, floor, inf, isfinite, isqrt, lcm

from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.geometry.space import (
    Point,
    Whole,
    denominator_of,
    flattened,
    longest_axis,
    normal,
    whole,
)
from minkref.fuzz.space.boxes import Box, BoxTree, box_of

MOST_COLUMNS = 64  # along one axis
FEW = 64  # up to so many triangles, all planes are tested
NEAR = 64  # segments beside a place are at most the surface's size divided by this


class Surface:
    """A polyhedron's triangles in columns along z, for many questions. A vertical ray upwards
    counts them, moved by an infinitely small vector (e, e^2) along x and y, so that it meets no
    edge. Floats only exclude triangles whose box does not hold the point: rounding keeps the order
    of numbers. Every other comparison uses integers, over a denominator for each triangle."""

    def __init__(self, polyhedron: Polyhedron) -> None:
        self._polyhedron = polyhedron
        self._corners: list[tuple[int, Whole, Whole, Whole]] = []
        self._boxes: list[tuple[float, float, float, float, float]] = []  # x, x, y, y, highest z
        floats = [[_float(number) for number in vertex] for vertex in polyhedron.vertices]
        for triple in polyhedron.triangles:
            points = [polyhedron.vertices[k] for k in triple]
            unit = denominator_of(points)
            a, b, c = (whole(point, unit) for point in points)
            self._corners.append((unit, a, b, c))
            xs, ys, zs = ([floats[k][axis] for k in triple] for axis in range(3))
            self._boxes.append((min(xs), max(xs), min(ys), max(ys), max(zs)))
        self.normals = [normal(a, b, c) for _, a, b, c in self._corners]
        self._low = [min((box[k] for box in self._boxes), default=0.0) for k in (0, 2)]
        self._high = [max((box[k] for box in self._boxes), default=0.0) for k in (1, 3)]
        self._sides = min(MOST_COLUMNS, 1 + isqrt(len(self._boxes) // 4))
        if not all(isfinite(self._high[k] - self._low[k]) for k in (0, 1)):
            self._sides = 1
        self._columns: dict[tuple[int, int], list[int]] = {}
        for number, box in enumerate(self._boxes):
            for i in range(self._column(box[0], 0), self._column(box[1], 0) + 1):
                for j in range(self._column(box[2], 1), self._column(box[3], 1) + 1):
                    self._columns.setdefault((i, j), []).append(number)

    @property
    def denominator(self) -> int:
        """The denominator for the integers in `triangles` and `boxes`."""
        return self._polyhedron.denominator

    @cached_property
    def triangles(self) -> list[tuple[Whole, Whole, Whole]]:
        points = self._polyhedron.wholes
        return [(points[i], points[j], points[k]) for i, j, k in self._polyhedron.triangles]

    @cached_property
    def boxes(self) -> list[Box]:
        return [box_of(triangle) for triangle in self.triangles]

    @cached_property
    def _box(self) -> Box:
        return box_of(point for triangle in self.triangles for point in triangle)

    @cached_property
    def _tree(self) -> BoxTree:
        return BoxTree(self.boxes)

    def near(self, number: int) -> list[int]:
        """Lists other triangles whose boxes meet this triangle's box."""
        return [k for k in self._tree.meeting(self.boxes[number]) if k != number]

    def _column(self, place: float, axis: int) -> int:
        low, high = self._low[axis], self._high[axis]
        if self._sides == 1 or high == low or place <= low:
            return 0
        if place >= high:
            return self._sides
        return int((place - low) / (high - low) * self._sides)

    def winding(self, point: Point) -> int | None:
        """The winding number around the point; None on the surface. Linear in the triangles above
        and below the point."""
        v = lcm(*(number.denominator for number in point))
        x, y, z = whole(point, v)
        fx, fy, fz = (_float(number) for number in point)
        total = 0
        for number in self._columns.get((self._column(fx, 0), self._column(fy, 1)), ()):
            left, right, front, back, top = self._boxes[number]
            if fx < left or fx > right or fy < front or fy > back or fz > top:
                continue
            unit, a, b, c = self._corners[number]
            n = self.normals[number]
            px, py, pz = x * unit, y * unit, z * unit
            side = n[0] * (px - a[0] * v) + n[1] * (py - a[1] * v) + n[2] * (pz - a[2] * v)
            if side == 0 and in_triangle((px, py, pz), v, (a, b, c), n):
                return None
            up = n[2]
            if up == 0 or side == 0 or (side > 0) == (up > 0):
                continue  # vertical, or below the point
            if _passes(px, py, v, a, b, c, up):
                total += 1 if up > 0 else -1
        return total

    def contains(self, point: Point) -> bool:
        """Whether the winding number is positive, or the point lies on the surface."""
        winding = self.winding(point)
        return winding is None or winding > 0

    def clear_step(self, point: Point, direction: Point) -> Fraction | None:
        """A power of two t such that the segments from the point to point + t direction and to
        point - t direction meet no triangle except at the point itself: no plane of triangles whose
        boxes meet the box of both. None if the direction runs along such a plane through the
        point."""
        v = lcm(*(number.denominator for number in point))
        x, y, z = whole(point, v)
        w = lcm(*(number.denominator for number in direction))
        dx, dy, dz = whole(direction, w)
        near, least = self._reached(point, direction)
        for number in near:
            unit, a, _, _ = self._corners[number]
            n = self.normals[number]
            side = (
                n[0] * (a[0] * v - x * unit)
                + n[1] * (a[1] * v - y * unit)
                + n[2] * (a[2] * v - z * unit)
            )
            along = n[0] * dx + n[1] * dy + n[2] * dz
            if along == 0 and side == 0:
                return None
            if side and along:
                # The plane is met at t = side w / (along unit v).
                power = (side * w).bit_length() - (along * unit * v).bit_length() - 2
                least = min(least, power)
        return Fraction(1, 1 << -least)

    def _reached(self, point: Point, direction: Point) -> tuple[Sequence[int], int]:
        """Returns triangles whose boxes meet the box of both segments, and the power of two used
        for these segments, to keep the triangles few."""
        if len(self._corners) <= FEW:
            return range(len(self._corners)), 0
        unit = self.denominator
        x, y, z = (number * unit for number in point)
        a, b, c = (abs(number) * unit for number in direction)
        reach, power = max(a, b, c), 0
        size = max(high - low for low, high in zip(self._box[::2], self._box[1::2], strict=True))
        if reach * NEAR > size:
            power = -(int(reach * NEAR) // max(size, 1)).bit_length()
        for shorter in (power, power - 3, power - 6):
            step = Fraction(1, 1 << -shorter)
            i, j, k = step * a, step * b, step * c
            box = floor(x - i), ceil(x + i), floor(y - j), ceil(y + j), floor(z - k), ceil(z + k)
            near = self._tree.meeting(box)
            if len(near) <= FEW:
                break
        return near, shorter


def winding_number(polyhedron: Polyhedron, point: Point) -> int | None:
    """For a single question; `Surface` is for many."""
    return Surface(polyhedron).winding(point)


def in_triangle(point: Whole, w: int, triangle: tuple[Whole, Whole, Whole], n: Whole) -> bool:
    """The point `point / w`, known to lie in the plane of the triangle with normal `n`, lies in
    the closed triangle."""
    axis = longest_axis(n)
    x, y = flattened(point, axis)
    a, b, c = (flattened(corner, axis) for corner in triangle)
    sign = 1 if n[axis] > 0 else -1
    for (ux, uy), (vx, vy) in ((a, b), (b, c), (c, a)):
        if sign * ((vx - ux) * (y - uy * w) - (vy - uy) * (x - ux * w)) < 0:
            return False
    return True


def _passes(x: int, y: int, w: int, a: Whole, b: Whole, c: Whole, up: int) -> bool:
    """The ray, moved by (e, e^2), passes through the triangle seen from above."""
    for u, v in ((a, b), (b, c), (c, a)):
        dx, dy = v[0] - u[0], v[1] - u[1]
        turn = dx * (y - u[1] * w) - dy * (x - u[0] * w)
        if turn == 0:
            turn = -dy or dx
        if (turn > 0) != (up > 0):
            return False
    return True


def _float(number: Fraction) -> float:
    """The nearest double; beyond their range, infinity."""
    try:
        return float(number)
    except OverflowError:
        return inf if number > 0 else -inf
