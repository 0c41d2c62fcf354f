"""Pairs of polyhedra: turned in doubles, in thirds, far from the origin."""

from __future__ import annotations

import math
import random
from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction

from minkref.reports.evidence.as_written.shapes import PLACED

Corner = tuple[Fraction, Fraction, Fraction]
Solid = tuple[list[Corner], list[list[int]]]
KINDS = ("turned", "straight", "thirds")


@dataclass(frozen=True)
class Solids:
    kind: str
    P: str  # texts of OFF files
    Q: str
    scale: str


def kinds() -> set[str]:
    """All kinds that a seed may draw."""
    return {f"{kind}, {where}" for kind in KINDS for where in PLACED}


def solids(seed: int, index: int) -> Solids:
    draw = random.Random(f"space {seed}:{index}")
    kind, where = draw.choice(KINDS), draw.choice(list(PLACED))
    P, Q = (_one(draw, kind, where, draw.choice(SHAPES)) for _ in range(2))
    scale = ",".join(
        str(Fraction(draw.randint(1, 20), draw.choice([1, 3, 7, 10]))) for _ in range(3)
    )
    return Solids(f"{kind}, {where}", off_text(P), off_text(Q), scale)


def prism(ring: list[tuple[int, int]], caps: list[list[int]], height: int) -> Solid:
    """A straight prism as triangles; `caps` triangulate its ring."""
    n = len(ring)
    corners = [(Fraction(x), Fraction(y), Fraction(z)) for z in (0, height) for x, y in ring]
    faces = [[a, c, b] for a, b, c in caps] + [[a + n, b + n, c + n] for a, b, c in caps]
    for k in range(n):
        m = (k + 1) % n
        faces += [[k, m, m + n], [k, m + n, k + n]]
    return corners, faces


def box(draw: random.Random) -> Solid:
    w, d, h = (draw.randint(1, 4) for _ in range(3))
    return prism([(0, 0), (w, 0), (w, d), (0, d)], [[0, 1, 2], [0, 2, 3]], h)


def angle(draw: random.Random) -> Solid:
    a, b, h = (draw.randint(2, 4) for _ in range(3))
    ring = [(0, 0), (a, 0), (a, 1), (1, 1), (1, b), (0, b)]
    return prism(ring, [[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 5]], h)


def tetrahedron(draw: random.Random) -> Solid:
    while True:
        corners = [tuple(Fraction(draw.randint(-6, 6)) for _ in range(3)) for _ in range(4)]
        u, v, w = ([b - a for a, b in zip(corners[0], one, strict=True)] for one in corners[1:])
        volume = sum(
            u[k] * (v[(k + 1) % 3] * w[(k + 2) % 3] - v[(k + 2) % 3] * w[(k + 1) % 3])
            for k in range(3)
        )
        if volume:
            faces = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]
            return corners, faces if volume > 0 else [one[::-1] for one in faces]  # type: ignore[return-value]


SHAPES: list[Callable[[random.Random], Solid]] = [box, angle, tetrahedron]


def _one(
    draw: random.Random, kind: str, where: str, shape: Callable[[random.Random], Solid]
) -> Solid:
    corners, faces = shape(draw)
    scale, x, y = PLACED[where]
    if kind == "turned":
        angles = draw.uniform(-math.pi, math.pi), draw.uniform(-math.pi, math.pi)
        corners = [_turned(one, angles) for one in corners]
    elif kind == "thirds":
        part = Fraction(1, draw.choice([3, 7, 11]))
        corners = [(a + part * b, b - part * c, c + part * part * a) for a, b, c in corners]
    placed = [(scale * a + x, scale * b + y, scale * c) for a, b, c in corners]
    if kind == "turned":
        placed = [
            (Fraction(float(a)), Fraction(float(b)), Fraction(float(c))) for a, b, c in placed
        ]
    return placed, faces


def _turned(corner: Corner, by: tuple[float, float]) -> Corner:
    """About the third axis, then about the first."""
    x, y, z = map(float, corner)
    c, s = math.cos(by[0]), math.sin(by[0])
    x, y = c * x - s * y, s * x + c * y
    c, s = math.cos(by[1]), math.sin(by[1])
    return Fraction(x), Fraction(c * y - s * z), Fraction(s * y + c * z)


def off_text(solid: Solid) -> str:
    corners, faces = solid
    lines = ["OFF", f"{len(corners)} {len(faces)} 0"]
    lines += [" ".join(map(str, one)) for one in corners]
    lines += [" ".join(map(str, (len(one), *one))) for one in faces]
    return "\n".join(lines) + "\n"
