"""Places as far from two or three features by computer algebra: known ones, the definition in many
digits, and faults planted into minkref's numbers."""

from __future__ import annotations

import json
import random
from collections import Counter
from fractions import Fraction
from typing import Any

import pytest
from minkref import _core
from minkref.fuzz.features.outline import Outline
from minkref.fuzz.judges.disc.equidistant_comparison import (
    KINDS,
    Choice,
    Table,
    compare,
    difference,
    main,
)
from minkref.oracle.symbolic.disc.disc import Offset
from minkref.oracle.symbolic.disc.disc_diagram import SquaredRadius, between, equidistant, in_front
from minkref.oracle.symbolic.rational import Rational
from mpmath import mp, mpf, polyval

SEED = 2012


def point(x: Any, y: Any) -> tuple[Rational, Rational]:
    return Rational(x), Rational(y)


def edge(x: int, y: int, u: int, v: int) -> Offset:
    return Offset(point(x, y), point(u, v))


def polynomials(found: list[SquaredRadius]) -> list[tuple[int, ...]]:
    return [each.polynomial for each in found]


def middle(bounds: tuple[Rational, Rational]) -> Any:
    value = (bounds[0] + bounds[1]) / 2
    return mpf(int(value.numerator)) / int(value.denominator)


FLOOR = edge(9, 0, -9, 0)  # the polygon is below it


def test_known_places_of_each_kind() -> None:
    assert polynomials(between(point(0, 0), point(6, 8))) == [(1, -25)]
    assert polynomials(between(point(3, 5), FLOOR)) == [(4, -25)]
    assert polynomials(between(point(3, -5), FLOOR)) == []  # behind the line
    assert polynomials(equidistant([point(0, 0), point(2, 0), point(0, 2)])) == [(1, -2)]
    assert polynomials(equidistant([point(0, 0), point(1, 0), point(2, 0)])) == []
    # In front of (0, 0) on the floor: x = 0, and the point (3, 1) is equally far at height 5.
    assert polynomials(in_front(point(0, 0), FLOOR, point(3, 1))) == [(1, -25)]
    wall = edge(4, -9, 4, 9)  # the polygon is to its left
    assert polynomials(in_front(point(0, 0), FLOOR, Offset(wall.q, wall.p))) == [(1, -16)]


TWO_CIRCLES = [point(0, 1), point("8/5", "1/5")]  # of radii 1 and 5, which touch the floor


def test_two_points_and_a_line_have_two_places() -> None:
    """The circles about (1, 1) and (3, 5)."""
    found = equidistant([*TWO_CIRCLES, FLOOR])
    places = {each.polynomial: tuple(float(middle(c)) for c in each.place or ()) for each in found}
    assert places == {(1, -1): (1, 1), (1, -25): (3, 5)}


def test_a_point_between_parallel_walls() -> None:
    """Walls at x = 0 and x = 6, and the point (2, 7): x = 3, as far from both."""
    left, right = edge(0, 0, 0, 9), edge(6, 9, 6, 0)
    assert polynomials(equidistant([point(2, 7), left, right])) == [(1, -9)]
    behind = [Offset(wall.q, wall.p) for wall in (left, right)]
    assert polynomials(equidistant([point(2, 7), *behind])) == []


def test_places_are_as_far_in_fifty_digits() -> None:
    """The distances from three random features agree, and the radius is a root of the
    polynomial."""
    print(f"seed {SEED}")
    rng = random.Random(SEED)
    seen: Counter[int] = Counter()
    with mp.workdps(50):
        for _ in range(400):
            features: list[Any] = [point(rng.randint(-9, 9), rng.randint(-9, 9))]
            if rng.random() < 0.5:
                features.append(point(rng.randint(-9, 9), rng.randint(-9, 9)))
            while len(features) < 3:
                features.append(edge(*(rng.randint(-9, 9) for _ in range(4))))
            if features[0] == features[1] or any(
                isinstance(f, Offset) and (f.p == f.q or on_line(features, f)) for f in features
            ):
                continue
            for each in equidistant(features):
                square = middle(each.bounds)
                assert abs(polyval([int(c) for c in each.polynomial], square)) < mpf(10) ** -5
                if each.place is None:
                    continue
                seen[len(each.polynomial) - 1] += 1
                x, y = map(middle, each.place)
                for feature in features:
                    assert abs(squared_distance(feature, x, y) - square) < mpf(10) ** -30 * (
                        1 + square
                    )
    assert seen[2] > 20 and seen[4] > 50, seen


