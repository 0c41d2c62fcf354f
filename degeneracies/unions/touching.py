"""Sets that meet by chance, at vertices, along edges, in common points; filled holes; signs wrong
in doubles."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from random import Random

from minkref.degeneracies.plane.shapes import FACTORS, MAPS
from minkref.degeneracies.unions.draft import UnionFacts, UnionFamily
from minkref.fuzz.geometry.plane import Ring, Shape, mapped, moved, scaled
from minkref.fuzz.plane.families.dice import Dice
from minkref.fuzz.unions import degenerate_unions as kinds

Draw = Callable[[Random], list[Shape]]


def _placed(*draws: Callable[[Dice], kinds.Sets]) -> Draw:
    """Draws by one function, and maps all sets linearly."""

    def draw(dice: Random) -> list[Shape]:
        sets = dice.choice(draws)(Dice(str(dice.random())))
        a, b, c, d = dice.choice(MAPS)
        factor, x, y = dice.choice(FACTORS), dice.randint(-9, 9), dice.randint(-9, 9)
        sets = [mapped(one, lambda p: (a * p[0] + b * p[1], c * p[0] + d * p[1])) for one in sets]
        return [moved(scaled(one, factor), x, y) for one in sets]

    return draw


def _through_a_point(dice: Dice) -> kinds.Sets:
    """Triangles, each with an edge through the origin."""
    sets: kinds.Sets = []
    ways = dice.sample([(1, 0), (0, 1), (1, 1), (1, -1), (2, 1), (1, 2), (3, -1)], 4)
    for x, y in ways[: dice.randint(3, 4)]:
        back, on = dice.randint(1, 4), dice.randint(1, 4)
        tip = (-y * dice.randint(1, 3) + x, x * dice.randint(1, 3) + y)
        ring: Ring = [(-back * x, -back * y), (on * x, on * y), tip]
        sets.append([[ring]])
    return sets


def _meets_edge(facts: UnionFacts) -> bool:
    return any(one.vertices and one.edges for one in facts.meetings.values())


def _meets_vertex(facts: UnionFacts) -> bool:
    places = [{k for k, _ in one.vertices} for one in facts.meetings.values()]
    return not facts.overlaps and any(len(sets) > 1 for sets in places)


def _has_common_point(facts: UnionFacts) -> bool:
    return any(
        not one.vertices and len({k for k, _ in one.edges}) > 2 for one in facts.meetings.values()
    )


def _loses_hole(facts: UnionFacts) -> bool:
    return bool(facts.overlaps) and facts.union[2] < facts.holes_of_sets


def _has_seam(facts: UnionFacts) -> bool:
    return any(way < 0 for _, _, way in facts.overlaps)


def _misleads_doubles(facts: UnionFacts) -> bool:
    """Whether doubles miss or reverse a turn; inventing turns does not count."""
    return any(sign for _, _, sign in facts.edges.wrong_in_doubles())


def _far_slivers(dice: Dice) -> kinds.Sets:
    """Distant slivers, told apart by digits that doubles round."""
    sets = dice.choice((kinds.slivers, kinds.nearly_parallel, kinds.nearly_equal))(dice)
    factor = Fraction(1, dice.choice((3, 7, 11)) << dice.randint(20, 40))
    return [moved(scaled(one, factor), dice.randint(1, 9), -dice.randint(1, 9)) for one in sets]


FAMILIES = (
    UnionFamily(
        "union-vertex-on-edge",
        "a vertex inside an edge of another set",
        _placed(kinds.vertex_on_edge, kinds.edge_in_common, kinds.partly_covered),
        _meets_edge,
    ),
    UnionFamily(
        "union-vertices-meet",
        "sets that touch at vertices alone",
        _placed(kinds.touching_vertices, kinds.ring_of_touches),
        _meets_vertex,
    ),
    UnionFamily(
        "union-seams",
        "sets that abut along edges, wholly or partly",
        _placed(kinds.edge_in_common, kinds.many_seams, kinds.many_at_a_vertex),
        _has_seam,
    ),
    UnionFamily(
        "union-common-point",
        "edges of three sets through one point",
        _placed(_through_a_point),
        _has_common_point,
    ),
    UnionFamily(
        "union-hole-filled",
        "a hole that other sets fill, exactly or in part",
        _placed(kinds.in_a_hole),
        _loses_hole,
    ),
    UnionFamily(
        "union-signs",
        "slivers and edges nearly parallel, with turns of which doubles see the wrong sign",
        _placed(_far_slivers),
        _misleads_doubles,
    ),
)
