"""Operands whose convolution is hard: collinear vertices, antennas, winding numbers, size."""

from __future__ import annotations

import json
from collections.abc import Iterator
from fractions import Fraction
from random import Random

from minkref import _core
from minkref.certify.case_text import ring_numbers
from minkref.certify.coincidence import ends_of
from minkref.certify.predicate import Place
from minkref.degeneracies.draft import Draft, Facts, Family
from minkref.degeneracies.shapes import changed, framed, number, turned_left
from minkref.fuzz.families.drawing import Point, Polygon, Ring, Shape, box, convex, extent, moved
from minkref.fuzz.families.hard_numbers import polygon
from minkref.fuzz.families.outlines import spiral
from minkref.fuzz.families.random_pairs import random_pair


def _cut(dice: Random, ring: Ring) -> tuple[Ring, list[int]]:
    """With a vertex inside some edges; the numbers of these vertices."""
    made: Ring = []
    added = []
    for k, (x, y) in enumerate(ring):
        made.append((x, y))
        if k == 0 or dice.random() < 0.5:
            u, v = ring[(k + 1) % len(ring)]
            share = Fraction(dice.randint(1, 4), 5)
            added.append(len(made))
            made.append((x + (u - x) * share, y + (v - y) * share))
    return made, added


def _collinear(dice: Random, size: int) -> Draft:
    P, first = _cut(dice, turned_left(polygon(dice, dice.randint(3, 6), False)[0]))
    Q, second = _cut(dice, turned_left(polygon(dice, dice.randint(3, 6), False)[0]))
    n, m = len(P), len(Q)
    zeros = (
        *(("orientation", ((i - 1, 0), (i, 0), ((i + 1) % n, 0))) for i in first),
        *(("orientation", ((0, j - 1), (0, j), (0, (j + 1) % m))) for j in second),
    )
    scale = Fraction(dice.randint(1, 6), dice.randint(1, 6))
    return changed(dice, Draft([[P]], [[Q]], scale, zeros))


def _is_collinear(facts: Facts) -> bool:
    return len(facts.zeros) >= 2 and facts.has_zeros


def _full(facts: Facts) -> Iterator[tuple[Place, Place]]:
    """The segments of the full convolution as its cycles pass them."""
    rings = ring_numbers(facts.P), ring_numbers(facts.Q)
    for edge in _core.full_convolution(facts.P, facts.Q):
        a, b = (facts.vertices.at(end, facts.scale) for end in ends_of(edge, rings))
        yield (a, b) if edge[1] > 0 else (b, a)


def _antenna(dice: Random, size: int) -> Draft:
    """Polygons on small grids, where edges of one direction abound."""
    pair = random_pair(dice.randrange(10**9), dice.randrange(240))
    P, Q = (_shape(text) for text in (pair.P, pair.Q))
    return changed(dice, Draft(P, Q, Fraction(1)))


def _shape(text: str) -> Shape:
    return [
        [[(Fraction(x), Fraction(y)) for x, y in ring] for ring in (p["outer"], *p["holes"])]
        for p in json.loads(text)["polygons"]
    ]


def _is_antenna(facts: Facts) -> bool:
    """A segment of the full convolution comes to a point and another leaves it by the same way."""
    segments = list(_full(facts))
    leaving: dict[Place, list[Place]] = {}
    for a, b in segments:
        leaving.setdefault(a, []).append((b[0] - a[0], b[1] - a[1]))
    for a, b in segments:
        back = a[0] - b[0], a[1] - b[1]
        for d in leaving.get(b, []):
            if back[0] * d[1] == back[1] * d[0] and back[0] * d[0] + back[1] * d[1] > 0:
                return True
    return False


def _euler(dice: Random, size: int) -> Draft:
    """A box with a hole, and a polygon around a copy of it."""
    hole = convex(dice, dice.randint(3, 5), 6)
    x, y, width, height = extent(hole)
    margin = dice.randint(1, 3)
    outer = box(x - margin, y - margin, width + 2 * margin, height + 2 * margin)
    P = [outer, framed([hole])[1]]
    w, h = width + 2 * margin, height + 2 * margin
    Q: Ring = [
        (0, 0),
        (2 * w + number(dice, 1, 4), 0),
        (2 * w, 2 * h + 3),
        (0, 2 * h + number(dice, 1, 2)),
    ]
    return changed(dice, Draft([P], [[Q]], Fraction(1)))


