"""Walls and tips about one place, all as far from it: the radii at which many curves meet."""

from __future__ import annotations

from fractions import Fraction
from random import Random

from minkref.degeneracies.disc.draft import DiscDraft, DiscFacts, DiscFamily, Spot
from minkref.degeneracies.disc.placing import frame_at, placed, unit, ways_around
from minkref.degeneracies.plane.shapes import number
from minkref.fuzz.geometry.plane import Ring

FEWEST, MOST = 4, 12
ORIGIN = (Fraction(0), Fraction(0))
RADII = tuple(Fraction(n, d) for n, d in ((1, 1), (2, 1), (5, 2), (3, 1), (13, 3), (25, 1)))


def _many(size: int) -> int:
    return min(max(size // 2, FEWEST), MOST)


def tip(dice: Random, way: Spot, radius: Fraction, slim: Fraction) -> Ring:
    """A triangle that points to the origin."""
    end = radius + number(dice, 1, 4)
    half = slim * end / 2
    return frame_at(way, [(radius, 0), (end, -half), (end, half)])


def wall(dice: Random, way: Spot, radius: Fraction, slim: Fraction) -> Ring:
    """A triangle or a trapezium that turns an edge to the origin; its middle is not the foot."""
    half = slim * radius / 2
    low, high = -half * dice.randint(1, 3) / 3, half * dice.randint(1, 3) / 3
    end = radius + number(dice, 1, 4)
    far = [(end, high / 2)] if dice.random() < 0.5 else [(end, high), (end, low / 2)]
    return frame_at(way, [(radius, low), (radius, high), *far])


def _slim(count: int) -> Fraction:
    """How wide a part may be, seen from the origin."""
    return Fraction(2, count)


def _all_tips(dice: Random, size: int) -> DiscDraft:
    radius, count = dice.choice(RADII), _many(size)
    part = 1.0 if dice.random() < 0.7 else 0.45
    slim = _slim(count) * Fraction(part).limit_denominator(100)
    P = [[tip(dice, way, radius, slim)] for way in ways_around(dice, count, part)]
    return placed(dice, DiscDraft(P, radius**2, (ORIGIN,)))


def _all_walls(dice: Random, size: int) -> DiscDraft:
    radius, count = dice.choice(RADII), _many(size)
    part = 1.0 if dice.random() < 0.7 else 0.45
    slim = _slim(count) * Fraction(part).limit_denominator(100)
    P = [[wall(dice, way, radius, slim)] for way in ways_around(dice, count, part)]
    return placed(dice, DiscDraft(P, radius**2, (ORIGIN,)))


def _mixed(dice: Random, size: int) -> DiscDraft:
    radius, count = dice.choice(RADII), _many(size)
    parts = [tip, wall] * MOST
    ways = ways_around(dice, count)
    P = [
        [part(dice, way, radius, _slim(count))]
        for part, way in zip(parts[:count], ways, strict=True)
    ]
    return placed(dice, DiscDraft(P, radius**2, (ORIGIN,)))


def _half_wall(dice: Random, way: Spot, radius: Fraction, slim: Fraction) -> Ring:
    """A triangle with an edge ending right in front of the origin."""
    side = dice.choice((-1, 1)) * slim * radius / 2
    return frame_at(way, [(radius, 0), (radius, side), (radius + number(dice, 1, 3), side / 2)])


def _joint_at_corner(dice: Random, size: int) -> DiscDraft:
    """Edge ends before one place, beside other features."""
    radius, count = dice.choice(RADII), min(max(size // 3, 3), 8)
    slim = _slim(count)
    ways = ways_around(dice, count)
    joints = dice.randint(1, max(1, count // 3))
    P = [[_half_wall(dice, way, radius, slim)] for way in ways[:joints]]
    P += [[dice.choice((tip, wall))(dice, way, radius, slim)] for way in ways[joints:]]
    return placed(dice, DiscDraft(P, radius**2, (ORIGIN,)))


def _joint_at_saddle(dice: Random, size: int) -> DiscDraft:
    """An edge's end right across from a tip, or from the end of another edge that runs the other
    way; further parts lie farther away."""
    radius = dice.choice(RADII)
    way = unit(dice.random() * 6)
    across = (-way[0], -way[1])
    slim = Fraction(1, dice.randint(1, 3))
    P = [[_half_wall(dice, way, radius, slim)]]
    P.append([tip(dice, across, radius, slim)])
    aside = [(-way[1], way[0]), (way[1], -way[0])]
    for other in aside[: dice.randint(0, 2)]:
        P.append([tip(dice, other, radius * dice.randint(3, 5) / 2, slim)])
    return placed(dice, DiscDraft(P, radius**2, (ORIGIN,)))


def _meets(facts: DiscFacts, kinds: tuple[str, ...]) -> bool:
    """Whether the reference has an event among these kinds at the radius."""
    return facts.is_at_places and any(row["kind"] in kinds for row in facts.events)


def _has_many(facts: DiscFacts) -> bool:
    return len(facts.near[0].points) >= FEWEST and _meets(facts, ("corner", "maximum", "ridge"))


def _has_tips(facts: DiscFacts) -> bool:
    corners = {(Fraction(x), Fraction(y)) for r in facts.shape for x, y in r[0]}
    return _has_many(facts) and set(facts.near[0].points) <= corners


def _has_walls(facts: DiscFacts) -> bool:
    corners = {(Fraction(x), Fraction(y)) for r in facts.shape for x, y in r[0]}
    return _has_many(facts) and not set(facts.near[0].points) & corners


def _has_joint(facts: DiscFacts) -> bool:
    near = facts.near[0]
    kinds = ("corner", "maximum", "ridge")
    return bool(near.joints) and len(near.points) > 2 and _meets(facts, kinds)


def _has_joint_at_saddle(facts: DiscFacts) -> bool:
    near = facts.near[0]
    is_across = len(near.points) == 2 and near.opposite(facts.places[0])
    return bool(near.joints) and is_across and _meets(facts, ("saddle", "ridge"))


FAMILIES = (
    DiscFamily("disc-tips", "many vertices as far from one place", _all_tips, _has_tips),
    DiscFamily("disc-walls", "many edges as far from one place", _all_walls, _has_walls),
    DiscFamily(
        "disc-tips-and-walls", "many vertices and edges as far from one place", _mixed, _has_many
    ),
    DiscFamily(
        "disc-joint-at-corner",
        "an end of an edge right in front of a place that is as far from other parts",
        _joint_at_corner,
        _has_joint,
    ),
    DiscFamily(
        "disc-joint-at-saddle",
        "two discs touch where an offset edge passes into an arc",
        _joint_at_saddle,
        _has_joint_at_saddle,
    ),
)
