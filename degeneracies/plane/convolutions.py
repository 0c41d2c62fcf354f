"""Operands with a hard convolution: collinear vertices, antennas, winding numbers, size."""

from __future__ import annotations

from fractions import Fraction
from random import Random

from minkref.degeneracies.plane.draft import Draft, Facts, Family
from minkref.degeneracies.plane.shapes import changed, corridor, framed, number, turned_left
from minkref.fuzz.geometry.plane import Point, Ring, Shape, box, extent, moved, read_shape
from minkref.fuzz.plane.families.drawing import convex
from minkref.fuzz.plane.families.hard_numbers import polygon
from minkref.fuzz.plane.families.random_pairs import random_pair

MOST_TEETH = 12  # both operands' teeth together


def _cut(dice: Random, ring: Ring) -> tuple[Ring, list[int]]:
    """Adds a vertex inside some edges; returns the numbers of the new vertices, too."""
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


def _antenna(dice: Random, size: int) -> Draft:
    """Polygons on small grids, where many edges share a direction."""
    pair = random_pair(dice.randrange(10**9), dice.randrange(240))
    P, Q = (read_shape(text) for text in (pair.P, pair.Q))
    return changed(dice, Draft(P, Q, Fraction(1)))


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
    """The convolution winds zero times around a point of the sum, which has no hole."""
    return facts.wound_zero_times is not None and facts.counts[1] == (1, 0)


def _counts(dice: Random, both: int, least: int) -> tuple[int, int]:
    """Two numbers, each at least `least` and neither much larger than the other, with sum `both` if
    possible, but at most MOST_TEETH: then the sum has thousands of vertices."""
    both = max(2 * least, min(both, MOST_TEETH))
    least = max(least, both // 3)
    m = dice.randint(least, both - least)
    return m, both - m


def _row(count: int, step: int, x0: int, side: Fraction) -> Shape:
    """Squares side by side."""
    return [[box(x0 + k * step, 0, side, side)] for k in range(count)]


def _flipped(shape: Shape) -> Shape:
    """At the diagonal."""
    return [[[(y, x) for x, y in ring][::-1] for ring in polygon] for polygon in shape]


def crossing_combs(m: int, n: int, thick: Fraction, room: int) -> tuple[Shape, Shape]:
    """P: a comb with m level teeth, and far away m squares side by side. Q: n squares, one above
    the other, and far away a comb with n upright teeth. Each comb's teeth, summed with the other
    operand's squares, give m n level strips and m n upright strips, in one place. There the combs'
    backs belong to the first strips, and every two neighbouring level strips close a hole with two
    neighbouring upright strips: (m n - 1)^2 holes."""
    length = 2 * m * n + 1 + room
    far = 3 * length

    def teeth(count: int, step: int) -> Ring:
        """Upright teeth on a back."""
        ring: Ring = [(0, -1), ((count - 1) * step + thick, -1)]
        for k in reversed(range(count)):
            ring += [(k * step + thick, length), (k * step, length)]
            ring += [(k * step, 0), ((k - 1) * step + thick, 0)] if k else []
        return ring

    level, upright = _flipped([[teeth(m, 2)]]), [[teeth(n, 2 * m)]]
    column = _flipped(_row(n, 2 * m, 0, thick))
    return [*level, *_row(m, 2, far, thick)], [*column, *moved(upright, -far, 0)]


def _combs(dice: Random, size: int) -> Draft:
    m, n = _counts(dice, max(size // 8, dice.randint(4, 5)), 2)
    thick = Fraction(1, dice.randint(2, 4))
    return changed(dice, Draft(*crossing_combs(m, n, thick, dice.randint(0, 3)), Fraction(1)))


def crossing_spirals(
    m: int, n: int, steps: tuple[int, int], wall: Fraction, side: Fraction, room: int
) -> tuple[Shape, Shape]:
    """P: a spiral with m long level legs and m - 1 short upright legs, and far away m - 1 squares
    side by side. Q: n - 1 squares, one above the other, and far away a spiral with n upright legs
    and n - 1 level legs. Each spiral, summed with the other operand's squares, gives n - 1 spirals
    one above the other and m - 1 side by side, and every long leg of the first kind crosses every
    long leg of the second kind. By Euler's formula, a connected region of k simple ways with c
    crossings has c - k + 1 holes: m n (m - 1) (n - 1) - m - n + 3."""
    p, q = steps  # steps from leg to leg, in P and in Q
    length = max(p, q) * (m * n + max(m, n)) + room
    far = 3 * length

    def spiral(legs: int, step: int) -> Ring:
        line: list[tuple[int, int]] = []
        x = 0
        for k in range(legs):
            y = step * ((k + 1) // 2) * (1 if k % 2 else -1)
            line.append((x, y))
            x = -step * ((k + 1) // 2) if k % 2 else length + step * (k // 2)
            line.append((x, y))
        return corridor(line, wall)

    level, upright = [[spiral(m, p)]], _flipped([[spiral(n, q)]])
    column = _flipped(_row(n - 1, p * m, 0, side))
    return (
        [*level, *_row(m - 1, q * n, far, side)],
        [*column, *moved(upright, q * n - far, -p * m)],
    )


def _spirals(dice: Random, size: int) -> Draft:
    m, n = _counts(dice, size // 8 + 1, 3)
    steps = dice.randint(3, 5), dice.randint(3, 5)
    wall, side = (Fraction(1, dice.randint(2, 4)) for _ in range(2))
    P, Q = crossing_spirals(m, n, steps, wall, side, dice.randint(0, 3))
    return changed(dice, Draft(P, Q, Fraction(1)))


def _is_large(facts: Facts) -> bool:
    """The sum has more than twice as many vertices as both operands."""
    return facts.at.region.vertices > 2 * (facts.P.vertices + facts.Q.vertices)


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
        _collinear,
        _is_collinear,
    ),
    Family(
        "antennas",
        "a convolution cycle that runs forth and back on one line",
        _antenna,
        lambda facts: facts.convolution.runs_back(),
    ),
    Family(
        "euler-zero",
        "a point inside the sum over which the intersection has the Euler characteristic zero",
        _euler,
        _is_euler,
    ),
    Family("combs", "combs whose sum has far more vertices than they have", _combs, _is_large),
    Family(
        "spirals", "spirals whose sum has far more vertices than they have", _spirals, _is_large
    ),
    Family("origin-outside", "a scaled operand that does not contain the origin", _away, _is_away),
)
