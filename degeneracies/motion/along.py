"""Paths with contact at one scale: for an instant, all the way, at a corner of the path, on both
sides; and parts that lie beside their origin."""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise
from random import Random

from minkref.degeneracies.motion.draft import PathDraft, PathFacts, PathFamily, Spot
from minkref.degeneracies.motion.placing import SCALES, heights, placed, some_part
from minkref.degeneracies.plane.shapes import number
from minkref.fuzz.geometry.plane import ORIGIN, Point, Ring, box, moved

NEAR = Fraction(1, 1 << 40)  # beside an instant, as a part of the segment


def _lowest(ring: Ring) -> Point:
    return min(ring, key=lambda p: p[1])


def _resting(dice: Random) -> tuple[Ring, Spot, Fraction]:
    """A part around its origin, the place at which the lowest vertex reaches (0, 0), and the
    scale."""
    ring = some_part(dice)
    (shape,) = moved([[ring]], -1, -Fraction(1, 2))
    s = dice.choice(SCALES)
    x, y = _lowest(shape[0])
    return shape[0], (-s * x, -s * y), s


def _tip(dice: Random) -> Ring:
    return [(-dice.randint(1, 4), -dice.randint(1, 5)), (dice.randint(1, 4), -2), ORIGIN]


def _at_an_instant(dice: Random) -> PathDraft:
    """A level way, on which the lowest vertex passes a tip that points upwards."""
    part, (x, y), s = _resting(dice)
    start, end = x - dice.randint(1, 6), x + dice.randint(1, 6)
    path = [(Fraction(start), y), (Fraction(end), y)]
    if dice.random() < 0.5:
        path.append((path[-1][0] + 1, y + dice.randint(1, 4)))
    return placed(dice, PathDraft([[part]], [[_tip(dice)]], tuple(path), s))


def _along_an_edge(dice: Random) -> PathDraft:
    """A level way, on which the lowest vertex slides on top of a box."""
    part, (x, y), s = _resting(dice)
    back, on = number(dice, 1, 5), number(dice, 1, 5)
    wall = box(-back, -dice.randint(1, 3), back + on, 1)
    wall = [(p[0], p[1] if p[1] < 0 else 0) for p in wall]
    path = ((x - back, y), (x + on, y))
    return placed(dice, PathDraft([[part]], [[wall]], path, s))


def _vertex_touches(dice: Random) -> PathDraft:
    """A way down and up again, that touches a tip or the top of a box at its corner alone."""
    part, (x, y), s = _resting(dice)
    wall = _tip(dice) if dice.random() < 0.5 else box(-2, -2, dice.randint(3, 5), 2)
    path = (
        (x - number(dice, 1, 5), y + number(dice, 1, 5)),
        (x, y),
        (x + number(dice, 1, 5), y + number(dice, 1, 5)),
    )
    return placed(dice, PathDraft([[part]], [[wall]], path, s))


def _isolated_scale(dice: Random) -> PathDraft:
    """A part above or below its origin, and a corridor exactly as high as the part at one scale: a
    larger or smaller part meets one wall or the other."""
    (shape,) = moved([[some_part(dice)]], -1, dice.choice((Fraction(1, 2), 2, -8, -9)))
    low, high = heights(shape[0])
    s = dice.choice(SCALES)
    deep = number(dice, 3, 6) + s * abs(high)
    walls = [[box(-20, s * low - deep, 40, deep)], [box(-20, s * high, 40, deep)]]
    x = Fraction(dice.randint(-2, 2))
    path = [(x, Fraction(0))]
    if dice.random() < 0.7:
        path.append((x + dice.randint(1, 3), Fraction(0)))
    return placed(dice, PathDraft([shape], walls, tuple(path), s))


def _beside_its_origin(dice: Random) -> PathDraft:
    """Walls in a row, through which a part far from its origin passes while growing."""
    (shape,) = moved([[some_part(dice)]], dice.randint(6, 9), -1)
    xs = [x for x, _ in shape[0]]
    ratio = Fraction(max(xs), min(xs))
    walls = []
    at = number(dice, 2, 6)
    s = at / max(xs)
    for _ in range(dice.randint(2, 3)):
        thick = at / dice.randint(4, 8)
        walls.append([box(at, -9, thick, 18)])
        at = (at + thick) * ratio * (1 + Fraction(dice.randint(0, 2), 8))
    path = [ORIGIN, (Fraction(0), number(dice, 1, 4))]
    return placed(dice, PathDraft([shape], walls, tuple(path[: dice.randint(1, 2)]), s))


def _has_instant(facts: PathFacts) -> bool:
    """Contact at a place inside a segment, and at none just before or after it."""
    bound = facts.bound
    if not facts.is_tight or bound is None or not 0 < bound.t < 1:
        return False
    k = bound.segment
    a, b = facts.path[k], facts.path[k + 1]

    def at(t: Fraction) -> Spot:
        return a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])

    before = [*facts.path[: k + 1], at(bound.t * (1 - NEAR))]
    after = [at(bound.t + (1 - bound.t) * NEAR), *facts.path[k + 1 :]]
    return not any(facts.collides_at(part, "forbidden") for part in (before, after))


def _has_contact_all_along(facts: PathFacts) -> bool:
    (a, b), bound = facts.path, facts.bound
    middle = ((a[0] + b[0]) / 2, (a[1] + b[1]) / 2)
    touches = all(facts.collides_at([place], "forbidden") for place in (a, middle, b))
    return facts.is_tight and bound is not None and touches


def _has_contact_at_corner(facts: PathFacts) -> bool:
    a, b, c = facts.path
    beside = [(b[0] + NEAR * (end[0] - b[0]), b[1] + NEAR * (end[1] - b[1])) for end in (a, c)]
    free = not any(
        facts.collides_at(part, "forbidden") for part in ([a, beside[0]], [beside[1], c])
    )
    return facts.is_tight and facts.bound is not None and facts.bound.at == b and free


def _has_isolated_scale(facts: PathFacts) -> bool:
    return any(one.low == one.high == facts.scale for one in facts.valid("allowed").ranges)


def _has_gaps(facts: PathFacts) -> bool:
    found = facts.valid("allowed")
    apart = all(one.high != other.low for one, other in pairwise(found.ranges))
    return not found.star_shaped and len(found.ranges) >= 3 and apart and facts.is_tight


FAMILIES = (
    PathFamily(
        "path-isolated-scale", "one scale at which a part passes, between others at which it "
        "does not", _isolated_scale, _has_isolated_scale,
    ),
    PathFamily(
        "path-touches-for-an-instant", "a part that passes a tip with contact at one place",
        _at_an_instant, _has_instant,
    ),
    PathFamily(
        "path-along-an-edge", "a part that slides along an edge all the way", _along_an_edge,
        _has_contact_all_along,
    ),
    PathFamily(
        "path-corner-touches", "a path with contact at its corner alone", _vertex_touches,
        _has_contact_at_corner,
    ),
    PathFamily(
        "path-beside-its-origin", "a part that is not star-shaped about its origin: several "
        "ranges of scales", _beside_its_origin, _has_gaps,
    ),
)  # fmt: skip
