"""Pieces cut at notches: which vertices are notches, laws, and shapes whose pieces are known."""

from __future__ import annotations

import math
from fractions import Fraction
from itertools import combinations, pairwise

import minkref
import pytest
from minkref import PolygonSet
from minkref.fuzz.plane.families.catalogue import FAMILIES
from thoroughness import draws

SEED = 850
KINDS = ("random", "holes", "touching", "nested", "star", "comb", "leaning")
L = PolygonSet([(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)])
# A slot of the width 2 and the depth 5 from above.
SLOT = PolygonSet([(0, 0), (6, 0), (6, 6), (4, 6), (4, 1), (2, 1), (2, 6), (0, 6)])
RING = PolygonSet([[(0, 0), (9, 0), (9, 9), (0, 9)], [(2, 3), (2, 5), (6, 5), (6, 3)]])


def shapes(family: str, few: int, many: int) -> list[PolygonSet]:
    pairs = [FAMILIES[family].pair(SEED, 5 * index) for index in range(draws(few, many))]
    sets = [minkref.read_text(text, "json") for pair in pairs for text in (pair.P, pair.Q)]
    return [P for P in sets if P.is_region]


def ends(found: minkref.Decomposition) -> list[tuple[tuple[Fraction, ...], ...]]:
    return [(cut.start, cut.end) for cut in found.cuts]


@pytest.mark.parametrize("family", KINDS)
def test_pieces_tile_the_set_and_are_convex_without_a_persistence(family: str) -> None:
    for P in shapes(family, 3, 30):
        found = minkref.decompose(P)
        pieces = [piece.region for piece in found.pieces]
        assert sum(Fraction(piece.area()) for piece in pieces) == Fraction(P.area())
        assert minkref.unite(pieces) == P
        assert all(piece.is_convex and not piece.slits for piece in found.pieces)
        assert len(pieces) <= len(found.notches) + minkref.offset(P, "1/1000000").components
        if len(pieces) < 12:
            for two in combinations(pieces, 2):
                assert not minkref.intersect(two).rings()


@pytest.mark.parametrize("family", KINDS)
def test_smaller_persistences_have_the_notches_of_larger_ones(family: str) -> None:
    for P in shapes(family, 2, 20):
        for alpha in (0, "1/2", 3):
            found = [
                {notch.vertex for notch in minkref.decompose(P, alpha, step).notches}
                for step in (0, "1/3", 1, 4, "inf")
            ]
            assert all(more <= less for less, more in pairwise(found)) and not found[-1]


def test_without_notches_the_pieces_are_the_components() -> None:
    both = PolygonSet([[[(0, 0), (1, 0), (1, 1), (0, 1)]], [[(1, 1), (2, 1), (2, 2), (1, 2)]]])
    for P, count in ((both, 2), (RING, 1), (SLOT, 1)):
        pieces = minkref.decompose(P, 0, "inf").pieces
        assert len(pieces) == count
        assert minkref.unite([piece.region for piece in pieces]) == P


def test_of_a_corner_the_tie_goes_to_the_least_end() -> None:
    found = minkref.decompose(L)
    assert ends(found) == [((1, 1), (0, 1))]
    assert found.cuts[0].squared_length == 1 and found.skipped == []
    assert [piece.region.area() for piece in found.pieces] == ["2", "1"]


def test_a_slot_is_one_feature_beyond_its_width() -> None:
    """Both corners of the floor at alpha 0; beyond the width 2 one of them, by the least place."""
    whole = minkref.decompose(SLOT)
    assert [notch.vertex for notch in whole.notches] == [(2, 1), (4, 1)]
    assert [bar.death[0] for bar in whole.bars] == [math.inf, 2]
    assert len(whole.pieces) == 3
    for found in (minkref.decompose(SLOT, 3), minkref.decompose(SLOT, 0, 2)):
        assert ends(found) == [((2, 1), (2, 0))]
        assert len(found.pieces) == 2
    assert minkref.decompose(SLOT, 3).notches[0].tie
    left, right = (piece.is_convex for piece in minkref.decompose(SLOT, 3).pieces)
    assert left and not right


def test_over_a_range_only_the_part_of_a_bar_inside_counts() -> None:
    assert len(minkref.decompose(SLOT, 1, 1, 2).notches) == 0
    assert len(minkref.decompose(SLOT, 1, "1/2", 2).notches) == 2
    assert len(minkref.decompose(SLOT, 1, "1/2", 3).notches) == 2
    assert len(minkref.decompose(SLOT, 1, "3/2", 3).notches) == 1


def test_a_cut_from_a_hole_leaves_a_slit() -> None:
    """Bars of the hole's corners end at its width 2, where only the essential one counts longer;
    beyond it the hole has no feature."""
    assert minkref.decompose(RING, 3).notches == ()
    assert len(minkref.decompose(RING, 0, "19/10").pieces) == 4
    found = minkref.decompose(RING, 0, 2)
    assert ends(found) == [((2, 3), (0, 3))]
    (piece,) = found.pieces
    assert piece.region == RING and piece.slits == (((2, 3), (0, 3)),)
    assert (len(piece.bars), piece.endless_bars, piece.longest_bar) == (4, 0, (2, 2))


def test_points_and_segments_have_no_pieces() -> None:
    for thin in (PolygonSet([(1, 2)]), PolygonSet([(0, 0), (3, 1)]), PolygonSet()):
        found = minkref.decompose(thin)
        assert (found.notches, found.cuts, found.pieces) == ((), (), ())


def test_refuses_numbers_below_zero() -> None:
    for numbers in ((-1, 0, None), (0, -1, None), (3, 0, 1)):
        with pytest.raises(minkref.BadInput):
            minkref.decompose(SLOT, *numbers)
