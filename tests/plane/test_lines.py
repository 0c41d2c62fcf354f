"""Open lines and points as operands: laws, parallelograms in fractions, and all scales."""

from __future__ import annotations

import random
from fractions import Fraction
from itertools import pairwise
from pathlib import Path

import minkref
import pytest
from minkref import PolygonSet, _core
from minkref.errors import Refusal
from minkref.fuzz.judges.plane.flat_remnants import flat_remnants
from minkref.fuzz.judges.plane.lines import Pieces, line_faults, parts_of_sum, remnant_faults
from thoroughness import draws

SEED = 5309
Point = tuple[Fraction, Fraction]
Line = list[tuple[int, int]]
SHAPES = [
    PolygonSet([(0, 0), (2, 0), (1, 2)]),
    PolygonSet([(0, 0), (4, 0), (4, 1), (1, 1), (1, 3), (0, 3)]),
    PolygonSet([[(0, 0), (4, 0), (4, 4), (0, 4)], [(1, 1), (1, 3), (3, 3), (3, 1)]]),
]


def of_lines(*lines: Line) -> PolygonSet:
    parts = [f"({', '.join(f'{x} {y}' for x, y in line)})" for line in lines]
    return PolygonSet(f"MULTILINESTRING ({', '.join(parts)})")


def drawn_line(dice: random.Random, size: int = 4) -> Line:
    line: Line = [(dice.randint(-4, 4), dice.randint(-4, 4))]
    while len(line) < size:
        point = (dice.randint(-4, 4), dice.randint(-4, 4))
        if point != line[-1]:
            line.append(point)
    return line


def cases(few: int, many: int) -> list[tuple[Line, PolygonSet]]:
    dice = random.Random(SEED)
    return [(drawn_line(dice), dice.choice(SHAPES)) for _ in range(draws(few, many))]


def test_the_sum_unites_the_sums_of_the_segments() -> None:
    """Prints the line."""
    for line, Q in cases(25, 400):
        parts = [minkref.minkowski_sum(of_lines(list(way)), Q).region for way in pairwise(line)]
        united = minkref.unite(parts)
        for route in ("paper", "winding", "definition"):
            assert minkref.minkowski_sum(of_lines(line), Q, route=route).region == united, line
        assert minkref.minkowski_sum(Q, of_lines(line)).region == united, line


def test_order_direction_and_subdivision_change_nothing() -> None:
    for line, Q in cases(15, 200):
        whole = minkref.minkowski_sum(of_lines(line), Q)
        middle = [((a[0] + b[0]) / Fraction(2), (a[1] + b[1]) / Fraction(2))
                  for a, b in pairwise(line)]  # fmt: skip
        finer = [line[0], *(point for two in zip(middle, line[1:], strict=True) for point in two)]
        others = (
            of_lines(line[::-1]),
            of_lines(*[list(way) for way in reversed(list(pairwise(line)))]),
            of_lines(finer),
            of_lines(line, line[1:3]),
        )
        for other in others:
            assert other == of_lines(line) and hash(other) == hash(of_lines(line)), line
            found = minkref.minkowski_sum(other, Q)
            assert (found.region, found.components, found.holes) == (
                whole.region, whole.components, whole.holes,
            ), line  # fmt: skip
            assert points_of(found) == points_of(whole), line


def points_of(found: minkref.Sum) -> list[list[tuple[Fraction, Fraction]]]:
    return [passage["points"] for passage in found.tight_passages]


def test_a_closed_line_is_a_boundary() -> None:
    """A triangle grown by a small square, less the inside."""
    ring = of_lines([(0, 0), (9, 0), (0, 9), (0, 0)])
    square = PolygonSet([(0, 0), (1, 0), (1, 1), (0, 1)])
    grown = minkref.minkowski_sum(PolygonSet([(0, 0), (9, 0), (0, 9)]), square).region
    found = minkref.minkowski_sum(ring, square)
    assert (found.components, found.holes) == (1, 1)
    assert minkref.subtract(grown, [found.region]) == PolygonSet([(1, 1), (8, 1), (1, 8)])


def test_tight_passages_touch_only_and_more_is_missed_nowhere() -> None:
    """A passage's points touch; a path beside a wall of its width leaves a line."""
    corridor = of_lines([(0, 0), (6, 0)], [(0, 2), (6, 2)])
    square = PolygonSet([(0, 0), (2, 0), (2, 2), (0, 2)])
    found = minkref.minkowski_sum(corridor, square)
    assert found.region == PolygonSet([(0, 0), (8, 0), (8, 4), (0, 4)])
    assert points_of(found) == [[(0, 2), (8, 2)]]
    for line, Q in cases(20, 300):
        for passage in minkref.tight_passages(of_lines(line), Q):
            for x, y in passage["points"]:
                assert minkref.decide(of_lines(line), Q, 1, x, y)["contact"] == "touching", line


