"""Closed meshes by the number of their triangles, as OFF: integer coordinates, all valid."""

from __future__ import annotations

import math
import random
from collections.abc import Sequence

Corner = tuple[int, int, int]
CUBE = """OFF
8 6 0
0 0 0
100 0 0
100 100 0
0 100 0
0 0 100
100 0 100
100 100 100
0 100 100
4 3 2 1 0
4 4 5 6 7
4 0 1 5 4
4 1 2 6 5
4 2 3 7 6
4 3 0 4 7
"""


def _off(corners: Sequence[Corner], faces: Sequence[Sequence[int]]) -> str:
    lines = ["OFF", f"{len(corners)} {len(faces)} 0"]
    lines += [" ".join(map(str, corner)) for corner in corners]
    lines += [f"{len(face)} " + " ".join(map(str, face)) for face in faces]
    return "\n".join(lines) + "\n"


def torus(triangles: int) -> str:
    count = max(3, round(math.sqrt(triangles / 2)))
    corners = []
    for i in range(count):
        for j in range(count):
            u, v = 2 * math.pi * i / count, 2 * math.pi * j / count
            reach = 10**7 + 4 * 10**6 * math.cos(v)
            x, y, z = reach * math.cos(u), reach * math.sin(u), 4 * 10**6 * math.sin(v)
            corners.append((round(x), round(y), round(z)))
    faces = []
    for i in range(count):
        for j in range(count):
            a, b = i * count + j, (i + 1) % count * count + j
            following = (j + 1) % count - j
            c, d = b + following, a + following
            faces += [(a, b, c), (a, c, d)]
    return _off(corners, faces)


def terrain(triangles: int) -> str:
    """A height field over a flat floor."""
    side, dice = max(2, round(math.sqrt(triangles / 2))), random.Random(2)
    corners = [
        (1000 * i, 1000 * j, 2000 + dice.randint(0, 900))
        for i in range(side + 1)
        for j in range(side + 1)
    ]
    faces = []
    for i in range(side):
        for j in range(side):
            a = i * (side + 1) + j
            faces += [(a, a + side + 1, a + side + 2), (a, a + side + 2, a + 1)]
    rim = [(i, 0) for i in range(side)] + [(side, j) for j in range(side)]
    rim += [(i, side) for i in range(side, 0, -1)] + [(0, j) for j in range(side, 0, -1)]
    first = len(corners)
    corners += [(1000 * i, 1000 * j, 0) for i, j in rim]
    for k, (i, j) in enumerate(rim):
        after = (k + 1) % len(rim)
        above, beside = i * (side + 1) + j, rim[after][0] * (side + 1) + rim[after][1]
        faces += [(first + k, first + after, beside), (first + k, beside, above)]
    return _off(corners, [*faces, tuple(range(first, len(corners)))[::-1]])


def double_cone(triangles: int) -> str:
    """Over a star, with a fan above and one below."""
    dice, count = random.Random(1), triangles // 2
    corners = []
    for k in range(count):
        angle = 2 * math.pi * (k + 0.4 * dice.random()) / count
        reach = 10**7 * (0.5 + 0.5 * dice.random())
        corners.append((round(reach * math.cos(angle)), round(reach * math.sin(angle)), 0))
    corners += [(0, 0, 10**7), (0, 0, -(10**7))]
    faces = []
    for k in range(count):
        after = (k + 1) % count
        faces += [(k, after, count), (after, k, count + 1)]
    return _off(corners, faces)


def comb_prism(triangles: int) -> str:
    """A comb with a thickness: its two caps have one face each."""
    teeth = max(1, (triangles // 2 - 2) // 4)
    ring = [(-20, -100), (20 * teeth, -100)]
    for k in reversed(range(teeth)):
        ring += [(20 * k + 9, 0), (20 * k + 9, 1000), (20 * k, 1000), (20 * k, 0)]
    count = len(ring)
    corners = [(x, y, z) for z in (0, 50) for x, y in ring]
    faces: list[Sequence[int]] = [tuple(range(count))[::-1], tuple(range(count, 2 * count))]
    for k in range(count):
        after = (k + 1) % count
        faces.append((k, after, count + after, count + k))
    return _off(corners, faces)
