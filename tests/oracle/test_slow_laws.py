"""Laws of the Minkowski sum that hold for all operands, held against the slow engine."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

import pytest
from minkref.oracle.slow import InputError, Operand, minkowski_sum, operand_from_json
from minkref.oracle.slow.canonical import digest
from minkref.oracle.slow.operand import Polygon
from minkref.oracle.slow.place import inside, on_boundary
from random_pairs import pair, star
from thoroughness import draws

SEED = 20121
PAIRS = range(draws(24, 60))
EMPTY = Operand([], [])
Map = Callable[[Fraction, Fraction], tuple[Fraction, Fraction]]


def mapped(operand: Operand, change: Map) -> Operand:
    def ring(of: list[tuple[Fraction, Fraction]]) -> list[tuple[Fraction, Fraction]]:
        return [change(x, y) for x, y in of]

    parts = [Polygon(ring(p.outer), [ring(h) for h in p.holes]) for p in operand.polygons]
    return Operand(parts, ring(operand.ends))


def operands(index: int) -> tuple[Operand, Operand]:
    P, Q = pair(SEED, index)
    return P.operand(), Q.operand()


def as_set(operand: Operand) -> str:
    """The digest of a set, got as its sum with the origin."""
    return minkowski_sum(operand, Operand([], [(Fraction(0), Fraction(0))])).digest


def scale_of(index: int) -> Fraction:
    return Fraction(1 + index % 7, 1 + index % 4)


def moved_tight(
    tight: list[list[tuple[Fraction, Fraction]]], change: Map
) -> list[list[tuple[Fraction, Fraction]]]:
    """For changes that keep the lexicographic order."""
    return [[change(x, y) for x, y in piece] for piece in tight]


@pytest.mark.parametrize("index", PAIRS)
def test_sum_is_translation_covariant(index: int) -> None:
    P, Q = operands(index)
    s, u, v = scale_of(index), Fraction(3, 7), Fraction(-11, 5)
    moved = minkowski_sum(mapped(P, lambda x, y: (x + u, y + v)), Q, s)
    plain = minkowski_sum(P, Q, s)
    back = mapped(Operand(moved.polygons, []), lambda x, y: (x - s * u, y - s * v))
    assert digest(back.polygons) == plain.digest, (SEED, index)
    assert moved.tight == moved_tight(plain.tight, lambda x, y: (x + s * u, y + s * v))


@pytest.mark.parametrize("index", PAIRS)
def test_sum_is_commutative(index: int) -> None:
    P, Q = operands(index)
    one, other = minkowski_sum(P, Q), minkowski_sum(Q, P)
    assert one == other, (SEED, index)


@pytest.mark.parametrize("index", PAIRS)
def test_scaling_both_operands_scales_the_sum(index: int) -> None:
    P, Q = operands(index)
    s, t = scale_of(index), Fraction(5, 3)

    def grown(x: Fraction, y: Fraction) -> tuple[Fraction, Fraction]:
        return x * t, y * t

    plain = minkowski_sum(P, Q, s)
    large = minkowski_sum(P, mapped(Q, grown), s * t)
    assert large.polygons == mapped(Operand(plain.polygons, []), grown).polygons, (SEED, index)
    assert large.area == plain.area * t * t
    assert large.tight == moved_tight(plain.tight, grown)


@pytest.mark.parametrize("index", PAIRS)
def test_quarter_turn_turns_the_sum(index: int) -> None:
    P, Q = operands(index)
    s = scale_of(index)

    def turned(x: Fraction, y: Fraction) -> tuple[Fraction, Fraction]:
        return -y, x

    plain = minkowski_sum(P, Q, s)
    result = minkowski_sum(mapped(P, turned), mapped(Q, turned), s)
    assert as_set(mapped(Operand(plain.polygons, []), turned)) == result.digest, (SEED, index)
    assert (result.components, result.holes) == (plain.components, plain.holes)
    assert len(result.tight) == len(plain.tight)


@pytest.mark.parametrize("index", PAIRS)
def test_straight_vertices_change_nothing(index: int) -> None:
    P, Q = operands(index)

    def refined(ring: list[tuple[Fraction, Fraction]]) -> list[tuple[Fraction, Fraction]]:
        found = []
        for (x0, y0), (x1, y1) in zip(ring, ring[1:] + ring[:1], strict=True):
            found += [(x0, y0), (x0 + (x1 - x0) / 3, y0 + (y1 - y0) / 3)]
        return found

    parts = [Polygon(refined(p.outer), [refined(h) for h in p.holes]) for p in P.polygons]
    assert minkowski_sum(Operand(parts, P.ends), Q) == minkowski_sum(P, Q), (SEED, index)


@pytest.mark.parametrize("index", PAIRS)
def test_sum_with_the_origin_is_the_set_and_sum_with_nothing_is_nothing(index: int) -> None:
    P, _ = operands(index)
    if not P.ends:
        zero = minkowski_sum(P, Operand([], [(Fraction(0), Fraction(0))]))
        again = minkowski_sum(Operand(zero.polygons, []), Operand([], [(Fraction(0),) * 2]))
        assert again.polygons == zero.polygons
        assert zero.tight == [], (SEED, index)
    assert minkowski_sum(P, EMPTY).polygons == minkowski_sum(EMPTY, P).polygons == []
    assert minkowski_sum(EMPTY, EMPTY).digest == digest([])


@pytest.mark.parametrize("index", PAIRS)
def test_sum_is_monotone(index: int) -> None:
    """A part of P, or P beside P with its holes filled, gives a part of the sum."""
    whole, Q = operands(index)
    part = Operand(whole.polygons[:1], whole.ends)
    if len(whole.polygons) == 1:
        whole = Operand([Polygon(whole.polygons[0].outer, [])], [])
    small, large = minkowski_sum(part, Q), minkowski_sum(whole, Q)
    rings = Operand(large.polygons, []).rings()
    assert small.area <= large.area
    for point in Operand(small.polygons, []).points():
        assert on_boundary(rings, point) or inside(rings, point), (SEED, index, point)


def hull(points: list[tuple[Fraction, Fraction]]) -> list[tuple[Fraction, Fraction]]:
    chain: list[tuple[Fraction, Fraction]] = []
    ordered = sorted(set(points))
    for way in (ordered, ordered[::-1]):
        half: list[tuple[Fraction, Fraction]] = []
        for p in way:
            while len(half) > 1 and (half[-1][0] - half[-2][0]) * (p[1] - half[-2][1]) <= (
                half[-1][1] - half[-2][1]
            ) * (p[0] - half[-2][0]):
                half.pop()
            half.append(p)
        chain += half[:-1]
    return chain


@pytest.mark.parametrize("index", PAIRS)
def test_hull_of_the_sum_is_the_sum_of_the_hulls(index: int) -> None:
    P, Q = operands(index)
    if P.is_empty or Q.is_empty or (P.ends and Q.ends):
        return

    def hull_of(operand: Operand) -> Operand:
        ring = hull(operand.points())
        return Operand([Polygon(ring, [])], []) if len(ring) > 2 else Operand([], ring)

    whole = hull(Operand(minkowski_sum(P, Q).polygons, []).points())
    assert digest([Polygon(whole, [])]) == minkowski_sum(hull_of(P), hull_of(Q)).digest


@pytest.mark.parametrize("index", range(20))
def test_convex_multiples_of_one_set_add(index: int) -> None:
    import random

    ring = hull(star(random.Random(SEED + index), 7, 5).operand().points())
    Q = Operand([Polygon(ring, [])], [])
    s, t = Fraction(2, 3), Fraction(5, 4)
    scaled = mapped(Q, lambda x, y: (t * x, t * y))
    whole = mapped(Q, lambda x, y: ((s + t) * x, (s + t) * y))
    assert minkowski_sum(Q, scaled, s).digest == as_set(whole), (SEED, index)


def test_two_flat_operands_and_scales_that_are_not_positive_are_refused() -> None:
    point = operand_from_json({"polygons": [{"outer": [["0", "0"]]}]})
    square = operand_from_json({"polygons": [{"outer": [[0, 0], [1, 0], [1, 1], [0, 1]]}]})
    with pytest.raises(InputError, match="only one"):
        minkowski_sum(point, point)
    with pytest.raises(InputError, match="positive"):
        minkowski_sum(square, square, Fraction(0))