def test_lines_before_their_judge() -> None:
    """Parts one by one, two lines by parallelograms and flat parts, discs. Prints the case."""
    for number in range(draws(20, 300)):
        compared, faults = line_faults(SEED, number)
        assert compared and not faults, faults


def test_the_judge_refuses_lost_invented_and_changed_remnants() -> None:
    """Each mutant differs from the truth in a single piece. Prints the lines."""
    dice, tried = random.Random(SEED), 0
    for _ in range(draws(40, 400)):
        first, second = drawn_line(dice), drawn_line(dice)
        region, flat = parts_of_sum(first, [*second, second[0]])
        rings = [ring for polygon in region.rings() for ring in polygon]
        truth = flat_remnants(flat, rings)
        assert remnant_faults(truth, flat, region) == []
        for mutant in mutants(truth):
            tried += 1
            assert remnant_faults(mutant, flat, region), (first, second, mutant)
    assert tried > 40


def mutants(truth: Pieces) -> list[Pieces]:
    far, inside = (Fraction(99), Fraction(99)), (Fraction(99, 2), Fraction(99))
    found = [[*truth, [far]], [*truth, [inside, far]]]
    for k, piece in enumerate(truth):
        before, after = truth[:k], truth[k + 1 :]
        (ax, ay), (bx, by) = piece[0], piece[-1]
        middle, beyond = ((ax + bx) / 2, (ay + by) / 2), (2 * bx - ax, 2 * by - ay)
        found += [before + after, [*before, piece, *truth[k:]]]
        if len(piece) > 1:
            found += [[*before, changed, *after] for changed in (
                [*piece[:-1], middle], [*piece[:-1], beyond], [piece[0]], piece[::-1],
                [piece[0], far, *piece[1:]],
            )]  # fmt: skip
    return [mutant for mutant in found if mutant != truth]


def test_points_are_places() -> None:
    places = PolygonSet("MULTIPOINT (0 0, 5 0, 5 0)")
    square = PolygonSet([(0, 0), (2, 0), (2, 2), (0, 2)])
    found = minkref.minkowski_sum(places, square)
    assert (found.components, found.region.area()) == (2, "8")
    others = PolygonSet("MULTIPOINT (1 1, 2 2)")
    assert minkref.minkowski_sum(places, others).region.is_empty
    assert [one["points"] for one in minkref.sum_remnants(places, others, 2)] == [
        [(1, 1)], [(2, 2)], [(11, 1)], [(12, 2)],
    ]  # fmt: skip


def test_all_scales_are_those_from_scratch(tmp_path: Path) -> None:
    """An index, also read again, the dynamic sum, and events by both. Prints the line."""
    for number, (line, Q) in enumerate(cases(5, 60)):
        P = of_lines(line)
        index = minkref.build_index(P, Q, "1/2", 2)
        index.save(str(tmp_path / f"{number}.index"))
        again = minkref.open_index(tmp_path / f"{number}.index")
        moving = _core.DynamicSum(P, Q, "1/2", "2")
        events = [row[:3] for row in index.topology_events()]
        assert events == [row[:3] for row in moving.topology_events()], line
        scales = [Fraction(k, 7) for k in (4, 9, 13)] + [Fraction(row[0]) for row in events[:3]]
        for scale in sorted(scales):
            moving.move_to(str(scale))
            static = minkref.minkowski_sum(P, Q, scale)
            for found in (index.sum(str(scale)), again.sum(str(scale)), moving.sum()):
                assert (found.region, found.components, found.holes) == (
                    static.region, static.components, static.holes,
                ), (line, scale)  # fmt: skip


def test_what_does_not_take_lines_says_so() -> None:
    line, square = of_lines([(0, 0), (1, 0), (1, 1)]), SHAPES[0]
    for ask in (
        lambda: minkref.erode(square, line),
        lambda: minkref.closing(line, square),
        lambda: minkref.unite([line, square]),
        lambda: minkref.valid_scales(line, square, [(0, 0), (1, 1)]),
    ):
        with pytest.raises((minkref.BadInput, Refusal)) as refused:
            ask()
        assert refused.value.code == "open-lines"
    with pytest.raises(minkref.BadInput) as refused:
        minkref.tight_passages(line, line)
    assert refused.value.code == "degenerate-operands"
