"""Open lines and points grown by a disc: both routes, and distances at single points."""

from __future__ import annotations

import random
from fractions import Fraction
from itertools import pairwise

import minkref
import pytest
from minkref import PolygonSet
from minkref.disc.disc import read_disc
from minkref.disc.polygons import sum_near
from thoroughness import draws

SEED = 5310
Point = tuple[Fraction, Fraction]
Line = list[tuple[int, int]]


def text_of(lines: list[Line], points: Line) -> str:
    parts = [f"LINESTRING ({', '.join(f'{x} {y}' for x, y in line)})" for line in lines]
    parts += [f"POINT ({x} {y})" for x, y in points]
    return f"GEOMETRYCOLLECTION ({', '.join(parts)})"


def drawn(dice: random.Random) -> tuple[list[Line], Line]:
    lines = []
    for _ in range(dice.randint(1, 2)):
        line = [(dice.randint(-5, 5), dice.randint(-5, 5))]
        while len(line) < dice.randint(2, 4):
            point = (dice.randint(-5, 5), dice.randint(-5, 5))
            if point != line[-1]:
                line.append(point)
        if len(line) > 1:
            lines.append(line)
    points = [(dice.randint(-7, 7), dice.randint(-7, 7)) for _ in range(dice.randint(0, 2))]
    return lines, points or [(6, 6)]


def squared_distance(lines: list[Line], points: Line, x: Point) -> Fraction:
    """The squared distance from all lines and points, in fractions."""
    found = [(x[0] - a) ** 2 + (x[1] - b) ** 2 for a, b in points]
    for line in lines:
        for (ax, ay), (bx, by) in pairwise(line):
            dx, dy = bx - ax, by - ay
            part = ((x[0] - ax) * dx + (x[1] - ay) * dy) / (dx * dx + dy * dy)
            part = min(max(part, Fraction(0)), Fraction(1))
            found.append((x[0] - ax - part * dx) ** 2 + (x[1] - ay - part * dy) ** 2)
    return min(found)


def test_both_routes_give_one_form_and_distances_tell_points() -> None:
    """Prints lines, points, radius."""
    dice = random.Random(SEED)
    for _ in range(draws(12, 250)):
        lines, points = drawn(dice)
        P = PolygonSet(text_of(lines, points))
        radius = Fraction(dice.randint(1, 8), dice.choice((1, 2, 3)))
        found = minkref.offset(P, radius)
        other = minkref.offset(P, radius, route="paper")
        assert found == other, (lines, points, radius)
        assert (found.components, found.holes) == (other.components, other.holes)
        disc = read_disc(f"disc:{radius}")
        inner = sum_near(P, disc, Fraction(1, 50), False)
        outer = sum_near(P, disc, Fraction(1, 50), True)
        low, high = (float(Fraction(each.area())) for each in (inner, outer))
        assert low <= found.area[0] and found.area[1] <= high, (lines, points, radius)
        for _ in range(20):
            x = Fraction(dice.randint(-60, 60), 7), Fraction(dice.randint(-60, 60), 7)
            is_near = squared_distance(lines, points, x) <= radius**2
            if x in inner or x not in outer:
                assert (x in inner) == is_near, (lines, points, radius, x)


def test_a_road_has_round_caps() -> None:
    """Two legs at a right angle: 4 r per unit of length, two half discs, and a corner."""
    found = minkref.offset(PolygonSet("LINESTRING (0 0, 10 0, 10 10)"), 1)
    pi = 3.141592653589793
    expected = 40 + pi - 1 + pi / 4
    assert found.area[0] == pytest.approx(expected, abs=1e-12)
    assert (found.components, found.holes, found.curves) == (1, 0, 7)
    straight = minkref.offset(PolygonSet("LINESTRING (0 0, 4 0, 10 0)"), 1)
    assert straight == minkref.offset(PolygonSet("LINESTRING (10 0, 0 0)"), 1)


def test_crossing_lines_and_touching_discs() -> None:
    cross = PolygonSet("MULTILINESTRING ((-5 0, 5 0), (0 -5, 0 5))")
    assert minkref.offset(cross, 1) == minkref.offset(cross, 1, route="paper")
    two = PolygonSet("MULTIPOINT (0 0, 4 0)")
    assert [minkref.offset(two, r).components for r in (1, 2, "201/100")] == [2, 2, 1]
    ring = PolygonSet("MULTIPOINT (0 0, 6 0, 3 4)")
    assert minkref.offset(ring, 3).holes == 1
    square = PolygonSet("LINESTRING (0 0, 4 0, 4 4, 0 4, 0 0)")
    found = minkref.offset(square, 2)
    assert (found.holes, found.tight_passages()[0][0]) == (0, [("2", "2")])


def test_all_radii_of_lines_are_refused() -> None:
    """The diagram of all radii knows boundaries with P on one side."""
    for text in ("LINESTRING (0 0, 5 0, 5 5)", "MULTIPOINT (0 0, 5 0)"):
        with pytest.raises(minkref.BadInput) as refused:
            minkref.DiscIndex(PolygonSet(text))
        assert refused.value.code == "open-lines"