def on_line(features: list[Any], line: Offset) -> bool:
    (x, y), (u, v) = line.p, line.edge
    points = [feature for feature in features if not isinstance(feature, Offset)]
    return any(u * (b - y) == v * (a - x) for a, b in points)


def squared_distance(feature: Any, x: Any, y: Any) -> Any:
    if not isinstance(feature, Offset):
        return (x - int(feature[0])) ** 2 + (y - int(feature[1])) ** 2
    (a, b), (u, v) = (tuple(map(int, vector)) for vector in (feature.p, feature.edge))
    height = (x - a) * v - (y - b) * u
    assert height > 0, "in front of the line"
    return height**2 / mpf(u * u + v * v)


def test_events_of_sets_have_the_radii_of_computer_algebra() -> None:
    table = Table()
    compare(3, 15, table)
    assert table.differences == []
    assert all(table.counts[kind] == 15 and table.degenerate[kind] == 5 for kind in KINDS)


def notch_event() -> tuple[Outline, Choice, Any]:
    """An event of three lines, over the floor of a notch with walls of slopes 2 and 3."""
    ring = [(0, 0), (9, 0), (9, 6), (6, 6), (5, 3), (4, 3), (2, 7), (0, 7)]
    text = [[str(x), str(y)] for x, y in ring]
    P = _core.PolygonSet.from_json(json.dumps({"polygons": [{"outer": text, "holes": []}]}))
    outline = Outline.of(P)
    for row in _core.diagram_events(P).rows(0, 10**9):
        if [name[0] for name in row[5]] == ["edge"] * 3:
            edges = []
            for _, ring_number, index in row[5]:
                corners = outline.rings[int(ring_number)]
                ends = corners[int(index)], corners[(int(index) + 1) % len(corners)]
                edges.append(Offset(point(*ends[0]), point(*ends[1])))
            return outline, Choice("three lines", tuple(edges)), row
    raise AssertionError("no event of three lines")


def test_planted_faults_of_a_number_are_found() -> None:
    outline, choice, row = notch_event()
    kind, square, polynomial, (low, high), place, names = row
    assert square is None and len(polynomial) > 2
    assert difference(choice, row, outline) is None
    changed = [str(Fraction(polynomial[0]) + 1), *polynomial[1:]]
    told = difference(choice, (kind, square, changed, (low, high), place, names), outline)
    assert told is not None and "no multiple" in told
    told = difference(
        choice, (kind, square, polynomial, (low * 2, high * 2), place, names), outline
    )
    assert told is not None and "not in the bounds" in told
    told = difference(choice, (kind, "1", polynomial, (low, high), place, names), outline)
    assert told is not None and "not rational" in told
    told = difference(choice, (kind, square, polynomial, (0.0, 1e9), place, names), outline)
    assert told is not None and "another root" in told


def test_a_wrong_rational_and_a_wrong_place_are_found() -> None:
    outline = Outline([[(0, 0), (1, 0), (0, 1)]])
    choice = Choice("saddle, two points", (point(0, 0), point(6, 8)))
    row = ("saddle", "25", ["-25", "1"], (5.0, 5.0), (3.0, 4.0), [])
    assert difference(choice, row, outline) is None
    told = difference(choice, ("saddle", "24", *row[2:]), outline)
    assert told is not None and "told is 24" in told
    choice = Choice("two points, line", (*TWO_CIRCLES, FLOOR))
    (found,) = [each for each in choice.candidates() if each.polynomial == (1, -25)]
    assert found.place is not None
    place = tuple(float(middle(c)) for c in found.place)
    row = ("corner", "25", ["-25", "1"], (5.0, 5.0), place, [])
    assert difference(choice, row, outline) is None
    told = difference(choice, (*row[:4], (place[0] + 1, place[1]), []), outline)
    assert told == "no place of the features is that of the event"


def test_the_command_compares_cases(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["4", "3"]) == 0
    assert json.loads(capsys.readouterr().out)["differences"] == []
