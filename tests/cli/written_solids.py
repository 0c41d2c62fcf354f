"""Small polyhedra as texts of OFF files."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import Any

Point = tuple[Any, Any]
L = [(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)]
SQUARE = [(0, 0), (1, 0), (1, 1), (0, 1)]


def off(points: Sequence[Sequence[Any]], faces: Sequence[Sequence[int]]) -> str:
    rows = ["OFF", f"{len(points)} {len(faces)} 0"]
    rows += [" ".join(map(str, point)) for point in points]
    rows += [" ".join(map(str, (len(face), *face))) for face in faces]
    return "\n".join(rows) + "\n"


def prism(ring: Sequence[Point], height: Any = 1) -> str:
    """Over a ring that runs counter-clockwise, from z = 0."""
    n = len(ring)
    points = [(x, y, z) for z in (0, height) for x, y in ring]
    walls = [(k, (k + 1) % n, n + (k + 1) % n, n + k) for k in range(n)]
    return off(points, [tuple(reversed(range(n))), tuple(range(n, 2 * n)), *walls])


def cube(side: Any = 1) -> str:
    return prism([(0, 0), (side, 0), (side, side), (0, side)], side)


def hollow_cube() -> str:
    """[0, 3]³ without (1, 2)³."""
    points, faces = [], []
    for first, (low, high) in ((0, (0, 3)), (8, (1, 2))):
        points += [(x, y, z) for x in (low, high) for y in (low, high) for z in (low, high)]
        rings = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
        faces += [[first + v for v in (ring[::-1] if first else ring)] for ring in rings]
    return off(points, faces)


def frame(height: Any = 1) -> str:
    """[0, 4]² without (1, 3)², between two heights."""
    rings = [[(0, 0), (4, 0), (4, 4), (0, 4)], [(1, 1), (3, 1), (3, 3), (1, 3)]]
    points = [(x, y, z) for z in (0, height) for ring in rings for x, y in ring]
    faces = []
    for k in range(4):
        n = (k + 1) % 4
        faces += [(k, n, n + 8, k + 8), (4 + n, 4 + k, 12 + k, 12 + n)]
        faces += [(8 + k, 8 + n, 12 + n, 12 + k), (n, k, 4 + k, 4 + n)]
    return off(points, faces)


def polygon(ring: Sequence[Point], z: Any = 0) -> str:
    return off([(x, y, z) for x, y in ring], [tuple(range(len(ring)))])


def together(*texts: str) -> str:
    """Joins the bodies from several files."""
    points: list[list[str]] = []
    faces: list[list[int]] = []
    for text in texts:
        rows = [row.split() for row in text.splitlines()[1:]]
        first, count = len(points), int(rows[0][0])
        points += rows[1 : count + 1]
        faces += [[first + int(v) for v in row[1:]] for row in rows[count + 1 :]]
    return off(points, faces)


def moved(text: str, by: Any) -> str:
    """By as much along each axis."""
    rows = [row.split() for row in text.splitlines()]
    count = int(rows[1][0])
    points = [[Fraction(c) + by for c in row] for row in rows[2 : count + 2]]
    return off(points, [[int(v) for v in row[1:]] for row in rows[count + 2 :]])


def cubed(side: Any) -> Fraction:
    return Fraction(side) ** 3
