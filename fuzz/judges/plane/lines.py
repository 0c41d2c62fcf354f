"""Judges sums of open lines: part by part, by all routes, with lines, and at single points."""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise

from minkref import _core
from minkref.fuzz.judges.plane.flat_remnants import flat_remnants
from minkref.fuzz.plane.families.catalogue import FAMILIES
from minkref.fuzz.plane.families.dice import Dice

FROM = ("random", "holes", "fit", "comb", "lattice", "touching", "nested", "star")
MOST = 40  # vertices
Corner = tuple[int, int]
Line = list[Corner]
Pieces = list[list[tuple[Fraction, Fraction]]]


def drawn_line(dice: Dice) -> Line:
    """Draw two to six vertices on a lattice; edges may cross, overlap, and go back."""
    line: Line = [(dice.randint(-6, 6), dice.randint(-6, 6))]
    for _ in range(dice.randint(1, 5)):
        x, y = line[-1]
        way = dice.choice(((1, 0), (0, 1), (1, 1), (2, 1), (-1, 2)))
        length = dice.choice((-4, -2, -1, 1, 2, 3, 5))
        line.append((x + length * way[0], y + length * way[1]))
    return line


def set_of_lines(*lines: Line) -> _core.PolygonSet:
    ways = [way for line in lines for way in pairwise(line)]
    rings = ",".join(f'{{"outer":[[{a},{b}],[{c},{d}]]}}' for (a, b), (c, d) in ways)
    return _core.PolygonSet.from_json(f'{{"polygons":[{rings}]}}')


def drawn_region(dice: Dice, seed: int, index: int) -> _core.PolygonSet:
    while True:
        pair = FAMILIES[dice.choice(FROM)].pair(seed, index // 4 + dice.randrange(40))
        Q = _core.PolygonSet.from_json(pair.Q)
        if Q.is_region and Q.vertices <= MOST:
            return Q


def line_faults(seed: int, index: int) -> tuple[int, list[str]]:
    """Compare, count comparisons, list faults."""
    dice = Dice(f"minkref lines {seed} {index}")
    first, second = drawn_line(dice), drawn_line(dice)
    Q = drawn_region(dice, seed, index)
    P = set_of_lines(first)
    parts = [_core.minkowski_sum(set_of_lines(list(w)), Q, "1").region for w in pairwise(first)]
    united = _core.combined("union", parts)[0]
    faults = []
    for route in _core.ROUTES:
        if _core.minkowski_sum(P, Q, "1", route).region != united:
            faults.append(f"{first}: the route {route} does not unite its parts")
    square = str(Fraction(dice.randint(1, 40), dice.choice((1, 3, 4))))
    both = set_of_lines(first, second)
    if _core.offset(both, square) != _core.offset(both, square, 1, "paper"):
        faults.append(f"{first}, {second}: the routes differ with a disc of the square {square}")
    faults += two_lines(first, second)
    return len(_core.ROUTES) + 2, [f"lines:{seed}:{index}: {fault}" for fault in faults]


def two_lines(first: Line, second: Line) -> list[str]:
    """Judge the sum of two lines by parallelograms, and its remnants by flat sums."""
    region, flat = parts_of_sum(first, second)
    P, Q = set_of_lines(first), set_of_lines(second)
    if _core.minkowski_sum(P, Q, "1").region != region:
        return [f"{first} + {second}: the region is another one"]
    rows = _core.sum_remnants(P, Q, "1", region)
    remnants = [[(Fraction(x), Fraction(y)) for x, y in points] for points, _ in rows]
    return [f"{first} + {second}: {fault}" for fault in remnant_faults(remnants, flat, region)]


def parts_of_sum(first: Line, second: Line) -> tuple[_core.PolygonSet, Pieces]:
    """Unite the parallelograms of all pairs of segments, and list the flat sums of parallel ones,
    each by the sums of the ends."""
    found, flat = [], []
    for (ax, ay), (bx, by) in pairwise(first):
        for (cx, cy), (dx, dy) in pairwise(second):
            corners = [
                (ax + cx, ay + cy),
                (bx + cx, by + cy),
                (bx + dx, by + dy),
                (ax + dx, ay + dy),
            ]
            if (bx - ax) * (dy - cy) != (by - ay) * (dx - cx):
                found.append(_core.PolygonSet(corners))
            else:
                flat.append([(Fraction(x), Fraction(y)) for x, y in corners])
    return _core.combined("union", found)[0] if found else _core.PolygonSet(), flat


def remnant_faults(remnants: Pieces, flat: Pieces, region: _core.PolygonSet) -> list[str]:
    """Compare remnants with what flat sums have beside a region: none lost, none invented."""
    rings = [ring for polygon in region.rings() for ring in polygon]
    expected = flat_remnants(flat, rings)
    lost = [piece for piece in expected if piece not in remnants]
    invented = [piece for piece in remnants if piece not in expected]
    faults = [f"the remnant {told(piece)} is lost" for piece in lost]
    faults += [f"the remnant {told(piece)} is invented" for piece in invented]
    if not faults and remnants != expected:
        faults.append("the remnants are in another order, or twice")
    return faults


def told(piece: list[tuple[Fraction, Fraction]]) -> str:
    return " ".join(f"({x}, {y})" for x, y in piece)