def _is_euler(facts: Facts) -> bool:
    """P, which has a hole, fits inside a box in Q; the sum has none."""
    return facts.P.ring_count > 1 and facts.counts[1] == (1, 0)


def _combs(dice: Random, size: int) -> Draft:
    """P: a comb of m level teeth, and far off m squares side by side. Q: n squares, one above the
    other, and far off a comb of n upright teeth. The teeth of each with the squares of the other
    give m n strips that lie level and m n that are upright, in one place."""
    m, n = dice.choice(((2, 2), (2, 3), (3, 2)))
    length, thick, far = 3 * m * n + dice.randint(0, 3), Fraction(1, dice.randint(2, 4)), 100

    def row(count: int, step: int, x0: int) -> list[Polygon]:
        return [[box(x0 + k * step, 0, thick, thick)] for k in range(count)]

    def teeth(count: int, step: int) -> Ring:
        """Upright ones on a back."""
        ring: Ring = [(0, -1), ((count - 1) * step + thick, -1)]
        for k in reversed(range(count)):
            ring += [(k * step + thick, length), (k * step, length)]
            ring += [(k * step, 0), ((k - 1) * step + thick, 0)] if k else []
        return ring

    level: Ring = [(y, x) for x, y in teeth(m, 2)][::-1]
    column = [[[(x, y) for y, x in square][::-1]] for (square,) in row(n, 2 * m, 0)]
    upright = moved([[teeth(n, 2 * m)]], -far, 0)
    return changed(dice, Draft([[level], *row(m, 2, far)], [*column, *upright], Fraction(1)))


def _spirals(dice: Random, size: int) -> Draft:
    pitch = dice.randint(3, 5)
    wall = Fraction(1, dice.randint(2, 4))
    P = spiral(dice.randint(3, 6), pitch, wall)
    Q = spiral(dice.randint(7, 14), 2 * pitch, wall)
    return changed(dice, Draft([[P]], [[Q]], Fraction(1, dice.randint(1, 4))))


def _is_large(facts: Facts) -> bool:
    """More vertices of the sum than of the operands."""
    return facts.at.region.vertices > facts.P.vertices + facts.Q.vertices >= 24


def _is_wound(facts: Facts) -> bool:
    """The boundary of the sum winds as Q does, and Q as many turns."""
    return facts.Q.vertices >= 16 and facts.at.region.vertices >= facts.Q.vertices // 2


def _away(dice: Random, size: int) -> Draft:
    P, Q = polygon(dice, dice.randint(3, 7)), polygon(dice, dice.randint(3, 7))
    scale = Fraction(dice.randint(1, 9), dice.randint(1, 9))
    draft = changed(dice, Draft([P], [Q], scale))
    far = 1000 * dice.randint(1, 9)
    shift: Point = (far, dice.randint(-far, far))
    return Draft(moved(draft.P, *shift), draft.Q, draft.scale)


def _is_away(facts: Facts) -> bool:
    return min(x for x, _ in facts.vertices.P) > 0


FAMILIES = (
    Family(
        "collinear-vertices",
        "vertices in the middle of straight edges, in both operands",
        ("collinear-vertices",),
        _collinear,
        _is_collinear,
    ),
    Family(
        "antennas",
        "a convolution cycle that runs forth and back on one line",
        ("antenna", "parallel-edges"),
        _antenna,
        _is_antenna,
    ),
    Family(
        "euler-zero",
        "a point inside the sum over which the intersection has the Euler characteristic zero",
        ("winding-zero", "vanishing-holes"),
        _euler,
        _is_euler,
    ),
    Family(
        "combs",
        "combs whose sum has far more vertices than they have",
        ("large-sum", "parallel-edges"),
        _combs,
        _is_large,
    ),
    Family(
        "spirals",
        "a spiral along a spiral",
        ("large-sum", "parallel-edges"),
        _spirals,
        _is_wound,
    ),
    Family(
        "origin-outside",
        "a scaled operand that does not contain the origin",
        ("origin-outside",),
        _away,
        _is_away,
    ),
)
