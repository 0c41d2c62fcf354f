"""Open lines to grow, small ones first: degenerate kinds in turn, and lines of any shape."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from itertools import combinations, pairwise
from math import isqrt

from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.cases.grid import rounded, unit_for
from minkref.fuzz.offsets.asked_offset import AskedOffset
from minkref.fuzz.offsets.distance import from_edge
from minkref.fuzz.offsets.lines import Line, segments_of
from minkref.fuzz.plane.families.dice import Dice

FAMILY, GRID = "line-offsets", "-grid"
FAMILIES = {
    FAMILY: "open lines to grow by a disc: tight turns, loops, arms a diameter apart",
    FAMILY + GRID: "the same on a grid of 24 bits",
}
BITS = 24
FACTORS = tuple(map(Fraction, ("1", "1", "1/3", "7/5", "1000/7", "1/1000000", "10000000000/3")))
BESIDE = tuple(Fraction(1, n) for n in (12, 25, 60, 400, 10**4, 10**6, 10**9))
ON_ROOT = 1 << 40
Rough = Sequence[tuple[int, int]]


def spot(dice: Dice, reach: int) -> tuple[int, int]:
    return dice.randint(-reach, reach), dice.randint(-reach, reach)


def any_lines(dice: Dice) -> list[Rough]:
    reach = dice.choice((6, 12, 40))
    most = dice.randint(2, 7)
    return [
        [spot(dice, reach) for _ in range(dice.randint(1 if k else 2, most))]
        for k in range(dice.choice((1, 1, 2)))
    ]


def tight_turn(dice: Dice) -> list[Rough]:
    """Two long arms with a small angle between them."""
    long, open_ = dice.randint(6, 30), dice.randint(0, 3)
    return [[(long, open_), (0, 0), (long + dice.randint(-2, 2), -1)]]


def loop(dice: Dice) -> list[Rough]:
    """A line that comes back to its start, or nearly, or passes by it."""
    x, y = dice.randint(2, 6), dice.randint(2, 6)
    ring = [(0, 0), (x, 0), (x, y), (0, y)]
    return [[*ring, dice.choice(((0, 0), (0, 1), (1, 1), (0, -1), (-1, 0)))]]


def comb(dice: Dice) -> list[Rough]:
    """A zigzag whose arms are as far apart."""
    gap, high = dice.randint(1, 3), dice.randint(3, 9)
    line = []
    for k in range(dice.randint(3, 6)):
        line += [(k * gap, 0), (k * gap, high)][:: 1 if k % 2 else -1]
    return [line]


def cross(dice: Dice) -> list[Rough]:
    """Lines that cross, meet at a point, or share a part."""
    a = dice.randint(2, 6)
    second = dice.choice(
        ([(0, -a), (0, a)], [(0, 0), (0, a)], [(1, 0), (a + 2, 0)], [(a, 0), (a, 1)])
    )
    return [[(-a, 0), (a, 0)], second]


def retraced(dice: Dice) -> list[Rough]:
    """A line that goes back on itself."""
    a = dice.randint(2, 8)
    return [[(0, 0), (a, 0), (dice.randint(0, a - 1), 0), (dice.randint(0, a), a)]]


def walls(dice: Dice) -> list[Rough]:
    """Parallel lines and points beside each other."""
    gap, long = dice.randint(1, 4), dice.randint(2, 9)
    found: list[Rough] = [[(0, k * gap), (long, k * gap)] for k in range(dice.randint(2, 4))]
    return [*found, [(long + gap, 0)]]


def spiral(dice: Dice) -> list[Rough]:
    gap = dice.randint(1, 3)
    line, x, y, step = [(0, 0)], 0, 0, 0
    for k, (dx, dy) in enumerate(((1, 0), (0, 1), (-1, 0), (0, -1)) * 2):
        step += gap * (k % 2 == 0)
        x, y = x + dx * step, y + dy * step
        line.append((x, y))
    return [line[: dice.randint(4, len(line))]]


def nearly_straight(dice: Dice) -> list[Rough]:
    """A long line with a vertex a unit off, and one straight on."""
    long = 1 << dice.randint(4, 12)
    return [[(0, 0), (long, dice.choice((-1, 1))), (2 * long, 0), (3 * long, 0)]]


def points(dice: Dice) -> list[Rough]:
    """Points, some as far apart as others."""
    gap = 2 * dice.randint(1, 3)
    return [[(gap * k, gap * dice.randint(0, 1))] for k in range(dice.randint(1, 4))]


KINDS: dict[str, Callable[[Dice], list[Rough]]] = {
    "any": any_lines,
    "a tight turn": tight_turn,
    "a loop": loop,
    "a comb": comb,
    "lines that meet": cross,
    "a line that goes back": retraced,
    "parallel lines": walls,
    "a spiral": spiral,
    "a nearly straight vertex": nearly_straight,
    "points": points,
}


def drawn_lines(name: CaseName, family: str, seed: int, index: int) -> AskedOffset:
    """The same lines for the same numbers."""
    dice = Dice(f"minkref {family} {seed} {index}")
    kinds = list(KINDS)
    kind = kinds[index % len(kinds)]
    on_grid = family.endswith(GRID)
    factor = Fraction(2) ** dice.choice((0, 0, 7, -40)) if on_grid else dice.choice(FACTORS)
    lines = exact_lines(dice, KINDS[kind](dice), factor)
    radius, position = drawn_width(dice, lines)
    if on_grid:
        radius = rounded(radius, unit_for(radius, BITS))
    where = f"{kind}, {position}"
    return AskedOffset(name, segments_of(lines), radius, family, where, lines)


def exact_lines(dice: Dice, rough: list[Rough], factor: Fraction) -> tuple[Line, ...]:
    """Turned by right angles and scaled, without equal points in a row."""
    turns = dice.randrange(4)
    found = []
    for line in rough:
        points: list[tuple[Fraction, Fraction]] = []
        for x, y in line:
            for _ in range(turns):
                x, y = -y, x
            point = (factor * x, factor * y)
            if not points or points[-1] != point:
                points.append(point)
        found.append(tuple(points))
    return tuple(found)


def drawn_width(dice: Dice, lines: tuple[Line, ...]) -> tuple[Fraction, str]:
    """Draws a radius: half of a distance between features, beside one, or any."""
    places = list(dict.fromkeys(point for line in lines for point in line))
    pairs = [pair for line in lines for pair in pairwise(line)]
    squares = {from_edge(p, pair).square for p in places for pair in pairs if p not in pair}
    squares |= {from_edge(p, (q, q)).square for p, q in combinations(places, 2)}
    halves = sorted(_root(square) / 2 for square in squares if square > 0)
    largest = max((abs(x) for p in places for x in p), default=Fraction(1)) or Fraction(1)
    way = dice.randrange(4) if halves else 3
    if way < 3:
        radius = dice.choice(halves)
        if way == 0:
            return radius, "at a distance"
        return radius * (1 + dice.choice(BESIDE) * dice.choice((-1, 1))), "beside a distance"
    return largest * Fraction(dice.randint(1, 60), dice.choice((40, 100, 1000))), "any radius"


def _root(square: Fraction) -> Fraction:
    """The root if it is rational, else one near it."""
    n, d = isqrt(square.numerator), isqrt(square.denominator)
    if n * n == square.numerator and d * d == square.denominator:
        return Fraction(n, d)
    scale = ON_ROOT * square.denominator
    return Fraction(isqrt(square.numerator * square.denominator * ON_ROOT**2), scale)
