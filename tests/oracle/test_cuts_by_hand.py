"""The judge's cuts: shortest, within the cone that resolves a notch, up to earlier cuts; pieces
tile the set, and are convex if all wedges are cut."""

from __future__ import annotations

from fractions import Fraction

from known_features import Shape, box, holed, slot
from minkref.fuzz.features.feature_draws import drawn_set
from minkref.oracle.features import Judge
from minkref.oracle.features.cuts import cuts, is_convex, pieces
from minkref.oracle.features.outline import Point, cross
from thoroughness import draws

SEED, SETS = 84, draws(20, 200)
L: Shape = [[[(0, 0), (4, 0), (4, 2), (2, 2), (2, 4), (0, 4)]]]


def doubled_area(rings: list[list[Point]]) -> Fraction:
    return sum(
        (cross(p, q) for r in rings for p, q in zip(r, [*r[1:], *r[:1]], strict=True)), Fraction(0)
    )


def vertices(judge: Judge) -> list[Point]:
    """All wedges in the order of cuts."""
    return [
        (Fraction(x), Fraction(y))
        for notch in judge.notches(Fraction(0), Fraction(0))
        for _, x, y, *_ in [judge.wedge_name(notch.wedge)]
    ]


def test_of_two_shortest_cuts_the_least_end_is_taken() -> None:
    assert cuts(L, [(Fraction(2), Fraction(2))]) == [((2, 2), (0, 2))]
    assert sorted(len(piece[0]) for piece in pieces(L, [((2, 2), (0, 2))])) == [4, 5]


def test_cuts_end_at_earlier_cuts_and_resolved_vertices_are_skipped() -> None:
    shape = slot(Fraction(2), Fraction(6))
    told = cuts(shape, [(Fraction(1), Fraction(-6)), (Fraction(-1), Fraction(-6))])
    assert told == [((1, -6), (1, -8)), ((-1, -6), (-1, -8))]
    again = cuts(shape, [(Fraction(1), Fraction(-6)), (Fraction(1), Fraction(-6))])
    assert again == told[:1]


def test_a_cut_joins_a_hole_and_leaves_one_piece() -> None:
    shape = holed(box(-2, -2, 4, 4), 10)
    [cut] = cuts(shape, [(Fraction(-2), Fraction(-2))])
    assert cut == ((-2, -2), (-10, -2))
    [[ring]] = pieces(shape, [cut])
    assert len(ring) == 11 and doubled_area([ring]) == 2 * (400 - 16)


def test_pieces_tile_the_set_and_are_convex_without_a_least_persistence() -> None:
    print(f"seed {SEED}")
    for number in range(SETS):
        name, shape = drawn_set(SEED, number)
        judge = Judge(shape)
        made = cuts(shape, vertices(judge))
        found = pieces(shape, made)
        assert len(made) <= len(judge.outline.wedges), name
        assert all(map(is_convex, found)), name
        area = sum((cross(edge.a, edge.b) for edge in judge.outline.edges), Fraction(0))
        assert sum(map(doubled_area, found), Fraction(0)) == area, name
