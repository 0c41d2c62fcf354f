"""Sets in space as closed shells (vertices, faces)."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from math import lcm
from typing import Any

from conversation import number_of
from minkref import _core

Point = tuple[Fraction, ...]
Face = list[int]
Shell = tuple[list[Point], list[Face]]


def shell_of(value: Any) -> Shell:
    points = [tuple(number_of(c) for c in point) for point in value["vertices"]]
    return points, [list(face) for face in value["faces"]]


def minus(a: Point, b: Point) -> Point:
    return tuple(x - y for x, y in zip(a, b, strict=True))


def plus(a: Point, b: Point) -> Point:
    return tuple(x + y for x, y in zip(a, b, strict=True))


def dot(a: Point, b: Point) -> Fraction:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a: Point, b: Point) -> Point:
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def normal_of(corners: list[Point]) -> Point:
    """Twice the area of a planar polygon, as a vector."""
    total: Point = (Fraction(0),) * 3
    for k in range(1, len(corners) - 1):
        total = plus(total, cross(minus(corners[k], corners[0]), minus(corners[k + 1], corners[0])))
    return total


def corners_of(shell: Shell, face: Face) -> list[Point]:
    return [shell[0][k] for k in face]


def is_convex(shell: Shell) -> bool:
    used = {k for face in shell[1] for k in face}
    for face in shell[1]:
        corners = corners_of(shell, face)
        n = normal_of(corners)
        if any(dot(n, minus(shell[0][k], corners[0])) > 0 for k in used):
            return False
    return True


def hull(points: Iterable[Point]) -> Shell | None:
    """Triangles around the convex hull; None for a flat set."""
    given = sorted(set(points))
    factor = lcm(*(c.denominator for p in given for c in p))
    whole = [tuple(int(c * factor) for c in p) for p in given]
    start = independent(whole)
    if start is None:
        return None
    middle = tuple(sum(whole[k][axis] for k in start) for axis in range(3))  # times 4
    faces: list[tuple[Face, Any, int]] = []

    def add(a: int, b: int, c: int) -> None:
        n = cross(minus(whole[b], whole[a]), minus(whole[c], whole[a]))
        level = dot(n, whole[a])
        if dot(n, middle) > 4 * level:
            a, b, n, level = b, a, tuple(-x for x in n), -level
        faces.append(([a, b, c], n, level))

    for k in range(4):
        add(*(start[j] for j in range(4) if j != k))
    for k, point in enumerate(whole):
        seen = [face for face in faces if dot(face[1], point) > face[2]]
        if not seen:
            continue
        sides = {(f[i], f[i - 2]) for f, _, _ in seen for i in range(3)}
        faces[:] = [face for face in faces if dot(face[1], point) <= face[2]]
        for a, b in sides:
            if (b, a) not in sides:
                add(a, b, k)
    return given, [face for face, _, _ in faces]


def independent(points: list[Any]) -> list[int] | None:
    """Indices of four points that span space; None if all points share a plane."""
    if len(points) < 4:
        return None
    edge = minus(points[1], points[0])
    for k in range(2, len(points)):
        n = cross(edge, minus(points[k], points[0]))
        if any(n):
            for j in range(2, len(points)):
                if dot(n, minus(points[j], points[0])):
                    return [0, 1, k, j]
            return None
    return None


def moved(shell: Shell, by: Point) -> Shell:
    return [plus(point, by) for point in shell[0]], shell[1]


def parts_of(shell: Shell) -> list[list[int]]:
    """The vertices of each connected surface piece."""
    group = list(range(len(shell[0])))

    def root(k: int) -> int:
        while group[k] != k:
            k = group[k]
        return k

    for face in shell[1]:
        for k in face:
            group[root(k)] = root(face[0])
    found: dict[int, list[int]] = {}
    for k in sorted({k for face in shell[1] for k in face}):
        found.setdefault(root(k), []).append(k)
    return list(found.values())


def body_of(shell: Shell) -> _core.ConvexPolyhedron:
    """The body for the reference, which refuses vertices without a face."""
    used = sorted({k for face in shell[1] for k in face})
    new = {old: k for k, old in enumerate(used)}
    points = [tuple(str(c) for c in shell[0][k]) for k in used]
    faces = [[new[k] for k in face] for face in shell[1]]
    return _core.ConvexPolyhedron(_core.Polyhedron(points, faces))
