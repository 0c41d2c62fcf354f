"""Polygon sets by the number of their vertices, as WKT: integer coordinates, all valid."""

from __future__ import annotations

import math
import random
from collections.abc import Callable, Sequence

Vertex = tuple[int, int]
Ring = list[Vertex]
OCTAGON = "POLYGON ((3 -7, 7 -3, 7 3, 3 7, -3 7, -7 3, -7 -3, -3 -7, 3 -7))"


def _ring(ring: Ring) -> str:
    return "(" + ", ".join(f"{x} {y}" for x, y in [*ring, ring[0]]) + ")"


def _wkt(polygons: Sequence[Sequence[Ring]]) -> str:
    texts = ["(" + ", ".join(map(_ring, rings)) + ")" for rings in polygons]
    if len(texts) == 1:
        return f"POLYGON {texts[0]}"
    return f"MULTIPOLYGON ({', '.join(texts)})"


def _box(x: int, y: int, width: int, height: int) -> Ring:
    return [(x, y), (x + width, y), (x + width, y + height), (x, y + height)]


def _comb(vertices: int) -> Ring:
    teeth = (vertices - 2) // 4
    ring = [(-20, -100), (20 * teeth, -100)]
    for k in reversed(range(teeth)):
        left, top = 20 * k, 1000 + k % 7
        ring += [(left + 9, 0), (left + 9, top), (left, top), (left, 0)]
    return ring


def comb(vertices: int) -> str:
    return _wkt([[_comb(vertices)]])


def sheared_comb(vertices: int) -> str:
    """Teeth along the diagonal, longer the more there are."""
    height = 10 * vertices
    return _wkt([[[(x + (y if y < 1000 else y + height), y if y < 1000 else y + height)
                   for x, y in _comb(vertices)]]])  # fmt: skip


def star(vertices: int) -> str:
    dice = random.Random(1)
    ring = []
    for k in range(vertices):
        angle = 2 * math.pi * (k + 0.4 * dice.random()) / vertices
        reach = 10**7 * (0.5 + 0.5 * dice.random())
        ring.append((round(reach * math.cos(angle)), round(reach * math.sin(angle))))
    return _wkt([[ring]])


def spiral(vertices: int) -> str:
    outer: Ring = []
    inner: Ring = []
    angle = 4 * math.pi
    for _ in range(vertices // 2):
        reach = 1000 * angle / (2 * math.pi)
        for ring, side in ((outer, 200), (inner, -200)):
            own = reach + side
            ring.append((round(own * math.cos(angle)), round(own * math.sin(angle))))
        angle += 700 / reach
    return _wkt([[outer + inner[::-1]]])


def coast(vertices: int) -> str:
    """A band that never turns back."""
    dice = random.Random(2)
    upper = [(1000 * k + dice.randint(0, 500), dice.randint(0, 5000)) for k in range(vertices // 2)]
    lower = [(x, y - dice.randint(5500, 6000)) for x, y in upper]
    return _wkt([[upper[::-1] + lower]])


def plate(vertices: int) -> str:
    """A square with square holes."""
    side, dice = max(1, round(math.sqrt((vertices - 4) / 4))), random.Random(3)
    holes = [
        _box(1000 * i + dice.randint(50, 300), 1000 * j + dice.randint(50, 300), 400, 500)
        for i in range(side)
        for j in range(side)
    ]
    return _wkt([[_box(0, 0, 1000 * side, 1000 * side), *holes]])


def sieve(vertices: int, holes: int) -> str:
    """A square whose holes are stars, each with room in it for the octagon."""
    side, dice = math.ceil(math.sqrt(holes)), random.Random(5)
    rings = []
    for n in range(holes):
        x, y, corners = 1000 * (n % side) + 500, 1000 * (n // side) + 500, max(8, vertices // holes)
        ring = []
        for k in range(corners):
            reach = 480 * (0.6 + 0.4 * dice.random())
            angle = 2 * math.pi * (k + 0.4 * dice.random()) / corners
            ring.append((x + round(reach * math.cos(angle)), y + round(reach * math.sin(angle))))
        rings.append(ring)
    return _wkt([[_box(0, 0, 1000 * side, 1000 * side), *rings]])


def frames(vertices: int) -> str:
    """Square frames in each other."""
    count = vertices // 8
    return _wkt([
        [_box(-k, -k, 2 * k, 2 * k), _box(3 - k, 3 - k, 2 * k - 6, 2 * k - 6)]
        for k in range(10 * count, 0, -10)
    ])  # fmt: skip


def islands(vertices: int) -> str:
    """Polygons of eight vertices."""
    side = math.ceil(math.sqrt(vertices / 8))
    dice, polygons = random.Random(4), []
    for n in range(vertices // 8):
        x, y = 1000 * (n % side), 1000 * (n // side)
        ring = []
        for k in range(8):
            reach = 480 * (0.4 + 0.6 * dice.random())
            angle = 2 * math.pi * (k + 0.4 * dice.random()) / 8
            ring.append((x + round(reach * math.cos(angle)), y + round(reach * math.sin(angle))))
        polygons.append([ring])
    return _wkt(polygons)


Outline = Callable[[int], str]
