"""Non-convex star-shaped polyhedra."""

from __future__ import annotations

import random
from fractions import Fraction

from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.space.generators.convex import sphere
from minkref.fuzz.space.hull import is_convex


def star(dice: random.Random, count: int, size: int) -> Polyhedron:
    """A triangulated rational sphere with vertices moved to and from the origin. The origin lies
    inside, and sees the whole surface. For `count` of at least three."""
    while True:
        ball = sphere(dice, count, Fraction(1))
        if not _holds_origin(ball):
            continue
        factors = [Fraction(size * dice.randint(2, 8), 8) for _ in ball.vertices]
        vertices = tuple(
            (t * x, t * y, t * z) for t, (x, y, z) in zip(factors, ball.vertices, strict=True)
        )
        moved = Polyhedron(vertices, ball.triangles)
        if not is_convex(moved):
            return moved


def _holds_origin(ball: Polyhedron) -> bool:
    from minkref.fuzz.space.membership import winding_number

    return winding_number(ball, (Fraction(0),) * 3) == 1
