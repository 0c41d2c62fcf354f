"""Parts for paths and traps, and changes that keep events at a scale."""

from __future__ import annotations

from fractions import Fraction
from random import Random

from minkref.degeneracies.motion.draft import PathDraft, Spot
from minkref.degeneracies.plane.shapes import FACTORS, MAPS
from minkref.fuzz.geometry.plane import Point, Ring, mapped

SCALES = tuple(Fraction(n, d) for n, d in ((1, 1), (2, 1), (1, 2), (3, 2), (1, 3), (7, 5), (4, 9)))


def some_part(dice: Random) -> Ring:
    """A triangle, a box, an L or an arrow head; its box begins at (0, 0)."""
    x, y = dice.randint(2, 6), dice.randint(2, 6)
    u, v = dice.randint(1, x - 1), dice.randint(1, y - 1)
    rings: list[Ring] = [
        [(0, v), (x, 0), (u, y)],
        [(0, 0), (x, 0), (x, y), (0, y)],
        [(0, 0), (x, 0), (x, v), (u, v), (u, y), (0, y)],
        [(u, 0), (x, y), (u, v), (0, y)],
    ]
    return dice.choice(rings)


def heights(ring: Ring) -> Spot:
    """The least and the greatest y."""
    ys = [y for _, y in ring]
    return Fraction(min(ys)), Fraction(max(ys))


def placed(dice: Random, draft: PathDraft, far: int = 9) -> PathDraft:
    """Applies one linear map to everything; moves the obstacles and the path; enlarges the part,
    and reduces the scale by the same factor."""
    a, b, c, d = dice.choice(MAPS)
    factor = dice.choice(FACTORS)
    dx, dy = (dice.randint(-far, far) for _ in range(2))

    def turned(p: Point) -> Spot:
        return Fraction(a * p[0] + b * p[1]), Fraction(c * p[0] + d * p[1])

    def change(p: Point) -> Spot:
        x, y = turned(p)
        return x + dx, y + dy

    part = mapped(draft.part, lambda p: (factor * turned(p)[0], factor * turned(p)[1]))
    path = tuple(change(place) for place in draft.path)
    return PathDraft(part, mapped(draft.obstacles, change), path, draft.scale / factor)
